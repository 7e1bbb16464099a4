#include "engine/scene/light.h"

#include "engine/math/frame.h"

namespace glint {

Vec3 pictureRight(const Light& projector) {
    const Vec3 direction = glm::normalize(projector.direction);
    const Vec3 right = glm::cross(direction, projector.up);
    const float length = glm::length(right);
    return length > 1e-6f * glm::length(projector.up) ? right / length : Frame::fromNormal(direction).s;
}

}  // namespace glint
