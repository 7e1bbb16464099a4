// Where a ray that is nearly horizontal meets a piece of a profile that turns about the y axis: t has no
// digits in the height there, so that it follows from the distance to the axis, and the piece's parameter
// from the height at it. Host and device.
#pragma once

#include <initializer_list>

#include "engine/base/inlining.h"
#include "engine/kernels/shapes/profile_point.h"
#include "engine/kernels/shapes/profile_ray.h"

namespace glint {
namespace detail {

/// How far the profile at one parameter, turned about the axis, misses the ray at t; and Newton's step
/// for both.
struct RingMiss {
    double height, ring;
    double yByS, ringByS, ringByT, dy;

    GLINT_HD RingMiss(const ProfilePoint& at, const ProfileRay& ray, double t)
        : yByS(at.y.derivative), dy(ray.dy) {
        const double px = ray.ox + t * ray.dx, pz = ray.oz + t * ray.dz;
        height = at.y.value - ray.oy - t * ray.dy;
        ring = at.x.value * at.x.value - px * px - pz * pz;
        ringByS = 2.0 * at.x.value * at.x.derivative;
        ringByT = -2.0 * (px * ray.dx + pz * ray.dz);
    }
    GLINT_HD double determinant() const { return yByS * ringByT + dy * ringByS; }
    GLINT_HD double stepS() const { return (height * ringByT + dy * ring) / determinant(); }
    GLINT_HD double stepT() const { return (yByS * ring - ringByS * height) / determinant(); }
};

/// Newton's method for s and t, close to a root of the piece, in which it stays.
GLINT_HD inline void polishBoth(const ProfilePiece& piece, const ProfileRay& ray, double* s, double* t) {
    constexpr double kFarthest = 1e-6;
    const double start = *s;
    double ds = 1.0;
    for (int step = 0; step < 6 && std::fabs(ds) > 1e-9; ++step) {
        const RingMiss miss(pointOf(piece, *s), ray, *t);
        ds = miss.stepS();
        const double dt = miss.stepT();
        // Where the ray grazes the surface, the root is as good as it gets.
        if (!(std::fabs(*s - ds - start) < kFarthest) || !std::isfinite(dt)) { break; }
        *s -= ds;
        *t -= dt;
    }
    *s = *s < 0.0 ? 0.0 : *s > 1.0 ? 1.0 : *s;
}

/// How far the profile lies above a nearly horizontal ray, where that is as far from the axis: before the ray
/// is nearest to the axis (side -1) or after (1).
struct HeightMiss {
    const ProfilePiece& piece;
    const ProfileRay& ray;
    double side;

    GLINT_HD double rayT(double xSquared) const {
        const double beyond = (xSquared - ray.nearest2) * ray.inverseFlat2;
        return ray.middle + side * std::sqrt(beyond > 0.0 ? beyond : 0.0);
    }
    GLINT_HD double above(double xSquared, double y) const { return y - ray.oy - ray.dy * rayT(xSquared); }

    GLINT_HD PolynomialValue operator()(double s) const {
        const auto [x, y] = pointOf(piece, s);
        const double square = x.value * x.value;
        const double tByS = x.value * x.derivative * ray.inverseFlat2 / (rayT(square) - ray.middle);
        return {above(square, y.value), y.derivative - ray.dy * tByS};
    }
};

/// On both sides of the ray's middle, a root lies where the profile changes from above the ray to below. Ends
/// of pieces are asked with the bits that neighbours have, too, so that none gets lost between them.
template <class Found>
GLINT_ONE_PIECE_APART GLINT_HD uint32_t meetHorizontally(const ProfilePiece& piece, const ProfileRay& ray,
                                                         const Found& found) {
    const int last = 2 * piece.degree;
    const double nearest = std::sqrt(ray.nearest2);
    const double firstX = piece.powers[0][0], lastX = pointOf(piece, 1.0).x.value;
    uint32_t steps = 0;
    // The part of the piece that is not nearer to the axis than the ray; one on each side where it crosses.
    for (const double lobe : {1.0, -1.0}) {
        const bool begins = lobe * firstX >= 0.0 && piece.xSquared[0] >= ray.nearest2;
        const bool ends = lobe * lastX >= 0.0 && piece.xSquared[last] >= ray.nearest2;
        if (!begins && !ends) { continue; }
        double edge = begins ? 1.0 : 0.0;
        if (begins != ends) {
            const auto beyond = [&](double s) {
                const PolynomialValue x = pointOf(piece, s).x;
                return PolynomialValue{lobe * x.value - nearest, lobe * x.derivative};
            };
            edge = bracketedRoot(beyond, 0.0, 1.0, ends, 0.5, &steps);
        }
        const double edgeAbove = pointOf(piece, edge).y.value - ray.oy - ray.middle * ray.dy;
        for (const double side : {-1.0, 1.0}) {
            const HeightMiss miss{piece, ray, side};
            const double first = begins ? miss.above(piece.xSquared[0], piece.yRaised[0]) : edgeAbove;
            const double second = ends ? miss.above(piece.xSquared[last], piece.yRaised[last]) : edgeAbove;
            if ((first < 0.0) == (second < 0.0)) { continue; }
            const double begin = begins ? 0.0 : edge, end = ends ? 1.0 : edge;
            const double share = first / (first - second);
            double s = bracketedRoot(miss, begin, end, first < 0.0, begin + share * (end - begin), &steps);
            const double x = pointOf(piece, s).x.value;
            double t = miss.rayT(x * x);
            polishBoth(piece, ray, &s, &t);
            found(s, t);
        }
    }
    return steps;
}

}  // namespace detail
}  // namespace glint
