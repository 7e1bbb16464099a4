// The modified Phong model: a diffuse surface and a power of the cosine to the mirror direction. Host
// and device.
//
// Lafortune and Willems 1994, "Using the Modified Phong Reflectance Model for Physically Based Rendering":
//     f = color / pi + specular (n + 2) / (2 pi) cos^n,
// which reflects the specular reflectance head on and less at other angles.
#pragma once

#include "engine/kernels/bsdf/highlight.h"

namespace glint {

/// highlight.h says what the members are.
struct PhongLobe {
    GLINT_HD PhongLobe(const ShadingInputs& in, const MaterialData&, const Vec3& wo)
        : mirror_(detail::mirrored(wo)), exponent_(in.exponent) {}

    /// Of Beckmann's facets whose highlight is as wide head on.
    GLINT_HD float alpha() const { return minf(std::sqrt(2.0f / (exponent_ + 2.0f)), 1.0f); }

    GLINT_HD float reflection(const Vec3& wi, float) const {
        return (exponent_ + 2.0f) * (0.5f * kInvPi) * power(wi) * wi.z;
    }

    GLINT_HD float pdf(const Vec3& wi) const { return (exponent_ + 1.0f) * (0.5f * kInvPi) * power(wi); }

    GLINT_HD Vec3 sample(Vec2 u) const {
        const float oneMinusCos = -std::expm1(std::log(1.0f - u.x) / (exponent_ + 1.0f));
        const float sine = safeSqrt(oneMinusCos * (2.0f - oneMinusCos));
        const SinCos phi = sinCosTurns(u.y);
        return glm::normalize(
            Frame::fromNormal(mirror_).toWorld(Vec3(sine * phi.cos, sine * phi.sin, 1.0f - oneMinusCos)));
    }

  private:
    /// cos^n, by the chord between both directions: near 1 the cosine has no digits left.
    GLINT_HD float power(const Vec3& wi) const {
        const float halfChord2 = 0.5f * lengthSquared(wi - mirror_);
        return halfChord2 < 1.0f ? std::exp(exponent_ * std::log1p(-halfChord2)) : 0.0f;
    }

    Vec3 mirror_;
    float exponent_;
};

template <FeatureMask kMask>
struct PhongModel : HighlightModel<kMask, PhongLobe> {};

}  // namespace glint
