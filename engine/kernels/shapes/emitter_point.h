// Points on emissive shapes, and their densities per area and per solid angle.
#pragma once

#include "engine/kernels/geometry_view.h"
#include "engine/kernels/light_view.h"

namespace glint {

/// A point on an emitter. `pdf` is the density with which it was chosen: per area, or per solid angle at the
/// place from which it is seen, as the function says that made it. 0: none was found.
struct EmitterPoint {
    Vec3 p{0.0f};
    Vec3 pError{0.0f};  ///< bound of the absolute rounding error of p in each coordinate
    Vec3 normal{0.0f};  ///< unit, front side
    float pdf = 0.0f;
};

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

/// What an emitter that light sampling never chooses answers: rays find it.
struct NeverSampled {
    static constexpr bool kIsSampled = false;

    GLINT_HD static EmitterPoint sampleArea(const GeometryView&, const EmitterData&, const Vec2&) {
        return {};
    }
    GLINT_HD static EmitterPoint sampleFrom(const GeometryView&, const EmitterData&, const Vec3&,
                                            const Vec2&) {
        return {};
    }
    GLINT_HD static float pdfFrom(const GeometryView&, const EmitterData&, const Vec3&, const Vec3&) {
        return 0.0f;
    }
    static EmitterData makeEmitter(const Affine&) { return {}; }
    static void boundEmitter(const EmitterData&, LightNode*) {}
    static float power(const GeometryView&, const EmitterData&, float) { return 0.0f; }
};

}  // namespace glint
