// Affine maps as a 3x4 matrix, and the pair of a map with its inverse. Host and device.
//
// Any invertible affine map is allowed: non-uniform, mirrored, sheared. Inversion happens in double on
// the host.
#pragma once

#include "engine/math/bounds.h"
#include "engine/math/vec.h"

namespace glint {

/// p -> linear * p + translation.
struct Affine {
    Mat3 linear{1.0f};
    Vec3 translation{0.0f};

    GLINT_HD Vec3 point(const Vec3& p) const { return linear * p + translation; }
    GLINT_HD Vec3 vector(const Vec3& v) const { return linear * v; }
    GLINT_HD float determinant() const { return glm::determinant(linear); }
    bool operator==(const Affine& other) const {
        return linear == other.linear && translation == other.translation;
    }
    /// Unlike ==, tells -0 from 0 in the linear part, which files keep apart too.
    bool isExactIdentity() const;
};

/// (a * b)(p) = a(b(p)).
GLINT_HD inline Affine operator*(const Affine& a, const Affine& b) {
    return {a.linear * b.linear, a.linear * b.translation + a.translation};
}

/// Maps normals under an affine map whose inverse's linear part is `inverseLinear`: n * M^-1. The result is
/// not normalised. It keeps the side under mirroring (a normal stays on the side where it was).
GLINT_HD inline Vec3 transformNormal(const Mat3& inverseLinear, const Vec3& n) { return n * inverseLinear; }

/// |M| * v, entry by entry.
GLINT_HD inline Vec3 absMultiply(const Mat3& m, const Vec3& v) {
    return absVec(m[0]) * v.x + absVec(m[1]) * v.y + absVec(m[2]) * v.z;
}

/// The lengths of the rows: half the extents of the unit sphere's image.
inline Vec3 rowLengths(const Mat3& m) {
    return {glm::length(Vec3(m[0].x, m[1].x, m[2].x)), glm::length(Vec3(m[0].y, m[1].y, m[2].y)),
            glm::length(Vec3(m[0].z, m[1].z, m[2].z))};
}

/// The inverse, computed in double. The caller checks isInvertible() first.
Affine inverse(const Affine& a);

/// Unlike ==, tells -0 from 0.
bool sameBits(const Mat3& a, const Mat3& b);

/// False for maps that flatten space or hold non-finite numbers. Scale does not matter: 1e-12 * identity
/// is invertible.
bool isInvertible(const Affine& a);

Affine translate(const Vec3& t);
Affine scale(const Vec3& s);
/// Right-handed rotation about `axis` (need not be of unit length, must not be zero) by `angleRad`.
Affine rotate(const Vec3& axis, float angleRad);
/// The box of a transformed box.
Bounds transformBounds(const Affine& a, const Bounds& b);

}  // namespace glint
