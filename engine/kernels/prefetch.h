// Asks for memory before it is needed. Host only: a GPU hides its misses by other rays.
#pragma once

#include <cstddef>

#include "engine/base/host_device.h"

namespace glint {

constexpr size_t kCacheLineBytes = 64;

/// Fetches an object that is aligned to cache lines, or lies within one. Its address need not be valid.
template <class Object>
GLINT_HD inline void prefetch([[maybe_unused]] const Object* object) {
#if !GLINT_ON_DEVICE
    const auto* bytes = reinterpret_cast<const char*>(object);
    for (size_t line = 0; line < sizeof(Object); line += kCacheLineBytes) {
        __builtin_prefetch(bytes + line);
    }
#endif
}

}  // namespace glint
