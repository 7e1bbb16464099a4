// Points on emissive shapes as seen from a place, and the density of choosing them, per solid angle at
// that place.
//
// Called by light_sampling.h only. Which of two ways samples a shape depends on the shape and on `from`
// alone, so that the density of a direction found otherwise (MIS) is the one that sampling would have had.
#pragma once

#include "engine/kernels/geometry_view.h"
#include "engine/kernels/light_view.h"
#include "engine/kernels/spherical_polygons.h"
#include "engine/math/frame.h"
#include "engine/math/warp.h"

namespace glint {

/// A point on an emitter. pdfSolidAngle 0: none was found.
struct EmitterPoint {
    Vec3 p{0.0f};
    Vec3 pError{0.0f};  ///< bound of the absolute rounding error of p in each coordinate
    Vec3 normal{0.0f};  ///< unit, front side
    float pdfSolidAngle = 0.0f;
};

/// Below this solid angle (steradians; area * cos / distance^2 of the centre) a flat shape is sampled by
/// area: the density hardly varies over it then, and the sum of angles that gives the exact solid angle would
/// lose its digits.
constexpr float kSmallSolidAngle = 0.1f;

/// Density per area into density per solid angle at `from`: pdfArea * distance^2 / |cos| (PBR book,
/// section 4.2.3). 0 where the point is seen exactly edge on, or lies at `from`.
GLINT_HD inline float areaToSolidAngle(float pdfArea, const Vec3& from, const Vec3& p, const Vec3& normal) {
    const Vec3 d = p - from;
    const float distance2 = lengthSquared(d);
    const float cosTimesDistance = absDot(d, normal);
    if (!(cosTimesDistance > 0.0f) || !(distance2 > 0.0f)) { return 0.0f; }
    const float pdf = pdfArea * distance2 * (std::sqrt(distance2) / cosTimesDistance);
    return std::isfinite(pdf) ? pdf : 0.0f;
}

/// A point given by two coordinates on a flat emitter.
GLINT_HD inline EmitterPoint flatEmitterPoint(const EmitterData& e, float a, float b) {
    EmitterPoint s;
    s.p = e.position + a * e.axisU + b * e.axisV;
    s.pError = errorGamma(5) *
               (absVec(e.position) + std::fabs(a) * absVec(e.axisU) + std::fabs(b) * absVec(e.axisV));
    s.normal = e.direction;
    return s;
}

GLINT_HD inline EmitterPoint sampleFlatByArea(const EmitterData& e, const Vec3& from, float a, float b) {
    EmitterPoint s = flatEmitterPoint(e, a, b);
    s.pdfSolidAngle = areaToSolidAngle(1.0f / e.area, from, s.p, s.normal);
    return s;
}

/// area * cos / distance^2 towards `center` is at least kSmallSolidAngle, or `from` is so near that it
/// says nothing.
GLINT_HD inline bool looksLarge(const EmitterData& e, const Vec3& center, const Vec3& from) {
    const Vec3 d = center - from;
    const float distance2 = lengthSquared(d);
    return e.area * absDot(d, e.direction) > kSmallSolidAngle * distance2 * std::sqrt(distance2);
}

// ---- Rectangle ----

GLINT_HD inline SphericalRectangle sphericalRectangleOf(const EmitterData& e, const Vec3& from) {
    return makeSphericalRectangle(e.position - e.axisU - e.axisV, 2.0f * e.axisU, 2.0f * e.axisV, e.direction,
                                  from);
}

GLINT_HD inline EmitterPoint sampleRectangle(const EmitterData& e, const Vec3& from, const Vec2& u) {
    if (looksLarge(e, e.position, from)) {
        const SphericalRectangle q = sphericalRectangleOf(e, from);
        if (q.solidAngle > kSmallSolidAngle * 0.5f) {
            const Vec2 ab = sampleSphericalRectangle(q, u);
            EmitterPoint s = flatEmitterPoint(e, 2.0f * ab.x - 1.0f, 2.0f * ab.y - 1.0f);
            s.pdfSolidAngle = 1.0f / q.solidAngle;
            return s;
        }
    }
    return sampleFlatByArea(e, from, 2.0f * u.x - 1.0f, 2.0f * u.y - 1.0f);
}

GLINT_HD inline float pdfRectangle(const EmitterData& e, const Vec3& from, const Vec3& p) {
    if (looksLarge(e, e.position, from)) {
        const float solidAngle = sphericalRectangleOf(e, from).solidAngle;
        if (solidAngle > kSmallSolidAngle * 0.5f) { return 1.0f / solidAngle; }
    }
    return areaToSolidAngle(1.0f / e.area, from, p, e.direction);
}

// ---- Triangle ----

GLINT_HD inline SphericalTriangle sphericalTriangleOf(const EmitterData& e, const Vec3& from) {
    const Vec3 a = e.position - from;
    return makeSphericalTriangle(a, a + e.axisU, a + e.axisV);
}

GLINT_HD inline Vec3 triangleCenter(const EmitterData& e) {
    return e.position + (1.0f / 3.0f) * (e.axisU + e.axisV);
}

GLINT_HD inline EmitterPoint sampleTriangleEmitter(const EmitterData& e, const Vec3& from, const Vec2& u) {
    if (looksLarge(e, triangleCenter(e), from)) {
        const SphericalTriangle q = sphericalTriangleOf(e, from);
        if (q.solidAngle > kSmallSolidAngle * 0.5f) {
            const Vec3 wi = sampleSphericalTriangle(q, u);
            Vec2 ab;
            if (!intersectTrianglePlane(e.position - from, e.axisU, e.axisV, wi, &ab)) { return {}; }
            EmitterPoint s = flatEmitterPoint(e, ab.x, ab.y);
            s.pdfSolidAngle = 1.0f / q.solidAngle;
            return s;
        }
    }
    const Vec2 ab = sampleTriangle(u);
    return sampleFlatByArea(e, from, ab.x, ab.y);
}

GLINT_HD inline float pdfTriangleEmitter(const EmitterData& e, const Vec3& from, const Vec3& p) {
    if (looksLarge(e, triangleCenter(e), from)) {
        const float solidAngle = sphericalTriangleOf(e, from).solidAngle;
        if (solidAngle > kSmallSolidAngle * 0.5f) { return 1.0f / solidAngle; }
    }
    return areaToSolidAngle(1.0f / e.area, from, p, e.direction);
}

// ---- Sphere ----

/// Places this near to a sphere's surface, relative to the numbers they were computed from, lie on its inner
/// side as likely as not. Light sampling leaves them alone: the sphere covers half of what they see, and the
/// BSDF's own directions find it.
constexpr float kSphereSurfaceBand = 2e-6f;

/// A sphere seen from a place.
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

/// A point of a sphere, as its unit normal there.
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

GLINT_HD inline SphereView viewSphereEmitter(const EmitterData& e, const Vec3& from) {
    return viewSphere(e.position, e.radiusWorld, from, maxComponent(absVec(from)));
}

/// The point of the sphere with the given unit normal.
GLINT_HD inline EmitterPoint spherePoint(const EmitterData& e, const Vec3& normal) {
    EmitterPoint s;
    s.normal = normal;
    s.p = e.position + e.radiusWorld * normal;
    s.pError = errorGamma(6) * (absVec(e.position) + e.radiusWorld * absVec(normal));
    return s;
}

GLINT_HD inline EmitterPoint sampleSphereEmitter(const EmitterData& e, const Vec3& from, const Vec2& u) {
    const SphereDirection direction = sampleSphereDirection(viewSphereEmitter(e, from), u);
    if (!(direction.pdfSolidAngle > 0.0f)) { return {}; }
    EmitterPoint s = spherePoint(e, direction.normal);
    s.pdfSolidAngle = direction.pdfSolidAngle;
    return s;
}

// ---- Ellipsoid: the image of the unit sphere under an affine map, sampled in its object space ----

/// Solid angle in object space over solid angle in world space around the direction d (of any length):
/// |det A| |d|^3 / |A d|^3 with A the world-to-object map.
GLINT_HD inline float objectSolidAnglePerWorld(const Affine& worldToObject, const Vec3& d) {
    const float ratio = std::sqrt(lengthSquared(d) / lengthSquared(worldToObject.vector(d)));
    return std::fabs(worldToObject.determinant()) * ratio * ratio * ratio;
}

GLINT_HD inline SphereView viewEllipsoid(const InstanceData& instance, const Vec3& from) {
    const Affine& m = instance.worldToObject;
    const Vec3 a = absVec(from);
    const Vec3 magnitude = absVec(m.linear[0]) * a.x + absVec(m.linear[1]) * a.y + absVec(m.linear[2]) * a.z;
    return viewSphere(Vec3(0.0f), 1.0f, m.point(from), maxComponent(magnitude + absVec(m.translation)));
}

/// The image of a point of the unit sphere.
GLINT_HD inline EmitterPoint ellipsoidPoint(const InstanceData& instance, const Vec3& onSphere) {
    const Affine& m = instance.objectToWorld;
    EmitterPoint s;
    s.p = m.point(onSphere);
    s.pError = errorGamma(8) *
               (absVec(m.linear[0]) + absVec(m.linear[1]) + absVec(m.linear[2]) + absVec(m.translation));
    s.normal = glm::normalize(transformNormal(instance.worldToObject.linear, onSphere));
    return s;
}

GLINT_HD inline EmitterPoint sampleEllipsoid(const InstanceData& instance, const Vec3& from, const Vec2& u) {
    const SphereDirection direction = sampleSphereDirection(viewEllipsoid(instance, from), u);
    if (!(direction.pdfSolidAngle > 0.0f)) { return {}; }
    EmitterPoint s = ellipsoidPoint(instance, direction.normal);
    s.pdfSolidAngle = direction.pdfSolidAngle * objectSolidAnglePerWorld(instance.worldToObject, s.p - from);
    return s;
}

GLINT_HD inline float pdfEllipsoid(const InstanceData& instance, const Vec3& from, const Vec3& p) {
    return pdfSphereDirection(viewEllipsoid(instance, from)) *
           objectSolidAnglePerWorld(instance.worldToObject, p - from);
}

// ---- Disc: the image of the unit disc ----

GLINT_HD inline EmitterPoint sampleDiscEmitter(const EmitterData& e, const Vec3& from, const Vec2& u) {
    const Vec2 d = sampleDisc(u);
    return sampleFlatByArea(e, from, d.x, d.y);
}

}  // namespace glint
