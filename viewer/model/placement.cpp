#include "viewer/model/placement.h"

#include <cmath>

namespace glint {
Mat3 rotationOf(const Affine& placed) {
    const Mat3& m = placed.linear;
    const float sign = placed.determinant() < 0.0f ? -1.0f : 1.0f;
    const Vec3 x = glm::normalize(m[0]) * sign;
    const Vec3 y = glm::normalize(m[1] - x * glm::dot(x, m[1]));
    return {x, y, glm::cross(x, y)};
}

Mat3 rotationFromDegrees(const Vec3& degrees) {
    return rotate({0, 0, 1}, degrees.z / kDegreesPerRadian).linear *
           rotate({0, 1, 0}, degrees.y / kDegreesPerRadian).linear *
           rotate({1, 0, 0}, degrees.x / kDegreesPerRadian).linear;
}

PlacementNumbers numbersOf(const Affine& placed) {
    const Mat3 r = rotationOf(placed);
    // r = Rz Ry Rx: its first column is (cz cy, sz cy, -sy), its last row (-sy, cy sx, cy cx).
    const float y = std::asin(clampf(-r[0].z, -1.0f, 1.0f));
    const bool isLocked = std::fabs(r[0].z) > 0.99999f;
    const float x = isLocked ? 0.0f : std::atan2(r[1].z, r[2].z);
    const float z = isLocked ? std::atan2(-r[1].x, r[1].y) : std::atan2(r[0].y, r[0].x);
    const float sign = placed.determinant() < 0.0f ? -1.0f : 1.0f;
    return {
        placed.translation,
        Vec3(x, y, z) * kDegreesPerRadian + Vec3(0.0f),
        {sign * glm::length(placed.linear[0]), glm::length(placed.linear[1]), glm::length(placed.linear[2])}};
}

Affine withNumbers(const Affine& placed, const PlacementNumbers& from, const PlacementNumbers& to) {
    Affine out = placed;
    out.translation += to.position - from.position;
    for (int i = 0; i < 3; ++i) {
        out.linear[i] *= to.scale[i] / from.scale[i];
    }
    if (to.rotationDeg != from.rotationDeg) {
        const Mat3 before = rotationFromDegrees(from.rotationDeg);
        out.linear = rotationFromDegrees(to.rotationDeg) * glm::transpose(before) * out.linear;
    }
    return out;
}

}  // namespace glint
