// Bits of a word. Host and device.
#pragma once

#include <cstdint>

#include "engine/base/host_device.h"

namespace glint {

/// The place of the lowest bit that is set; some is.
GLINT_HD inline uint32_t lowestBit(uint32_t mask) {
#if GLINT_ON_DEVICE
    return static_cast<uint32_t>(__ffs(static_cast<int>(mask)) - 1);
#else
    return static_cast<uint32_t>(__builtin_ctz(mask));
#endif
}
GLINT_HD inline uint32_t lowestBit(uint64_t mask) {
#if GLINT_ON_DEVICE
    return static_cast<uint32_t>(__ffsll(static_cast<long long>(mask)) - 1);
#else
    return static_cast<uint32_t>(__builtin_ctzll(mask));
#endif
}

}  // namespace glint
