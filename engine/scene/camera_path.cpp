#include "engine/scene/camera_path.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/math/vec.h"

namespace glint {
namespace {

/// Of four views in a row, between the two in the middle.
template <class T>
T between(const std::array<const Camera*, 4>& views, float t, T Camera::*member) {
    const auto& [a, b, c, d] = views;
    const T tangentB = 0.5f * (c->*member - a->*member), tangentC = 0.5f * (d->*member - b->*member);
    const float t2 = t * t, t3 = t2 * t;
    return (2.0f * t3 - 3.0f * t2 + 1.0f) * (b->*member) + (t3 - 2.0f * t2 + t) * tangentB +
           (3.0f * t2 - 2.0f * t3) * (c->*member) + (t3 - t2) * tangentC;
}

}  // namespace

Camera turnedCamera(const Camera& camera, float turns) {
    const float length = std::sqrt(lengthSquared(camera.up));
    if (!(length > 0.0f)) { return camera; }
    const Vec3 axis = camera.up / length, arm = camera.position - camera.target;
    const float angle = kTwoPi * (turns - std::floor(turns));
    const float c = std::cos(angle), s = std::sin(angle);
    Camera turned = camera;
    // Rodrigues' formula.
    turned.position =
        camera.target + c * arm + s * glm::cross(axis, arm) + (1.0f - c) * glm::dot(axis, arm) * axis;
    return turned;
}

Camera cameraBetween(std::span<const Camera> views, float along) {
    const int last = static_cast<int>(views.size()) - 1;
    const int begin = std::clamp(static_cast<int>(std::floor(along)), 0, std::max(0, last - 1));
    const float t = std::clamp(along - static_cast<float>(begin), 0.0f, 1.0f);
    const auto view = [&](int i) { return &views[static_cast<size_t>(std::clamp(i, 0, last))]; };
    const std::array<const Camera*, 4> four{view(begin - 1), view(begin), view(begin + 1), view(begin + 2)};
    Camera camera = t < 0.5f ? *four[1] : *four[2];
    if (t == 0.0f || t == 1.0f) { return camera; }
    camera.position = between(four, t, &Camera::position);
    camera.target = between(four, t, &Camera::target);
    camera.up = between(four, t, &Camera::up);
    camera.shift = between(four, t, &Camera::shift);
    for (float Camera::*member : {&Camera::verticalFovDeg, &Camera::viewHeight, &Camera::horizontalScale,
                                  &Camera::apertureDiameter, &Camera::focalDistance}) {
        // A curve through its ends may leave their range, where an aperture would be negative.
        const auto [low, high] = std::minmax(four[1]->*member, four[2]->*member);
        camera.*member = std::clamp(between(four, t, member), low, high);
    }
    return camera;
}

}  // namespace glint
