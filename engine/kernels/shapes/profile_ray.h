// A ray beside a surface of revolution, and which pieces of the profile it may meet. Host and device.
#pragma once

#include <cmath>

#include "engine/kernels/profile_view.h"
#include "engine/kernels/simd.h"
#include "engine/math/ray.h"

namespace glint {

/// The ray from next to the shape, heights measured from the profile's middle, so that rays from far away
/// lose no digits.
struct ProfileRay {
    /// A ray as good as horizontal leaves the curve's height alone: roots of its polynomial would be lost in
    /// rounding, at joints of pieces from a slope of 1e-6 on. Two hits of one piece may be lost instead where
    /// the ray dips by less than the slope's square times the curve's radius.
    static constexpr double kHorizontalSlope = 1e-5;

    double ox, oy, oz, dx, dy, dz;
    double shift;     ///< t of the origin
    double flat2;     ///< |d.xz|^2
    double middle;    ///< t where it is nearest to the axis
    double nearest2;  ///< its distance there, squared
    double inverseDy, inverseFlat2;
    bool isHorizontal;

    GLINT_HD ProfileRay(const Ray& ray, const ProfileData& profile)
        : ox(static_cast<double>(ray.origin.x)),
          oy(static_cast<double>(ray.origin.y) - profile.middle),
          oz(static_cast<double>(ray.origin.z)),
          dx(static_cast<double>(ray.direction.x)),
          dy(static_cast<double>(ray.direction.y)),
          dz(static_cast<double>(ray.direction.z)) {
        flat2 = dx * dx + dz * dz;
        shift = -(ox * dx + oy * dy + oz * dz) / (flat2 + dy * dy);
        ox += shift * dx;
        oy += shift * dy;
        oz += shift * dz;
        inverseDy = 1.0 / dy;
        isHorizontal = dy * dy <= kHorizontalSlope * kHorizontalSlope * flat2;
        inverseFlat2 = 1.0 / flat2;
        const double across = ox * dz - oz * dx;
        middle = -(ox * dx + oz * dz) * inverseFlat2;
        nearest2 = across * across * inverseFlat2;
    }

    /// Of a piece: how far off roots may be, which moves t the more the flatter the ray is.
    GLINT_HD double closeRoot() const {
        const double slope2 = dy * dy * inverseFlat2;
        return slope2 < 0.01 ? 1e-7 * std::sqrt(slope2) : 1e-8;
    }

    /// Of a piece: a step of Newton's method that leaves an error of its square. Smaller the closer together
    /// the ray's slope brings the places where it comes in and goes out.
    GLINT_HD double closeStep() const {
        const double slope = std::sqrt(dy * dy * inverseFlat2);
        return slope < 0.1 ? 1e-4 * slope : 1e-5;
    }
};

/// The same for the test against rings. Rays within a millionth of vertical count as vertical, and no ray
/// counts as quite horizontal, which moves them by less than the rings are wider than what is in them.
struct RingRay {
    float oy, inverseDy;
    float middle, nearest2, inverseFlat2;

    GLINT_HD explicit RingRay(const ProfileRay& ray) {
        const double length2 = ray.flat2 + ray.dy * ray.dy;
        const bool isVertical = ray.flat2 <= 1e-12 * length2;
        const double slope2 = isVertical ? 1e-12 * length2 : ray.flat2;
        const bool isLevel = ray.dy * ray.dy <= 1e-18 * length2;
        oy = static_cast<float>(ray.oy);
        inverseDy = static_cast<float>(isLevel ? 1e9 / std::sqrt(length2) : ray.inverseDy);
        middle = isVertical ? 0.0f : static_cast<float>(ray.middle);
        nearest2 = static_cast<float>(isVertical ? ray.ox * ray.ox + ray.oz * ray.oz : ray.nearest2);
        inverseFlat2 = static_cast<float>(isVertical ? 1.0 / slope2 : ray.inverseFlat2);
    }
};

/// Bit i: the ray may meet piece i between tMin and tMax, which count from its origin; not before first[i],
/// where that is asked for. A plain loop, which compilers turn into vector code. Without first, the answer
/// compares squares and needs no roots.
template <bool kAsksFirst>
GLINT_HD inline uint32_t ringHits(const PieceRings& rings, const RingRay& ray, float tMin, float tMax,
                                  float* first) {
    alignas(32) int32_t meets[kPieceLanes];
    for (uint32_t i = 0; i < kPieceLanes; ++i) {
        const float t0 = (rings.lowest[i] - ray.oy) * ray.inverseDy;
        const float t1 = (rings.highest[i] - ray.oy) * ray.inverseDy;
        // Within the outer radius and the heights, but for the way within the inner radius.
        const float outer2 = (rings.most2[i] - ray.nearest2) * ray.inverseFlat2;
        const float inner2 = (rings.least2[i] - ray.nearest2) * ray.inverseFlat2;
        float begin = t0 < t1 ? t0 : t1, end = t0 < t1 ? t1 : t0;
        if constexpr (kAsksFirst) {
            const float outer = std::sqrt(outer2 > 0.0f ? outer2 : 0.0f);
            const float inner = std::sqrt(inner2 > 0.0f ? inner2 : 0.0f);
            begin = begin > ray.middle - outer ? begin : ray.middle - outer;
            end = end < ray.middle + outer ? end : ray.middle + outer;
            begin = begin > tMin ? begin : tMin;
            end = end < tMax ? end : tMax;
            const float after = begin > ray.middle + inner ? begin : ray.middle + inner;
            begin = begin > ray.middle - inner ? after : begin;
            first[i] = begin;
            meets[i] = outer2 >= 0.0f && begin <= end ? -1 : 0;
        } else {
            begin = (begin > tMin ? begin : tMin) - ray.middle;
            end = (end < tMax ? end : tMax) - ray.middle;
            float least = begin > -end ? begin : -end;
            least = least > 0.0f ? least : 0.0f;
            const float most = end > -begin ? end : -begin;
            meets[i] = begin <= end && least * least <= outer2 && most * most >= inner2 ? -1 : 0;
        }
    }
#if GLINT_HAS_AVX2
    const __m256 signs = _mm256_castsi256_ps(_mm256_load_si256(reinterpret_cast<const __m256i*>(meets)));
    return static_cast<uint32_t>(_mm256_movemask_ps(signs));
#else
    uint32_t bits = 0;
    for (uint32_t i = 0; i < kPieceLanes; ++i) {
        bits |= static_cast<uint32_t>(meets[i] & 1) << i;
    }
    return bits;
#endif
}

}  // namespace glint
