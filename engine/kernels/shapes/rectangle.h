// The rectangle: z = 0, x and y in [-1, 1], normal +z. Where the transform keeps its right angles it is
// sampled by the solid angle that it fills, otherwise, as a parallelogram, by area.
//
// Texture coordinates: (x + 1) / 2, (y + 1) / 2.
#pragma once

#include "engine/kernels/features.h"
#include "engine/kernels/shapes/flat.h"
#include "engine/kernels/shapes/shape_description.h"
#include "engine/kernels/shapes/spherical_polygons.h"

namespace glint {

struct RectangleShape {
    static constexpr FeatureMask kFeature = kFeatureFlat;
    static constexpr bool kIsFinite = true;
    static constexpr bool kIsSampled = true;

    template <bool kFrontOnly>
    GLINT_HD static float intersect(const Ray& ray) {
        const float t = intersectFlat<kFrontOnly>(ray);
        const float x = ray.origin.x + t * ray.direction.x;
        const float y = ray.origin.y + t * ray.direction.y;
        return std::fabs(x) <= 1.0f && std::fabs(y) <= 1.0f ? t : kNoHit;
    }

    template <FeatureMask kMask>
    GLINT_HD static ObjectPoint surface(const Vec3& pRough) {
        return flatPoint(pRough, unitSquareUv(pRough));
    }

    GLINT_HD static Tangents tangents(const Vec3&) { return unitSquareTangents(); }

    static Bounds bounds() { return unitSquareBounds(); }
    static Bounds worldBounds(const Affine& m) { return transformBounds(m, bounds()); }

    static EmitterData makeEmitter(const Affine& objectToWorld) {
        EmitterData e = makeFlatEmitter(objectToWorld);
        e.area = 4.0f * e.area;
        const float skew = absDot(e.axisU, e.axisV) / (glm::length(e.axisU) * glm::length(e.axisV));
        e.keepsAngles = skew < 1e-5f;
        return e;
    }

    static void boundEmitter(const EmitterData& e, LightNode* node) {
        boundFlatEmitter(e, maxf(glm::length(e.axisU + e.axisV), glm::length(e.axisU - e.axisV)), node);
    }

    static float power(const GeometryView&, const EmitterData& e, float exitance) {
        return exitance * e.area;
    }

    GLINT_HD static EmitterPoint sampleArea(const GeometryView&, const EmitterData& e, const Vec2& u) {
        return flatEmitterPoint(e, 2.0f * u.x - 1.0f, 2.0f * u.y - 1.0f, 1.0f / e.area);
    }

    GLINT_HD static EmitterPoint sampleFrom(const GeometryView&, const EmitterData& e, const Vec3& from,
                                            const Vec2& u) {
        if (e.keepsAngles && looksLarge(e, e.position, from)) {
            const SphericalRectangle q = asSeen(e, from);
            if (q.solidAngle > kSmallSolidAngle * 0.5f) {
                const Vec2 ab = sampleSphericalRectangle(q, u);
                return flatEmitterPoint(e, 2.0f * ab.x - 1.0f, 2.0f * ab.y - 1.0f, 1.0f / q.solidAngle);
            }
        }
        return flatEmitterPointFrom(e, from, 2.0f * u.x - 1.0f, 2.0f * u.y - 1.0f);
    }

    GLINT_HD static float pdfFrom(const GeometryView&, const EmitterData& e, const Vec3& from,
                                  const Vec3& p) {
        if (e.keepsAngles && looksLarge(e, e.position, from)) {
            const float solidAngle = asSeen(e, from).solidAngle;
            if (solidAngle > kSmallSolidAngle * 0.5f) { return 1.0f / solidAngle; }
        }
        return areaToSolidAngle(1.0f / e.area, from, p, e.direction);
    }

    static ShapeDescription description() {
        return {
            .name = "rectangle",
            .help = "Its front is the side edgeU x edgeV points to.",
            .keyList = {{{"center"},
                         {"edgeU", PlacementForm::Direction, Vec3(2.0f, 0.0f, 0.0f), "One whole edge (m)."},
                         {"edgeV", PlacementForm::Direction, Vec3(0.0f, 2.0f, 0.0f),
                          "The other whole edge (m)."}}},
            .transform = place,
            .refusal = "\"edgeU\" and \"edgeV\" are parallel; expected two edges of a rectangle",
            .grid = {.at = [](double u, double v) { return glm::dvec3(2.0 * u - 1.0, 2.0 * v - 1.0, 0.0); }}};
    }

  private:
    /// The third axis has the edges' mean length, so that the transform can be undone.
    static bool place(const Placement& values, Affine* placed) {
        const auto& [center, edgeU, edgeV] = values;
        const Vec3 across = glm::cross(glm::normalize(edgeU), glm::normalize(edgeV));
        if (lengthSquared(across) < 1e-12f) { return false; }
        const float depth = 0.5f * std::sqrt(glm::length(edgeU)) * std::sqrt(glm::length(edgeV));
        *placed = {Mat3(0.5f * edgeU, 0.5f * edgeV, depth * glm::normalize(across)), center};
        return true;
    }

    GLINT_HD static SphericalRectangle asSeen(const EmitterData& e, const Vec3& from) {
        return makeSphericalRectangle(e.position - e.axisU - e.axisV, 2.0f * e.axisU, 2.0f * e.axisV,
                                      e.direction, from);
    }
};

}  // namespace glint
