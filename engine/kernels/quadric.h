// Rays against the analytic shapes in their canonical object space: sphere, plane, rectangle, disc.
//
// Called by intersect.h with a ray in object space (its direction not of unit length). Each answers the
// nearest t in (tMin, tMax), or a negative number for none.
#pragma once

#include "engine/math/ray.h"

namespace glint {

constexpr float kNoHit = -1.0f;

/// Radius 1 around the origin. The discriminant is taken from the distance of the ray's line to the centre,
/// and the roots by the stable quadratic formula: Haines, Günther and Akenine-Möller 2019, "Precision
/// Improvements for Ray/Sphere Intersection", Ray Tracing Gems, chapter 7.
template <bool kFrontOnly>
GLINT_HD inline float intersectUnitSphere(const Ray& ray) {
    const Vec3& d = ray.direction;
    const float a = glm::dot(d, d);
    const float b = -glm::dot(ray.origin, d);
    const Vec3 nearest = ray.origin + (b / a) * d;
    const float discriminant = 1.0f - glm::dot(nearest, nearest);
    if (!(discriminant >= 0.0f)) { return kNoHit; }
    // In double: where a ball touches what it stands on, the gap is all in the last digits of |o|^2.
    const auto x = static_cast<double>(ray.origin.x);
    const auto y = static_cast<double>(ray.origin.y);
    const auto z = static_cast<double>(ray.origin.z);
    const float c = static_cast<float>(x * x + y * y + z * z - 1.0);
    const float q = b + std::copysign(std::sqrt(a * discriminant), b);
    const float rootA = c / q;
    const float rootB = q / a;
    const float t0 = b >= 0.0f ? rootA : rootB;  // the nearer root
    const float t1 = b >= 0.0f ? rootB : rootA;
    if (t0 > ray.tMin && t0 < ray.tMax) { return t0; }
    if (!kFrontOnly && t1 > ray.tMin && t1 < ray.tMax) { return t1; }
    return kNoHit;
}

/// z = 0, normal +z, infinite.
template <bool kFrontOnly>
GLINT_HD inline float intersectPlane(const Ray& ray) {
    if (kFrontOnly && !(ray.direction.z < 0.0f)) { return kNoHit; }
    const float t = -ray.origin.z / ray.direction.z;
    return t > ray.tMin && t < ray.tMax ? t : kNoHit;  // fails for the NaN of a ray within the plane
}

/// z = 0, x and y in [-1, 1].
template <bool kFrontOnly>
GLINT_HD inline float intersectRectangle(const Ray& ray) {
    const float t = intersectPlane<kFrontOnly>(ray);
    const float x = ray.origin.x + t * ray.direction.x;
    const float y = ray.origin.y + t * ray.direction.y;
    return std::fabs(x) <= 1.0f && std::fabs(y) <= 1.0f ? t : kNoHit;
}

/// z = 0, radius 1.
template <bool kFrontOnly>
GLINT_HD inline float intersectDisc(const Ray& ray) {
    const float t = intersectPlane<kFrontOnly>(ray);
    const float x = ray.origin.x + t * ray.direction.x;
    const float y = ray.origin.y + t * ray.direction.y;
    return x * x + y * y <= 1.0f ? t : kNoHit;
}

}  // namespace glint
