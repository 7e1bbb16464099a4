// The natural logarithm without a library call, so that loops around it become vector code. Host and device.
//
// It is for the reconstruction filters. The C library's logarithm does as well wherever one number at a time
// is needed.
#pragma once

#include <bit>
#include <cstdint>

#include "engine/base/host_device.h"

namespace glint {

/// ln x of a positive, normal, finite x, within 2 units in the last place of the larger of the result and
/// 0.1. x = m 2^e with m between the roots of 1/2 and 2; ln m = 2 artanh(s) for s = (m - 1) / (m + 1), by its
/// series: |s| < 0.172.
GLINT_HD inline float naturalLog(float x) {
    constexpr int32_t kRootHalf = 0x3f3504f3;
    const int32_t bits = std::bit_cast<int32_t>(x);
    const int32_t exponent = (bits - kRootHalf) >> 23;
    const float m = std::bit_cast<float>(bits - (exponent << 23));
    const float s = (m - 1.0f) / (m + 1.0f);
    const float s2 = s * s;
    const float series = s2 * (1.0f / 3 + s2 * (1.0f / 5 + s2 * (1.0f / 7 + s2 * (1.0f / 9))));
    return static_cast<float>(exponent) * 0.69314718056f + 2.0f * (s + s * series);
}

}  // namespace glint
