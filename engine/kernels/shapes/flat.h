// What flat shapes have in common: the plane z = 0 with its normal +z in object space, and emitters that are
// given by two axes.
#pragma once

#include <glm/ext/matrix_double3x3.hpp>
#include <glm/matrix.hpp>

#include "engine/kernels/hit.h"
#include "engine/kernels/shapes/emitter_point.h"
#include "engine/kernels/shapes/object_point.h"

namespace glint {

/// Distance to z = 0. kFrontOnly: met from above only.
template <bool kFrontOnly>
GLINT_HD inline float intersectFlat(const Ray& ray) {
    if (kFrontOnly && !(ray.direction.z < 0.0f)) { return kNoHit; }
    const float t = -ray.origin.z / ray.direction.z;
    return t > ray.tMin && t < ray.tMax ? t : kNoHit;  // fails for the NaN of a ray within the plane
}

/// A point of z = 0: exactly on the surface whatever its x and y are.
GLINT_HD inline ObjectPoint flatPoint(const Vec3& pRough, const Vec2& uv) {
    ObjectPoint point;
    point.p = Vec3(pRough.x, pRough.y, 0.0f);
    point.ng = Vec3(0.0f, 0.0f, 1.0f);
    point.uv = uv;
    return point;
}

/// Texture coordinates from 0 to 1 over x and y from -1 to 1, and what they make of the tangents.
GLINT_HD inline Vec2 unitSquareUv(const Vec3& p) { return 0.5f * Vec2(p) + Vec2(0.5f); }
GLINT_HD inline Tangents unitSquareTangents() { return {Vec3(2.0f, 0.0f, 0.0f), Vec3(0.0f, 2.0f, 0.0f)}; }

/// The box of the square with x and y in [-1, 1].
GLINT_HD inline Bounds unitSquareBounds() { return {Vec3(-1.0f, -1.0f, 0.0f), Vec3(1.0f, 1.0f, 0.0f)}; }

/// Below this solid angle (steradians; area * cos / distance^2 of the centre) a flat emitter is sampled by
/// area: the density hardly varies over it then, and the sum of angles that gives the exact solid angle would
/// lose its digits.
constexpr float kSmallSolidAngle = 0.1f;

/// area * cos / distance^2 towards `center` is at least kSmallSolidAngle, or `from` is so near that it
/// says nothing.
GLINT_HD inline bool looksLarge(const EmitterData& e, const Vec3& center, const Vec3& from) {
    const Vec3 d = center - from;
    const float distance2 = lengthSquared(d);
    return e.area * absDot(d, e.direction) > kSmallSolidAngle * distance2 * std::sqrt(distance2);
}

/// The point given by two coordinates along the axes of a flat emitter, with its density.
GLINT_HD inline EmitterPoint flatEmitterPoint(const EmitterData& e, float a, float b, float pdf) {
    EmitterPoint s;
    s.p = e.position + a * e.axisU + b * e.axisV;
    s.pError = errorGamma(5) *
               (absVec(e.position) + std::fabs(a) * absVec(e.axisU) + std::fabs(b) * absVec(e.axisV));
    s.normal = e.direction;
    s.pdf = pdf;
    return s;
}

/// A point that was chosen uniformly by area, with its density per solid angle at `from`.
GLINT_HD inline EmitterPoint flatEmitterPointFrom(const EmitterData& e, const Vec3& from, float a, float b) {
    EmitterPoint s = flatEmitterPoint(e, a, b, 0.0f);
    s.pdf = areaToSolidAngle(1.0f / e.area, from, s.p, s.normal);
    return s;
}

/// Twice the area of the triangle (or the area of the parallelogram) that two edges span.
inline float spannedArea(const Vec3& a, const Vec3& b) {
    return static_cast<float>(glm::length(glm::cross(glm::dvec3(a), glm::dvec3(b))));
}

/// The image of z = 0 with its unit axes; the area is still that of the parallelogram which they span.
inline EmitterData makeFlatEmitter(const Affine& objectToWorld) {
    EmitterData e;
    e.position = objectToWorld.translation;
    e.axisU = objectToWorld.linear[0];
    e.axisV = objectToWorld.linear[1];
    const glm::dmat3 inverseTranspose = glm::transpose(glm::inverse(glm::dmat3(objectToWorld.linear)));
    e.direction = Vec3(glm::normalize(inverseTranspose * glm::dvec3(0.0, 0.0, 1.0)));
    e.area = spannedArea(e.axisU, e.axisV);
    return e;
}

/// Light leaves a flat emitter around its normal, in proportion to its area.
inline void boundFlatEmitter(const EmitterData& e, float radius, LightNode* node) {
    node->axis = e.direction;
    node->cosNormals = 1.0f;
    node->intensity *= e.area;
    node->radius = radius;
}

}  // namespace glint
