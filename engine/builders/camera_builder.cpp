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

/// v / |v| in double, also where |v|^2 overflows or underflows; zero stays zero.
glm::dvec3 unit(const glm::dvec3& v) {
    const double largest = std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
    return largest > 0.0 ? glm::normalize(v / largest) : glm::dvec3(0.0);
}

/// Image right for a unit view direction.
glm::dvec3 rightOf(const glm::dvec3& view, const glm::dvec3& up) {
    // Less than this and `up` says nothing but rounding errors about which way is up.
    constexpr double kLeastSine = 1e-6;
    for (const glm::dvec3& candidate : {unit(up), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
        const glm::dvec3 right = glm::cross(view, candidate);
        if (glm::length(right) > kLeastSine) { return glm::normalize(right); }
    }
    return {1, 0, 0};  // unreachable: a view cannot be along both y and z
}

}  // namespace

Result<CameraData> buildCamera(const Camera& camera, float aspect) {
    if (const Status status = checkCamera(camera, aspect); !status) { return status.error(); }
    const glm::dvec3 view = unit(glm::dvec3(camera.target) - glm::dvec3(camera.position));
    if (view == glm::dvec3(0.0)) {
        return Error{"the camera's position and target are the same point; expected a view direction", {}};
    }
    const glm::dvec3 right = rightOf(view, glm::dvec3(camera.up));
    const double tanHalfFov = std::tan(0.5 * glm::radians(static_cast<double>(camera.verticalFovDeg)));

    CameraData data;
    data.position = camera.position;
    data.frame = {Vec3(right), Vec3(glm::cross(right, view)), Vec3(-view)};
    data.tanHalfFovY = static_cast<float>(tanHalfFov);
    data.tanHalfFovX = static_cast<float>(tanHalfFov * static_cast<double>(aspect) *
                                          static_cast<double>(camera.horizontalScale));
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
