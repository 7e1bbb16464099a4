#include "viewer/model/light_placement.h"

#include "engine/math/frame.h"

namespace glint {

Affine placeOf(const Light& light, const Vec3& infinite) {
    const Vec3 direction =
        isZero(light.direction) ? Vec3(0.0f, -1.0f, 0.0f) : glm::normalize(light.direction);
    const Frame frame = Frame::fromNormal(direction);
    Affine placed;
    placed.linear = Mat3(frame.s, frame.t, frame.n);
    if (hasImage(light.kind)) {  // which turns about its own axis, too
        const Vec3 right = imageRight(light);
        placed.linear = Mat3(-right, glm::cross(right, direction), direction);
    }
    placed.translation = light.kind == LightKind::Directional ? infinite : light.position;
    return placed;
}

void placeLight(Light* light, const Affine& placed) {
    if (light->kind != LightKind::Directional) { light->position = placed.translation; }
    if (light->kind == LightKind::Point) { return; }
    const float length = glm::length(light->direction);
    light->direction = glm::normalize(placed.linear[2]) * (length > 0.0f ? length : 1.0f);
    if (hasImage(light->kind)) { light->up = glm::normalize(placed.linear[1]); }
}

GizmoSettings settingsFor(const Light& light, GizmoSettings settings) {
    if (settings.mode == GizmoMode::Off) { return settings; }
    const bool turns = light.kind == LightKind::Directional ||
                       (light.kind != LightKind::Point && settings.mode == GizmoMode::Rotate);
    settings.mode = turns ? GizmoMode::Rotate : GizmoMode::Move;
    return settings;
}

}  // namespace glint
