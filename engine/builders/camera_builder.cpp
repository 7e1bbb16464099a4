#include "engine/builders/camera_builder.h"

#include <cmath>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

namespace glint {
namespace {

Status checkCamera(const Camera& camera, float aspect) {
    const auto bad = [](std::string message) { return Error{std::move(message), {}}; };
    if (!isFinite(camera.position) || !isFinite(camera.target) || !isFinite(camera.up)) {
        return bad("the camera's position, target and up must be finite numbers");
    }
    if (!(camera.verticalFovDeg > 0.0f && camera.verticalFovDeg < 180.0f)) {
        return bad(fmt::format(
            "the camera's vertical field of view is {} degrees; expected more than 0, less than 180",
            camera.verticalFovDeg));
    }
    if (!(camera.viewHeight > 0.0f && std::isfinite(camera.viewHeight))) {
        return bad(fmt::format("the camera's view is {} m high; expected more than 0", camera.viewHeight));
    }
    if (!std::isfinite(camera.shift.x) || !std::isfinite(camera.shift.y)) {
        return bad("the camera's shift must be finite numbers");
    }
    if (!(camera.horizontalScale > 0.0f && std::isfinite(camera.horizontalScale))) {
        return bad(
            fmt::format("the camera's horizontal scale is {}; expected more than 0", camera.horizontalScale));
    }
    if (!(camera.apertureDiameter >= 0.0f && std::isfinite(camera.apertureDiameter))) {
        return bad(
            fmt::format("the camera's aperture diameter is {}; expected 0 or more", camera.apertureDiameter));
    }
    if (!(camera.focalDistance > 0.0f && std::isfinite(camera.focalDistance))) {
        return bad(
            fmt::format("the camera's focal distance is {}; expected more than 0", camera.focalDistance));
    }
    if (camera.apertureBlades < 0 || camera.apertureBlades == 1 || camera.apertureBlades == 2) {
        return bad(fmt::format("the camera's aperture has {} blades; expected 0 (round) or at least 3",
                               camera.apertureBlades));
    }
    if (!std::isfinite(camera.bladeRotationDeg)) {
        return bad("the rotation of the camera's blades must be a finite number");
    }
    if (!(aspect > 0.0f && std::isfinite(aspect))) {
        return bad(fmt::format("the picture's aspect ratio is {}; expected more than 0", aspect));
    }
    return {};
}

}  // namespace

Result<CameraData> buildCamera(const Camera& camera, float aspect) {
    if (const Status status = checkCamera(camera, aspect); !status) { return status.error(); }
    if (camera.position == camera.target) {
        return Error{"the camera's position and target are the same point; expected a view direction", {}};
    }
    const CameraAxes axes = axesOf(camera);
    const bool isOrthographic = camera.kind == ProjectionKind::Orthographic;
    const double halfHeight = isOrthographic
                                  ? 0.5 * static_cast<double>(camera.viewHeight)
                                  : std::tan(0.5 * glm::radians(static_cast<double>(camera.verticalFovDeg)));

    CameraData data;
    data.position = camera.position;
    data.frame = {axes.right, axes.up, -axes.forward};
    data.isOrthographic = isOrthographic;
    data.halfHeight = static_cast<float>(halfHeight);
    data.halfWidth = static_cast<float>(halfHeight * static_cast<double>(aspect) *
                                        static_cast<double>(camera.horizontalScale));
    data.middle = Vec2(glm::dvec2(camera.shift) * 2.0 * halfHeight);
    data.middle.x *= camera.horizontalScale;
    data.lensRadius = 0.5f * camera.apertureDiameter;
    // What a pinhole does not look at is not taken over, so that editing it changes nothing.
    if (data.lensRadius > 0.0f) {
        data.focalDistance = camera.focalDistance;
        data.blades = camera.apertureBlades;
        if (data.blades > 0) {
            data.bladeRotationRad = glm::radians(std::fmod(camera.bladeRotationDeg, 360.0f));
        }
    }
    return data;
}

}  // namespace glint
