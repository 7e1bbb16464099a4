// Reconstruction filters by filter importance sampling: a path's place in its pixel is drawn from the filter
// itself, so that every sample weighs 1, no sample reaches another pixel's memory, and the film needs no
// weights (Ernst et al. 2006, "Filter Importance Sampling"). Host and device. Left out: filters with
// negative lobes.
#pragma once

#include "engine/kernels/pass.h"
#include "engine/math/inverse_erf.h"
#include "engine/math/warp.h"

namespace glint {
namespace detail {

/// Gaussian with a standard deviation of a third of the support's half, cut off there: density ~ exp(-9/2
/// t^2) for t in [-1, 1]. Its distribution function is erf(3t/sqrt 2) / erf(3/sqrt 2), inverted exactly.
GLINT_HD inline float sampleGaussian(float u) {
    constexpr float kWhole = 0.9973002039f;  // erf(3 / sqrt 2)
    constexpr float kSqrt2Over3 = 0.4714045208f;
    const float v = (2.0f * u - 1.0f) * kWhole;
    return clampf(kSqrt2Over3 * inverseErf(v), -1.0f, 1.0f);
}

/// The 4-term Blackman-Harris window (Harris 1978, "On the Use of Windows", table 1) over t in [-1, 1]:
/// w(t) = a0 + a1 cos(pi t) + a2 cos(2 pi t) + a3 cos(3 pi t). Its integral is inverted by a polynomial in
/// -log(1 - v^2) (our fit, error 8e-4) and one Newton step, which leaves about 1e-5.
GLINT_HD inline float sampleBlackmanHarris(float u) {
    constexpr float a0 = 0.35875f, a1 = 0.48829f, a2 = 0.14128f, a3 = 0.01168f;
    const float v = 2.0f * u - 1.0f;
    const float x = minusLogOneMinusSquare(v) * (2.0f / 17.0f) - 1.0f;
    float p = 0.0457183f;
    p = -0.0375854f + p * x;
    p = -0.0367625f + p * x;
    p = 0.1047493f + p * x;
    p = -0.2445698f + p * x;
    p = 0.2534640f + p * x;
    p = 0.9151056f + p * x;
    const float t = clampf(std::fabs(v) * p, 0.0f, 1.0f);

    const SinCos once = sinCosTurns(0.5f * t);
    const float sinTwice = 2.0f * once.sin * once.cos;
    const float cosTwice = 1.0f - 2.0f * once.sin * once.sin;
    const float sinThrice = sinTwice * once.cos + cosTwice * once.sin;
    const float cosThrice = cosTwice * once.cos - sinTwice * once.sin;
    const float integral =
        a0 * t + kInvPi * (a1 * once.sin + 0.5f * a2 * sinTwice + (1.0f / 3.0f) * a3 * sinThrice);
    const float density = a0 + a1 * once.cos + a2 * cosTwice + a3 * cosThrice;
    // At the very end the window is nearly 0 and rounding would make the step meaningless.
    const float step = (integral - a0 * std::fabs(v)) / maxf(density, 1e-3f);
    return std::copysign(clampf(t - step, 0.0f, 1.0f), v);
}

GLINT_HD inline float sampleFilterAxis(FilterKind filter, float u) {
    switch (filter) {
        case FilterKind::Box:
            return 2.0f * u - 1.0f;
        case FilterKind::Gaussian:
            return sampleGaussian(u);
        case FilterKind::BlackmanHarris:
            return sampleBlackmanHarris(u);
    }
    return 0.0f;
}

}  // namespace detail

/// The offset from a pixel's centre, in pixels, distributed as the separable filter over [-radius, radius]^2.
GLINT_HD inline Vec2 sampleFilter(FilterKind filter, float radius, Vec2 u) {
    return radius * Vec2(detail::sampleFilterAxis(filter, u.x), detail::sampleFilterAxis(filter, u.y));
}

}  // namespace glint
