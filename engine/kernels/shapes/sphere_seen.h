// A sphere seen from a place: the cone that it fills, and directions uniform inside it.
#pragma once

#include "engine/math/frame.h"
#include "engine/math/transform.h"
#include "engine/math/warp.h"

namespace glint {

/// Places this near to a sphere's surface, relative to the numbers they were computed from, lie on its inner
/// side as likely as not. Light sampling leaves them alone: the sphere covers half of what they see, and the
/// BSDF's own directions find it.
constexpr float kSphereSurfaceBand = 2e-6f;

struct SphereView {
    Vec3 toCenter;
    float radius;
    float distance;
    /// of the cone around it, accurate for far and near spheres alike; 2: seen all around; 0: from the
    /// surface itself, and never sampled
    float oneMinusCosMax;
};

/// `magnitude`: the size of the numbers that `from` was computed from, which its rounding error goes by.
GLINT_HD inline SphereView viewSphere(const Vec3& center, float radius, const Vec3& from, float magnitude) {
    SphereView v{center - from, radius, 0.0f, 2.0f};
    v.distance = std::sqrt(lengthSquared(v.toCenter));
    const float outside = v.distance - radius;
    const float band = kSphereSurfaceBand * (radius + magnitude);
    if (outside < -band) { return v; }
    if (!(outside > band)) {
        v.oneMinusCosMax = 0.0f;
        return v;
    }
    const float cosMax = safeSqrt(outside * (v.distance + radius)) / v.distance;
    v.oneMinusCosMax = square(radius / v.distance) / (1.0f + cosMax);
    return v;
}

GLINT_HD inline float pdfSphereDirection(const SphereView& v) {
    return v.oneMinusCosMax > 0.0f ? 1.0f / (kTwoPi * v.oneMinusCosMax) : 0.0f;
}

/// A point of a sphere, as its unit normal there. pdfSolidAngle 0: none was found.
struct SphereDirection {
    Vec3 normal{0.0f};
    float pdfSolidAngle = 0.0f;
};

/// Uniform over the directions in which the sphere is seen: all from inside, the cone around it from outside.
GLINT_HD inline SphereDirection sampleSphereDirection(const SphereView& v, const Vec2& u) {
    const float pdf = pdfSphereDirection(v);
    if (!(pdf > 0.0f)) { return {}; }
    if (v.oneMinusCosMax >= 2.0f) {
        const Vec3 w = sampleSphere(u);
        const float along = glm::dot(w, v.toCenter);
        const float t = along + safeSqrt(square(v.radius) - square(v.distance) + along * along);
        return {glm::normalize(t * w - v.toCenter), pdf};
    }
    const float oneMinusCos = u.x * v.oneMinusCosMax;
    const float sin2 = oneMinusCos * (2.0f - oneMinusCos);
    const SinCos phi = sinCosTurns(u.y);
    // The point in that direction, in a frame whose n axis runs from the centre to the place.
    const float cosine = 1.0f - oneMinusCos;
    const float halfChord = safeSqrt(square(v.radius) - square(v.distance) * sin2);
    const float across = (v.distance * cosine - halfChord) * safeSqrt(sin2);
    // d - along * cos without the difference, in which small spheres far away would lose all digits.
    const float towards = v.distance * sin2 + cosine * halfChord;
    const Frame frame = Frame::fromNormal(v.toCenter * (-1.0f / v.distance));
    return {glm::normalize(frame.toWorld({across * phi.cos, across * phi.sin, towards})), pdf};
}

/// Solid angle in object space over solid angle in world space around the direction d (of any length):
/// |det A| |d|^3 / |A d|^3 with A the world-to-object map.
GLINT_HD inline float objectSolidAnglePerWorld(const Affine& worldToObject, const Vec3& d) {
    const float ratio = std::sqrt(lengthSquared(d) / lengthSquared(worldToObject.vector(d)));
    return std::fabs(worldToObject.determinant()) * ratio * ratio * ratio;
}

}  // namespace glint
