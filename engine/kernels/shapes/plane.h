// The plane: z = 0 without an end, normal +z. It shines, but nobody can choose a point on it.
//
// Texture coordinates: the object-space x and y.
#pragma once

#include "engine/kernels/features.h"
#include "engine/kernels/shapes/flat.h"
#include "engine/kernels/shapes/shape_description.h"

namespace glint {

struct PlaneShape : NeverSampled {
    static constexpr FeatureMask kFeature = kFeaturePlane;
    static constexpr bool kIsFinite = false;

    template <bool kFrontOnly>
    GLINT_HD static float intersect(const Ray& ray) {
        return intersectFlat<kFrontOnly>(ray);
    }

    template <FeatureMask kMask>
    GLINT_HD static ObjectPoint surface(const Vec3& pRough) {
        return flatPoint(pRough, Vec2(pRough));
    }

    GLINT_HD static Tangents tangents(const Vec3&) {
        return {Vec3(1.0f, 0.0f, 0.0f), Vec3(0.0f, 1.0f, 0.0f)};
    }

    static Bounds bounds() { return {}; }
    static Bounds worldBounds(const Affine&) { return {}; }

    static ShapeDescription description() {
        return {.name = "plane",
                .help = "Infinite.",
                .keyList = {{{"point"}, {"normal", PlacementForm::Direction, Vec3(0.0f, 0.0f, 1.0f)}}},
                .transform =
                    [](const Placement& values, Affine* placed) {
                        *placed = facing(values[1], 1.0f, values[0]);
                        return true;
                    },
                .grid = {.at = [](double u, double v) {
                    return double{kEndOfPlaneMesh} * glm::dvec3(2.0 * u - 1.0, 2.0 * v - 1.0, 0.0);
                }}};
    }
};

}  // namespace glint
