// Profiles of surfaces of revolution as kernels read them. Plain data, filled by builders/profile_builder.
//
// Curves say what the surface is; pieces are short parts of them that rays are tested against, of a lower
// degree where that moves them less than rays can tell. A piece's parameter runs from 0 to 1 along it.
#pragma once

#include <cmath>
#include <cstdint>

#include "engine/kernels/geometry_view.h"

namespace glint {

constexpr int kMaxProfileDegree = 15;

/// One Bézier curve in the half plane (distance from the axis, height).
struct ProfileCurve {
    double x[kMaxProfileDegree + 1];  ///< Bernstein coefficients: distance from the axis, signed
    double y[kMaxProfileDegree + 1];  ///< height
    int degree;
    float vBegin, vStep;  ///< texture coordinate at its begin, and from there to its end
    /// Of the whole surface: the share of its area before each of the curve's equal steps of the parameter,
    /// and at its end.
    static constexpr int kAreaSteps = 16;
    float areaBefore[kAreaSteps + 1];
};

/// A quadratic that has a polynomial's values at 0, 1/2 and 1: its Bernstein coefficients, the ends of which
/// are the polynomial's own, and the most by which it and its derivatives are off between 0 and 1.
struct QuadraticFit {
    double value[3];
    double error, slopeError, curvatureError;
};

/// A part of a curve, heights measured from the profile's middle, with the products that a ray's polynomial
/// is made of.
struct ProfilePiece {
    QuadraticFit xSquaredFit, ySquaredFit, yFit;
    alignas(16) double powers[kMaxProfileDegree + 1][2];  ///< coefficients of the powers of x and y
    double middle;        ///< height that the errors of ySquaredFit, not its values, are of (y - middle)^2
    double begin, width;  ///< the curve's parameter where it begins, and from there to its end
    int degree;
    uint32_t curve;  ///< its number in the profile
    double
        xSquared[2 * kMaxProfileDegree + 1];  ///< Bernstein coefficients of twice the degree, like the next
    double ySquared[2 * kMaxProfileDegree + 1];
    double yRaised[2 * kMaxProfileDegree + 1];
};

constexpr uint32_t kPieceLanes = 8;

/// Rings with rectangular sections around eight pieces, wider than these by a part in 10^5 of the profile's
/// size: more than a ray is off that is known in float. The most2 of unused ones is -1.
struct alignas(32) PieceRings {
    float lowest[kPieceLanes], highest[kPieceLanes];  ///< height, from the profile's middle
    float least2[kPieceLanes], most2[kPieceLanes];    ///< distance from the axis, squared
};

constexpr uint32_t kGroupPieces = kPieceLanes * kPieceLanes;

/// Up to kGroupPieces pieces in a row: a ring around each eight of them, and the eights.
struct PieceGroup {
    PieceRings around;
    PieceRings rings[kPieceLanes];
};

/// One profile; its arrays stand in those of all profiles, from these indices on.
struct ProfileData {
    double middle;              ///< height of the middle of its box
    double radius, halfHeight;  ///< of the box
    uint32_t firstCurve, curveCount;
    uint32_t firstPiece, pieceCount;
    uint32_t firstGroup;
    float area;
    /// 1: the front is where (dy/ds, -dx/ds) points to in the half plane; -1: the other side. Where x is
    /// negative, the other way round.
    float front;
    bool clampsSearch;  ///< rays meet what shapes/clamped_search.h finds

    /// The box's diagonal.
    GLINT_HD double size() const { return 2.0 * std::sqrt(2.0 * radius * radius + halfHeight * halfHeight); }
};

/// One profile's own arrays.
struct ProfileView {
    const ProfileData* data = nullptr;
    const ProfileCurve* curves = nullptr;
    const ProfilePiece* pieces = nullptr;
    const PieceGroup* groups = nullptr;
};

GLINT_HD inline ProfileView profileAt(const GeometryView& geometry, uint32_t index) {
    const ProfileData& data = geometry.profiles[index];
    return {&data, &geometry.curves[data.firstCurve], &geometry.pieces[data.firstPiece],
            &geometry.groups[data.firstGroup]};
}

}  // namespace glint
