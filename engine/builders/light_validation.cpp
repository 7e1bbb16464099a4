#include "engine/builders/light_validation.h"

#include <fmt/format.h>

#include "engine/builders/scene_fault.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

Status checkImage(const SceneDescription& scene, const Light& light, const std::string& who) {
    const int texture = light.image.texture;
    if (texture < -1 || texture >= static_cast<int>(scene.textures.size())) {
        return fault(who, fmt::format("uses texture {} of {}", texture, scene.textures.size()));
    }
    if (!isFinite(light.up) || !notNegative(light.image.value)) {
        return fault(who, "the picture's upward direction must be finite, its colour not negative");
    }
    if (light.kind != LightKind::Projector) { return {}; }
    if (!inRange(light.fovDeg, 1e-3f, 179.99f) || !inRange(light.aspect, 1e-6f, 1e6f)) {
        return fault(who,
                     fmt::format("its picture is {} degrees wide and {} times as wide as high; expected an "
                                 "angle between 0 and 180 degrees, and a number above 0",
                                 light.fovDeg, light.aspect));
    }
    return {};
}

}  // namespace

Status checkLight(const SceneDescription& scene, size_t index) {
    const Light& light = scene.lights[index];
    const std::string who = label("light", light.name, index);
    if (!isFinite(light.position) || !isFinite(light.direction)) {
        return fault(who, "position and direction must be finite numbers");
    }
    if (light.kind != LightKind::Point && isZero(light.direction)) {
        return fault(who, "the direction has no length");
    }
    if (!notNegative(light.color) || !inRange(light.strength, 0.0f, 3e38f)) {
        return fault(who, "colour and strength must not be negative");
    }
    if (light.kind == LightKind::Spot && (!inRange(light.coneAngleDeg, 1e-6f, 90.0f) ||
                                          !inRange(light.coneFalloffStartDeg, 0.0f, light.coneAngleDeg))) {
        return fault(
            who,
            fmt::format("the cone ends at {} and falls off from {} degrees; expected 0 <= start <= end <= 90",
                        light.coneAngleDeg, light.coneFalloffStartDeg));
    }
    return hasImage(light.kind) ? checkImage(scene, light, who) : Status();
}

Status checkEnvironment(const SceneDescription& scene) {
    const Environment& environment = scene.environment;
    if (environment.image < -1 || environment.image >= static_cast<int>(scene.environmentImages.size())) {
        return fault("environment",
                     fmt::format("uses image {} of {}", environment.image, scene.environmentImages.size()));
    }
    if (usesEnvironmentImage(scene) &&
        !scene.environmentImages[static_cast<size_t>(environment.image)].isRead()) {
        return fault("environment", "shines with an image that has not been read");
    }
    if (!notNegative(environment.color) || !inRange(environment.strength, 0.0f, 3e38f) ||
        !std::isfinite(environment.rotationDeg)) {
        return fault("environment", "colour and strength must not be negative, the rotation finite");
    }
    if (!environment.portal.empty() && !isRectangle(environment.portal)) {
        return fault("environment",
                     "the portal is no rectangle; expected its four corners one after the other");
    }
    return {};
}

}  // namespace glint
