// Directions as places in a square, and back, so that equal areas are equal solid angles: Clarberg 2008,
// "Fast Equal-Area Mapping of the (Hemi)Sphere using SIMD". Host and device.
#pragma once

#include "engine/math/vec.h"

namespace glint {

/// Where a unit direction lies in the square [0, 1]^2: +z in its middle, +x and +y at the middles of the
/// edges of greatest x and y, -z in its corners.
GLINT_HD inline Vec2 equalAreaPoint(const Vec3& direction) {
    const Vec3 a = absVec(direction);
    const float r = safeSqrt(1.0f - a.z);
    const float quarter = a.x == 0.0f && a.y == 0.0f ? 0.0f : std::atan2(a.y, a.x) / (0.5f * kPi);
    Vec2 p(r * (1.0f - quarter), r * quarter);
    if (direction.z < 0.0f) { p = Vec2(1.0f - p.y, 1.0f - p.x); }
    return 0.5f * Vec2(std::copysign(p.x, direction.x), std::copysign(p.y, direction.y)) + Vec2(0.5f);
}

/// The other way.
GLINT_HD inline Vec3 equalAreaDirection(const Vec2& point) {
    const Vec2 p = 2.0f * point - Vec2(1.0f);
    const Vec2 a(std::fabs(p.x), std::fabs(p.y));
    const float inside = 1.0f - (a.x + a.y), r = 1.0f - std::fabs(inside);
    const float phi = 0.25f * kPi * (r == 0.0f ? 1.0f : (a.y - a.x) / r + 1.0f);
    const float ring = r * safeSqrt(2.0f - r * r);
    return {std::copysign(std::cos(phi), p.x) * ring, std::copysign(std::sin(phi), p.y) * ring,
            std::copysign(1.0f - r * r, inside)};
}

}  // namespace glint
