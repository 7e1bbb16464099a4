// Unit vectors in 32 bits. Host and device.
//
// Used where many directions are stored for a short time (photons). The error is at most 6e-5 rad.
#pragma once

#include "engine/math/vec.h"

namespace glint {

/// Octahedral map (Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit Vectors")
/// with `kBits` bits an axis: 16 errs by at most 7e-5 rad, 12 by 1.1e-3. `unit` must be of unit length. The
/// result fits 2 kBits bits.
template <int kBits = 16>
GLINT_HD inline uint32_t packUnitVector(const Vec3& unit) {
    constexpr float kSteps = static_cast<float>((1 << kBits) - 2);  // even, so that 0 is one of them
    const float norm1 = std::fabs(unit.x) + std::fabs(unit.y) + std::fabs(unit.z);
    float u = unit.x / norm1;
    float v = unit.y / norm1;
    if (unit.z < 0.0f) {
        const float foldedU = (1.0f - std::fabs(v)) * std::copysign(1.0f, u);
        v = (1.0f - std::fabs(u)) * std::copysign(1.0f, v);
        u = foldedU;
    }
    const auto ui = static_cast<uint32_t>(std::floor((clampf(u, -1.0f, 1.0f) * 0.5f + 0.5f) * kSteps + 0.5f));
    const auto vi = static_cast<uint32_t>(std::floor((clampf(v, -1.0f, 1.0f) * 0.5f + 0.5f) * kSteps + 0.5f));
    return ui | (vi << kBits);
}

/// The inverse, of unit length. Bits above 2 kBits are ignored.
template <int kBits = 16>
GLINT_HD inline Vec3 unpackUnitVector(uint32_t packed) {
    constexpr float kSteps = static_cast<float>((1 << kBits) - 2);
    constexpr uint32_t kMask = (1u << kBits) - 1u;
    const float u = static_cast<float>(packed & kMask) * (2.0f / kSteps) - 1.0f;
    const float v = static_cast<float>((packed >> kBits) & kMask) * (2.0f / kSteps) - 1.0f;
    Vec3 n(u, v, 1.0f - std::fabs(u) - std::fabs(v));
    if (n.z < 0.0f) {
        n.x = (1.0f - std::fabs(v)) * std::copysign(1.0f, u);
        n.y = (1.0f - std::fabs(u)) * std::copysign(1.0f, v);
    }
    return glm::normalize(n);
}

}  // namespace glint
