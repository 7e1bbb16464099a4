#include "engine/scene/light.h"

#include <cmath>

#include "engine/math/frame.h"

namespace glint {

Vec3 imageRight(const Light& light) {
    const Vec3 direction = glm::normalize(light.direction);
    const Vec3 right = glm::cross(direction, light.up);
    const float length = glm::length(right);
    return length > 1e-6f * glm::length(light.up) ? right / length : Frame::fromNormal(direction).s;
}

bool isRectangle(const std::vector<Vec3>& corners) {
    if (corners.size() != 4) { return false; }
    const Vec3 u = corners[1] - corners[0], v = corners[3] - corners[0];
    const float lengthU = glm::length(u), lengthV = glm::length(v);
    if (!(lengthU > 0.0f && lengthV > 0.0f) || !std::isfinite(lengthU * lengthV)) { return false; }
    constexpr float kTolerance = 1e-3f;
    return std::fabs(glm::dot(u, v)) <= kTolerance * lengthU * lengthV &&
           glm::length(corners[0] + u + v - corners[2]) <= kTolerance * minf(lengthU, lengthV);
}

}  // namespace glint
