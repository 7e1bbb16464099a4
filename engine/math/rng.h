// Hashes and bits that random numbers are made of. Host and device, without state.
//
// The samplers (kernels/sampler.h) build on these; nothing else should call them for random numbers of
// its own.
#pragma once

#include <cstdint>

#include "engine/base/host_device.h"

namespace glint {

/// The largest float below 1: a bound for uniform numbers that were scaled or stretched.
constexpr float kOneMinusEpsilon = 0x1.fffffep-1f;

/// A bijection of 64 bits in which every input bit changes about half of the output (Stafford 2011, "Better
/// bit mixing", variant 13, as used by SplitMix64).
GLINT_HD inline uint64_t mixBits(uint64_t v) {
    v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9ull;
    v = (v ^ (v >> 27)) * 0x94d049bb133111ebull;
    return v ^ (v >> 31);
}

/// A hash of a key and a counter; different counters under one key give independent-looking values.
GLINT_HD inline uint64_t hashCounter(uint64_t key, uint64_t counter) {
    return mixBits(key + counter * 0x9e3779b97f4a7c15ull);
}

/// The upper 24 bits as a float in [0, 1): never 1, which would give some sampling routines a density of 0.
GLINT_HD inline float uniformFloat(uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

/// Bit 63 becomes bit 0, and so on.
GLINT_HD inline uint64_t reverseBits64(uint64_t v) {
#if GLINT_ON_DEVICE
    return __brevll(v);
#else
    v = __builtin_bswap64(v);
    v = ((v >> 4) & 0x0f0f0f0f0f0f0f0full) | ((v & 0x0f0f0f0f0f0f0f0full) << 4);
    v = ((v >> 2) & 0x3333333333333333ull) | ((v & 0x3333333333333333ull) << 2);
    return ((v >> 1) & 0x5555555555555555ull) | ((v & 0x5555555555555555ull) << 1);
#endif
}

/// Bit 31 becomes bit 0, and so on.
GLINT_HD inline uint32_t reverseBits32(uint32_t v) {
#if GLINT_ON_DEVICE
    return __brev(v);
#else
    v = __builtin_bswap32(v);
    v = ((v >> 4) & 0x0f0f0f0fu) | ((v & 0x0f0f0f0fu) << 4);
    v = ((v >> 2) & 0x33333333u) | ((v & 0x33333333u) << 2);
    return ((v >> 1) & 0x55555555u) | ((v & 0x55555555u) << 1);
#endif
}

}  // namespace glint
