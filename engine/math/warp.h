// Maps from the unit square to the sets that path tracing samples, each with its density. Host and device.
//
// Inputs lie in [0, 1); every map is continuous almost everywhere and keeps areas, so stratified points
// stay stratified.
#pragma once

#include "engine/math/rng.h"
#include "engine/math/vec.h"

namespace glint {

struct SinCos {
    float sin, cos;
};

/// Sine and cosine for |angleRad| <= pi/4 by their Taylor series: errors below 3e-8.
GLINT_HD inline SinCos sinCosSmall(float angleRad) {
    const float x2 = angleRad * angleRad;
    const float sine =
        angleRad * (1.0f + x2 * (-1.0f / 6 + x2 * (1.0f / 120 + x2 * (-1.0f / 5040 + x2 * (1.0f / 362880)))));
    const float cosine =
        1.0f +
        x2 * (-0.5f + x2 * (1.0f / 24 + x2 * (-1.0f / 720 + x2 * (1.0f / 40320 - x2 * (1.0f / 3628800)))));
    return {sine, cosine};
}

/// Sine and cosine of 2 pi turns, for turns in [0, 1]: the same on every compiler and device, errors
/// below 1e-7.
GLINT_HD inline SinCos sinCosTurns(float turns) {
    const float quarter = std::floor(turns * 4.0f + 0.5f);
    const SinCos small = sinCosSmall((turns - 0.25f * quarter) * kTwoPi);
    const int quadrant = static_cast<int>(quarter) & 3;
    const float s = (quadrant & 1) != 0 ? small.cos : small.sin;
    const float c = (quadrant & 1) != 0 ? small.sin : small.cos;
    return {(quadrant & 2) != 0 ? -s : s, quadrant == 1 || quadrant == 2 ? -c : c};
}

/// A point of the unit disc, density 1/pi by area (Shirley and Chiu 1997, concentric map).
GLINT_HD inline Vec2 sampleDisc(Vec2 u) {
    const float a = 2.0f * u.x - 1.0f;
    const float b = 2.0f * u.y - 1.0f;
    const bool wide = std::fabs(a) > std::fabs(b);
    const float radius = wide ? a : b;
    const float other = wide ? b : a;
    if (radius == 0.0f) { return Vec2(0.0f); }
    const SinCos angle = sinCosSmall(0.25f * kPi * (other / radius));
    return wide ? Vec2(radius * angle.cos, radius * angle.sin) : Vec2(radius * angle.sin, radius * angle.cos);
}

/// A direction around +z with density cos/pi by solid angle (Malley's method). z is never 0.
GLINT_HD inline Vec3 sampleCosineHemisphere(Vec2 u) {
    const Vec2 d = sampleDisc(u);
    return {d.x, d.y, std::sqrt(maxf(1.0f - d.x * d.x - d.y * d.y, 1e-12f))};
}

/// A direction with density 1/(4 pi).
GLINT_HD inline Vec3 sampleSphere(Vec2 u) {
    const float z = 1.0f - 2.0f * u.x;
    const float r = 2.0f * std::sqrt(u.x * (1.0f - u.x));
    const SinCos phi = sinCosTurns(u.y);
    return {r * phi.cos, r * phi.sin, z};
}

/// A direction within a cone around +z, density 1/(2 pi oneMinusCosMax). Given as 1 - cos of the half angle,
/// since the cosine of a narrow cone has no digits left.
GLINT_HD inline Vec3 sampleCone(Vec2 u, float oneMinusCosMax) {
    const float oneMinusCos = u.x * oneMinusCosMax;
    const float r = safeSqrt(oneMinusCos * (2.0f - oneMinusCos));
    const SinCos phi = sinCosTurns(u.y);
    return {r * phi.cos, r * phi.sin, 1.0f - oneMinusCos};
}

/// Barycentric weights of the second and third corner, uniform by area (Heitz 2019, "A Low-Distortion Map
/// Between Triangle and Square").
GLINT_HD inline Vec2 sampleTriangle(Vec2 u) {
    const bool above = u.y > u.x;
    const float half = 0.5f * (above ? u.x : u.y);
    return above ? Vec2(half, u.y - half) : Vec2(u.x - half, half);
}

/// A point of the regular polygon with corners on the unit circle, the first at `rotationRad` from +x;
/// uniform by area. u.x chooses the side's triangle and is stretched to be used again. sides >= 3.
GLINT_HD inline Vec2 sampleRegularPolygon(Vec2 u, int sides, float rotationRad) {
    const float scaled = u.x * static_cast<float>(sides);
    const float side = minf(std::floor(scaled), static_cast<float>(sides - 1));
    const Vec2 weights = sampleTriangle({minf(scaled - side, kOneMinusEpsilon), u.y});
    const float step = kTwoPi / static_cast<float>(sides);
    const float first = rotationRad + step * side;
    const float second = first + step;
    return weights.x * Vec2(std::cos(first), std::sin(first)) +
           weights.y * Vec2(std::cos(second), std::sin(second));
}

}  // namespace glint
