// The sphere: radius 1 around the origin. As an emitter it is sampled by the solid angle that it fills; where
// the transform makes an ellipsoid of it, in object space.
//
// Texture coordinates (v runs upwards): u = 0.5 + atan2(n.x, n.z) / 2 pi, v = 0.5 + asin(n.y) / pi, with n
// the object-space normal: north is +y.
#pragma once

#include <numbers>

#include "engine/kernels/features.h"
#include "engine/kernels/hit.h"
#include "engine/kernels/shapes/emitter_point.h"
#include "engine/kernels/shapes/object_point.h"
#include "engine/kernels/shapes/shape_description.h"
#include "engine/kernels/shapes/sphere_seen.h"

namespace glint {

struct SphereShape {
    static constexpr FeatureMask kFeature = kFeatureCurved;
    static constexpr bool kIsFinite = true;
    static constexpr bool kIsSampled = true;

    /// The discriminant is taken from the distance of the ray's line to the centre, and the roots by the
    /// stable quadratic formula: Haines, Günther and Akenine-Möller 2019, "Precision Improvements for
    /// Ray/Sphere Intersection", Ray Tracing Gems, chapter 7.
    template <bool kFrontOnly>
    GLINT_HD static float intersect(const Ray& ray) {
        const Vec3& d = ray.direction;
        const float a = glm::dot(d, d);
        const float b = -glm::dot(ray.origin, d);
        const Vec3 nearest = ray.origin + (b / a) * d;
        const float discriminant = 1.0f - glm::dot(nearest, nearest);
        if (!(discriminant >= 0.0f)) { return kNoHit; }
        // In double: where a sphere touches what it stands on, the gap is all in the last digits of |o|^2.
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

    /// The next p on the unit sphere, which the ray's own arithmetic missed by its rounding.
    template <FeatureMask kMask>
    GLINT_HD static ObjectPoint surface(const Vec3& pRough) {
        ObjectPoint point;
        point.p = normalizeOr(pRough, Vec3(0.0f, 0.0f, 1.0f));
        point.error = errorGamma(6) * absVec(point.p) + Vec3(errorGamma(2));
        point.ng = point.p;
        if constexpr (hasFeature<kMask>(kFeatureTextures)) {
            point.uv = Vec2(0.5f + std::atan2(point.p.x, point.p.z) / kTwoPi,
                            0.5f + std::asin(clampf(point.p.y, -1.0f, 1.0f)) / kPi);
        }
        return point;
    }

    /// At the poles, where all meridians meet, dpdu is zero and dpdv that of the meridian u = 0.5.
    GLINT_HD static Tangents tangents(const Vec3& p) {
        const float ring = std::sqrt(p.x * p.x + p.z * p.z);
        const Vec2 meridian = ring > 0.0f ? Vec2(p.x, p.z) / ring : Vec2(0.0f, 1.0f);
        return {kTwoPi * Vec3(p.z, 0.0f, -p.x), kPi * Vec3(-p.y * meridian.x, ring, -p.y * meridian.y)};
    }

    static Bounds bounds() { return {Vec3(-1.0f), Vec3(1.0f)}; }
    static Bounds worldBounds(const Affine& m) {
        const Vec3 extent = rowLengths(m.linear);
        return {m.translation - extent, m.translation + extent};
    }

    static EmitterData makeEmitter(const Affine& m) {
        EmitterData e;
        e.keepsAngles = isSimilarity(m.linear);
        e.position = m.translation;
        // An ellipsoid only needs a bound: the Frobenius norm is never below the largest half axis.
        const float squares =
            lengthSquared(m.linear[0]) + lengthSquared(m.linear[1]) + lengthSquared(m.linear[2]);
        e.radiusWorld = std::sqrt(e.keepsAngles ? squares / 3.0f : squares);
        return e;
    }

    static void boundEmitter(const EmitterData& e, LightNode* node) {
        node->radius = e.radiusWorld;
        node->intensity *= kPi * square(e.radiusWorld);
    }

    /// An ellipsoid's area by Knud Thomsen's approximation (2004, relative error below 1.1 %), good enough to
    /// choose by: the probability is divided out.
    static float power(const GeometryView& geometry, const EmitterData& e, float exitance) {
        if (e.keepsAngles) { return exitance * 4.0f * kPi * square(e.radiusWorld); }
        constexpr float kPower = 1.6075f;
        const Mat3& linear = geometry.instances[e.instance].objectToWorld.linear;
        const float a = std::pow(glm::length(linear[0]), kPower);
        const float b = std::pow(glm::length(linear[1]), kPower);
        const float c = std::pow(glm::length(linear[2]), kPower);
        return exitance * (4.0f * kPi * std::pow((a * b + a * c + b * c) / 3.0f, 1.0f / kPower));
    }

    GLINT_HD static EmitterPoint sampleArea(const GeometryView& geometry, const EmitterData& e,
                                            const Vec2& u) {
        const Vec3 onSphere = sampleSphere(u);
        if (e.keepsAngles) {
            return spherePoint(e, onSphere, 1.0f / (2.0f * kTwoPi * square(e.radiusWorld)));
        }
        const InstanceData& instance = geometry.instances[e.instance];
        // World area over the unit sphere's: |det M| |M^-T n|.
        const float stretch = std::fabs(instance.objectToWorld.determinant()) *
                              glm::length(transformNormal(instance.worldToObject.linear, onSphere));
        EmitterPoint s = ellipsoidPoint(instance, onSphere);
        s.pdf = 1.0f / (2.0f * kTwoPi * stretch);
        return s;
    }

    GLINT_HD static EmitterPoint sampleFrom(const GeometryView& geometry, const EmitterData& e,
                                            const Vec3& from, const Vec2& u) {
        if (e.keepsAngles) {
            const SphereDirection direction = sampleSphereDirection(asSeen(e, from), u);
            if (!(direction.pdfSolidAngle > 0.0f)) { return {}; }
            return spherePoint(e, direction.normal, direction.pdfSolidAngle);
        }
        const InstanceData& instance = geometry.instances[e.instance];
        const SphereDirection direction = sampleSphereDirection(asSeen(instance, from), u);
        if (!(direction.pdfSolidAngle > 0.0f)) { return {}; }
        EmitterPoint s = ellipsoidPoint(instance, direction.normal);
        s.pdf = direction.pdfSolidAngle * objectSolidAnglePerWorld(instance.worldToObject, s.p - from);
        return s;
    }

    GLINT_HD static float pdfFrom(const GeometryView& geometry, const EmitterData& e, const Vec3& from,
                                  const Vec3& p) {
        if (e.keepsAngles) { return pdfSphereDirection(asSeen(e, from)); }
        const InstanceData& instance = geometry.instances[e.instance];
        return pdfSphereDirection(asSeen(instance, from)) *
               objectSolidAnglePerWorld(instance.worldToObject, p - from);
    }

    static ShapeDescription description() {
        return {.name = "sphere",
                .keyList = {{{"center"}, {"radius", PlacementForm::Length, Vec3(1.0f)}}},
                .transform =
                    [](const Placement& values, Affine* placed) {
                        *placed = {Mat3(values[1].x), values[0]};
                        return true;
                    },
                .valuesOf = centerAndRadius,
                .grid = {.columns = 256,
                         .rows = 128,
                         .wrapsColumns = true,
                         .poles = true,
                         .at = [](double u, double v) {
                             const double around = (2.0 * u - 1.0) * std::numbers::pi;
                             const double up = (v - 0.5) * std::numbers::pi;
                             return glm::dvec3(std::sin(around) * std::cos(up), std::sin(up),
                                               std::cos(around) * std::cos(up));
                         }}};
    }

  private:
    /// Those of a sphere that is placed by nothing else.
    static bool centerAndRadius(const Affine& placed, Placement* values) {
        const float radius = placed.linear[0].x;
        if (!(radius > 0.0f) || !sameBits(placed.linear, Mat3(radius))) { return false; }
        *values = {placed.translation, Vec3(radius)};
        return true;
    }

    GLINT_HD static SphereView asSeen(const EmitterData& e, const Vec3& from) {
        return viewSphere(e.position, e.radiusWorld, from, maxComponent(absVec(from)));
    }

    /// In object space.
    GLINT_HD static SphereView asSeen(const InstanceData& instance, const Vec3& from) {
        const Affine& m = instance.worldToObject;
        const Vec3 magnitude = absMultiply(m.linear, absVec(from));
        return viewSphere(Vec3(0.0f), 1.0f, m.point(from), maxComponent(magnitude + absVec(m.translation)));
    }

    /// The point of the sphere with the given unit normal.
    GLINT_HD static EmitterPoint spherePoint(const EmitterData& e, const Vec3& normal, float pdf) {
        EmitterPoint s;
        s.normal = normal;
        s.p = e.position + e.radiusWorld * normal;
        s.pError = errorGamma(6) * (absVec(e.position) + e.radiusWorld * absVec(normal));
        s.pdf = pdf;
        return s;
    }

    /// The image of a point of the unit sphere.
    GLINT_HD static EmitterPoint ellipsoidPoint(const InstanceData& instance, const Vec3& onSphere) {
        const Affine& m = instance.objectToWorld;
        EmitterPoint s;
        s.p = m.point(onSphere);
        s.pError = errorGamma(8) *
                   (absVec(m.linear[0]) + absVec(m.linear[1]) + absVec(m.linear[2]) + absVec(m.translation));
        s.normal = glm::normalize(transformNormal(instance.worldToObject.linear, onSphere));
        return s;
    }

    /// The transform keeps angles: a sphere stays a sphere.
    static bool isSimilarity(const Mat3& m) {
        constexpr double kTolerance = 1e-5;
        const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
        const double size = glm::dot(x, x);
        return std::abs(glm::dot(y, y) - size) <= kTolerance * size &&
               std::abs(glm::dot(z, z) - size) <= kTolerance * size &&
               std::abs(glm::dot(x, y)) <= kTolerance * size &&
               std::abs(glm::dot(y, z)) <= kTolerance * size && std::abs(glm::dot(z, x)) <= kTolerance * size;
    }
};

}  // namespace glint
