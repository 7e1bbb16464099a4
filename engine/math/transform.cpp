// Host-side construction and inversion of affine maps.
#include "engine/math/transform.h"

#include <array>
#include <bit>
#include <cmath>

#include <glm/ext/matrix_double3x3.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/matrix.hpp>

namespace glint {

bool sameBits(const Mat3& a, const Mat3& b) {
    using Bits = std::array<uint32_t, 9>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

bool Affine::isExactIdentity() const { return sameBits(linear, Mat3(1.0f)) && isZero(translation); }

Affine inverse(const Affine& a) {
    const glm::dmat3 inverseLinear = glm::inverse(glm::dmat3(a.linear));
    return {Mat3(inverseLinear), Vec3(-(inverseLinear * glm::dvec3(a.translation)))};
}

bool isInvertible(const Affine& a) {
    if (!isFinite(a.translation)) { return false; }
    double columnProduct = 1.0;
    for (int column = 0; column < 3; ++column) {
        if (!isFinite(a.linear[column])) { return false; }
        columnProduct *= glm::length(glm::dvec3(a.linear[column]));
    }
    constexpr double kFlatness = 1e-9;
    const double determinant = std::fabs(glm::determinant(glm::dmat3(a.linear)));
    return columnProduct > 0.0 && determinant > kFlatness * columnProduct;
}

Affine translate(const Vec3& t) { return {Mat3(1.0f), t}; }

Affine scale(const Vec3& s) {
    Affine out;
    out.linear[0][0] = s.x;
    out.linear[1][1] = s.y;
    out.linear[2][2] = s.z;
    return out;
}

Affine rotate(const Vec3& axis, float angleRad) {
    const glm::dvec3 u = glm::normalize(glm::dvec3(axis));
    const double c = std::cos(static_cast<double>(angleRad));
    const double s = std::sin(static_cast<double>(angleRad));
    const glm::dmat3 cross(0, u.z, -u.y, -u.z, 0, u.x, u.y, -u.x, 0);
    const glm::dmat3 outer = glm::outerProduct(u, u);
    return {Mat3(c * glm::dmat3(1.0) + s * cross + (1.0 - c) * outer), Vec3(0.0f)};
}

Bounds transformBounds(const Affine& a, const Bounds& b) {
    Bounds out;
    if (b.empty()) { return out; }
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p((corner & 1) != 0 ? b.hi.x : b.lo.x, (corner & 2) != 0 ? b.hi.y : b.lo.y,
                     (corner & 4) != 0 ? b.hi.z : b.lo.z);
        out.grow(a.point(p));
    }
    return out;
}

}  // namespace glint
