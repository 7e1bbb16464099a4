// A borrowed array: pointer and count, plain data, the same on host and device.
//
// Kernels see all scene data through views. A view never owns and is never null-checked by its reader: an
// empty one has count 0. Index bounds are the caller's contract.
#pragma once

#include <cstdint>

#include "engine/base/host_device.h"

namespace glint {

template <class T>
struct View {
    const T* data = nullptr;
    uint32_t count = 0;

    GLINT_HD const T& operator[](uint32_t index) const { return data[index]; }
    GLINT_HD bool empty() const { return count == 0; }
};

/// A view of any contiguous container with data() and size(); the container must outlive it.
template <class Container>
auto viewOf(const Container& container) {
    using Element = typename Container::value_type;
    return View<Element>{container.data(), static_cast<uint32_t>(container.size())};
}

}  // namespace glint
