#include "viewer/model/camera_controller.h"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

constexpr float kPoleMarginRad = 0.02f;
constexpr float kDollyShare = 0.12f;  // of the distance, each wheel step
constexpr float kFrameMargin = 1.08f;

Vec3 anyPerpendicular(const Vec3& v) {
    const Vec3 helper = std::fabs(v.x) < 0.9f ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    return glm::normalize(glm::cross(v, helper));
}

/// Turns `direction` about `up` by the drag's x, and towards or away from `up` by its y, short of the poles.
Vec3 turned(const Camera& camera, const Vec3& direction, Vec2 angles) {
    const Vec3 pole = isZero(camera.up) ? Vec3{0, 1, 0} : glm::normalize(camera.up);
    const float length = glm::length(direction);
    const float height = clampf(glm::dot(direction, pole) / length, -1.0f, 1.0f);
    const float elevation =
        clampf(std::asin(height) + angles.y, -kPi / 2 + kPoleMarginRad, kPi / 2 - kPoleMarginRad);
    Vec3 level = direction - pole * glm::dot(direction, pole);
    level = lengthSquared(level) > 1e-12f * length * length ? glm::normalize(level) : anyPerpendicular(pole);
    const Vec3 across = glm::cross(pole, level);
    const Vec3 heading = level * std::cos(angles.x) + across * std::sin(angles.x);
    return (heading * std::cos(elevation) + pole * std::sin(elevation)) * length;
}

}  // namespace

float targetDistance(const Camera& camera) { return glm::length(camera.target - camera.position); }

void orbit(Camera* camera, Vec2 dragPixels, float imageHeight) {
    const Vec2 angles = dragPixels * Vec2(-kPi, kPi) / std::max(imageHeight, 1.0f);
    if (targetDistance(*camera) <= 0.0f) { return; }
    camera->position = camera->target + turned(*camera, camera->position - camera->target, angles);
}

void lookAround(Camera* camera, Vec2 dragPixels, float imageHeight) {
    const Vec2 angles = dragPixels * Vec2(-1.0f, -1.0f) *
                        (camera->verticalFovDeg * kPi / 180.0f / std::max(imageHeight, 1.0f));
    if (targetDistance(*camera) <= 0.0f) { return; }
    camera->target = camera->position + turned(*camera, camera->target - camera->position, angles);
}

void pan(Camera* camera, Vec2 dragPixels, float imageHeight) {
    const CameraAxes axes = axesOf(*camera);
    const float metresPerPixel = heightOfView(*camera, targetDistance(*camera)) / std::max(imageHeight, 1.0f);
    const Vec3 shift =
        axes.right * (-dragPixels.x * metresPerPixel) + axes.up * (dragPixels.y * metresPerPixel);
    camera->position += shift;
    camera->target += shift;
}

void dolly(Camera* camera, float steps) {
    const float factor = std::pow(1.0f - kDollyShare, clampf(steps, -20.0f, 20.0f));
    if (camera->kind == ProjectionKind::Orthographic) {
        camera->viewHeight *= factor;
    } else {
        camera->position = camera->target + (camera->position - camera->target) * factor;
    }
}

void fly(Camera* camera, const Vec3& amount) {
    const CameraAxes axes = axesOf(*camera);
    const Vec3 shift =
        (axes.right * amount.x + axes.up * amount.y + axes.forward * amount.z) * targetDistance(*camera);
    camera->position += shift;
    camera->target += shift;
}

void frameBounds(Camera* camera, const Bounds& bounds, float aspect) {
    if (bounds.empty()) { return; }
    const float radius = std::max(0.5f * glm::length(bounds.extent()), 1e-6f);
    const float width = aspect * camera->horizontalScale;
    float distance = 2.0f * radius;  // all of it is before the camera
    if (camera->kind == ProjectionKind::Orthographic) {
        camera->viewHeight = 2.0f * kFrameMargin * radius / std::min(1.0f, width);
    } else {
        const float tanVertical = 0.5f * heightOfView(*camera, 1.0f);
        const float tanSmallest = std::min(tanVertical, tanVertical * width);
        distance = kFrameMargin * radius / std::sin(std::atan(tanSmallest));
    }
    const Vec3 forward = axesOf(*camera).forward;
    camera->shift = Vec2(0.0f);
    camera->target = bounds.center();
    camera->position = camera->target - forward * distance;
}

void setProjection(Camera* camera, ProjectionKind kind) {
    if (camera->kind == kind) { return; }
    const float distance = targetDistance(*camera);
    if (kind == ProjectionKind::Orthographic) {
        camera->viewHeight = heightOfView(*camera, distance);
    } else {
        camera->verticalFovDeg =
            clampf(2.0f * std::atan(0.5f * camera->viewHeight / distance) * 180.0f / kPi, 0.1f, 170.0f);
    }
    camera->kind = kind;
}

}  // namespace glint
