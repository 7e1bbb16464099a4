// The disc: z = 0, radius 1, normal +z. Under a transform it is an ellipse, which is sampled by area.
//
// Texture coordinates: (x + 1) / 2, (y + 1) / 2.
#pragma once

#include <numbers>

#include "engine/kernels/features.h"
#include "engine/kernels/shapes/flat.h"
#include "engine/kernels/shapes/shape_description.h"
#include "engine/math/warp.h"

namespace glint {

struct DiscShape {
    static constexpr FeatureMask kFeature = kFeatureFlat;
    static constexpr bool kIsFinite = true;
    static constexpr bool kIsSampled = true;

    template <bool kFrontOnly>
    GLINT_HD static float intersect(const Ray& ray) {
        const float t = intersectFlat<kFrontOnly>(ray);
        const float x = ray.origin.x + t * ray.direction.x;
        const float y = ray.origin.y + t * ray.direction.y;
        return x * x + y * y <= 1.0f ? t : kNoHit;
    }

    template <FeatureMask kMask>
    GLINT_HD static ObjectPoint surface(const Vec3& pRough) {
        return flatPoint(pRough, unitSquareUv(pRough));
    }

    GLINT_HD static Tangents tangents(const Vec3&) { return unitSquareTangents(); }

    static Bounds bounds() { return unitSquareBounds(); }
    static Bounds worldBounds(const Affine& m) {
        const Vec3 extent = rowLengths(Mat3(m.linear[0], m.linear[1], Vec3(0.0f)));
        return {m.translation - extent, m.translation + extent};
    }

    static EmitterData makeEmitter(const Affine& objectToWorld) {
        EmitterData e = makeFlatEmitter(objectToWorld);
        e.area = kPi * e.area;
        return e;
    }

    static void boundEmitter(const EmitterData& e, LightNode* node) {
        boundFlatEmitter(e, std::sqrt(lengthSquared(e.axisU) + lengthSquared(e.axisV)), node);
    }

    static float power(const GeometryView&, const EmitterData& e, float exitance) {
        return exitance * e.area;
    }

    GLINT_HD static EmitterPoint sampleArea(const GeometryView&, const EmitterData& e, const Vec2& u) {
        const Vec2 d = sampleDisc(u);
        return flatEmitterPoint(e, d.x, d.y, 1.0f / e.area);
    }

    GLINT_HD static EmitterPoint sampleFrom(const GeometryView&, const EmitterData& e, const Vec3& from,
                                            const Vec2& u) {
        const Vec2 d = sampleDisc(u);
        return flatEmitterPointFrom(e, from, d.x, d.y);
    }

    GLINT_HD static float pdfFrom(const GeometryView&, const EmitterData& e, const Vec3& from,
                                  const Vec3& p) {
        return areaToSolidAngle(1.0f / e.area, from, p, e.direction);
    }

    static ShapeDescription description() {
        return {.name = "disc",
                .keyList = {{{"center"},
                             {"normal", PlacementForm::Direction, Vec3(0.0f, 0.0f, 1.0f)},
                             {"radius", PlacementForm::Length, Vec3(1.0f)}}},
                .transform =
                    [](const Placement& values, Affine* placed) {
                        *placed = facing(values[1], values[2].x, values[0]);
                        return true;
                    },
                .grid = {.rows = 128, .poles = true, .at = [](double u, double v) {
                             const double angle = std::numbers::pi * v;
                             return glm::dvec3((2.0 * u - 1.0) * std::sin(angle), -std::cos(angle), 0.0);
                         }}};
    }
};

}  // namespace glint
