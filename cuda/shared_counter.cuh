// Counters that all threads of a launch share. On the host, where bodies run one after the other,
// plain memory.
#pragma once

#include <cstdint>

#include "engine/base/host_device.h"

namespace glint::cuda_kernels {

/// Adds 1; answers the number before. uint32_t and uint64_t.
template <class Count>
GLINT_HD Count takeNumber(Count* counter) {
#if GLINT_ON_DEVICE
    if constexpr (sizeof(Count) == 8) {
        return atomicAdd(reinterpret_cast<unsigned long long*>(counter), 1ull);
    } else {
        return atomicAdd(counter, 1u);
    }
#else
    return __atomic_fetch_add(counter, Count{1}, __ATOMIC_RELAXED);
#endif
}

/// Sets *value if it is 0; answers whether it was.
GLINT_HD inline bool claimZero(uint32_t* value, uint32_t mark) {
#if GLINT_ON_DEVICE
    return atomicCAS(value, 0u, mark) == 0u;
#else
    uint32_t expected = 0;
    return __atomic_compare_exchange_n(value, &expected, mark, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED);
#endif
}

}  // namespace glint::cuda_kernels
