#include "viewer/model/gizmo.h"

#include <algorithm>
#include <cmath>

#include "viewer/model/placement.h"

namespace glint {
namespace {

constexpr int kRingSteps = 48;
constexpr float kStretchUnits = 120.0f;  // of a drag of the middle that doubles the size
constexpr float kLeastStretch = 1e-3f;

Mat3 axesFor(const Affine& placed, const GizmoSettings& settings) {
    const bool isLocal = settings.isLocal || settings.mode == GizmoMode::Scale;
    return isLocal ? rotationOf(placed) : Mat3(1.0f);
}

float snapped(float value, float step, bool snaps) {
    return snaps && step > 0.0f ? std::round(value / step) * step : value;
}

float distanceTo(const std::vector<Vec2>& line, Vec2 at) {
    float least = glm::length(line.front() - at);
    for (size_t i = 1; i < line.size(); ++i) {
        const Vec2 way = line[i] - line[i - 1];
        const float squared = glm::dot(way, way);
        const float t =
            squared > 0.0f ? std::clamp(glm::dot(at - line[i - 1], way) / squared, 0.0f, 1.0f) : 0.0f;
        least = std::min(least, glm::length(line[i - 1] + way * t - at));
    }
    return least;
}

}  // namespace

ScreenView::ScreenView(const Camera& camera, Vec2i picture, const PlacedImage& placed)
    : position_(camera.position), placed_(placed) {
    const Vec3 view = camera.target - camera.position;
    forward_ = isZero(view) ? Vec3(0, 0, -1) : glm::normalize(view);
    Vec3 sideways = glm::cross(forward_, camera.up);
    if (lengthSquared(sideways) < 1e-12f) {
        sideways = glm::cross(forward_, std::fabs(forward_.x) < 0.9f ? Vec3(1, 0, 0) : Vec3(0, 1, 0));
    }
    right_ = glm::normalize(sideways);
    up_ = glm::cross(right_, forward_);
    tangent_.y = std::tan(camera.verticalFovDeg * kPi / 360.0f);
    tangent_.x = tangent_.y * camera.horizontalScale * static_cast<float>(picture.x) /
                 static_cast<float>(std::max(picture.y, 1));
}

std::optional<Vec2> ScreenView::project(const Vec3& point) const {
    const Vec3 away = point - position_;
    const float depth = glm::dot(away, forward_);
    if (!(depth > 0.0f)) { return std::nullopt; }
    const Vec2 share(0.5f + 0.5f * glm::dot(away, right_) / (depth * tangent_.x),
                     0.5f - 0.5f * glm::dot(away, up_) / (depth * tangent_.y));
    return placed_.min + share * (placed_.max - placed_.min);
}

Vec3 ScreenView::directionAt(Vec2 screen) const {
    const Vec2 share = (screen - placed_.min) / (placed_.max - placed_.min) * 2.0f - 1.0f;
    return glm::normalize(forward_ + right_ * (share.x * tangent_.x) - up_ * (share.y * tangent_.y));
}

float ScreenView::metresPer(float units, const Vec3& point) const {
    const float depth = glm::dot(point - position_, forward_);
    return depth * 2.0f * tangent_.y * units / (placed_.max.y - placed_.min.y);
}

std::vector<GizmoHandle> Gizmo::handles(const Affine& placed, const GizmoSettings& settings,
                                        const ScreenView& view, float lengthUnits) const {
    std::vector<GizmoHandle> out;
    const Vec3 origin = placed.translation;
    const auto middle = view.project(origin);
    if (!middle || settings.mode == GizmoMode::Off) { return out; }
    const float length = view.metresPer(lengthUnits, origin);
    const Mat3 axes = axesFor(placed, settings);
    for (int axis = 0; axis < 3; ++axis) {
        GizmoHandle handle{GizmoHandle::Kind::Axis, axis, {}};
        if (settings.mode == GizmoMode::Rotate) {
            handle.kind = GizmoHandle::Kind::Ring;
            for (int i = 0; i <= kRingSteps; ++i) {
                const float phi = 2.0f * kPi * static_cast<float>(i) / kRingSteps;
                const Vec3 at = axes[(axis + 1) % 3] * std::cos(phi) + axes[(axis + 2) % 3] * std::sin(phi);
                if (const auto point = view.project(origin + at * length)) { handle.line.push_back(*point); }
            }
        } else if (const auto end = view.project(origin + axes[axis] * length)) {
            handle.line = {*middle, *end};
        }
        if (!handle.line.empty()) { out.push_back(std::move(handle)); }
    }
    if (settings.mode != GizmoMode::Rotate) { out.push_back({GizmoHandle::Kind::Middle, 0, {*middle}}); }
    return out;
}

std::optional<GizmoHandle> Gizmo::nearest(const std::vector<GizmoHandle>& handles, Vec2 mouse, float reach) {
    std::optional<GizmoHandle> best;
    float least = reach;
    for (const GizmoHandle& handle : handles) {
        const float distance = distanceTo(handle.line, mouse);
        // All axes begin in the middle, which goes before them.
        const bool isMiddle = handle.kind == GizmoHandle::Kind::Middle && distance < reach;
        if (distance >= least && !isMiddle) { continue; }
        least = distance;
        best = handle;
    }
    return best;
}

/// The axis's point that is nearest to the mouse's ray, in metres from the origin.
float Gizmo::along(const ScreenView& view, Vec2 mouse) const {
    const Vec3 axis = axes_[held_.axis];
    const Vec3 ray = view.directionAt(mouse);
    const Vec3 between = start_.translation - view.position();
    const float b = glm::dot(axis, ray);
    const float denominator = 1.0f - b * b;
    if (denominator < 1e-5f) { return startParameter_; }
    return (b * glm::dot(ray, between) - glm::dot(axis, between)) / denominator;
}

/// About the axis, from where the mouse's ray meets the ring's plane.
float Gizmo::angle(const ScreenView& view, Vec2 mouse) const {
    const Vec3 axis = axes_[held_.axis];
    const Vec3 ray = view.directionAt(mouse);
    const float slope = glm::dot(ray, axis);
    if (std::fabs(slope) < 0.05f) { return startParameter_; }
    const Vec3 between = start_.translation - view.position();
    const Vec3 hit = ray * (glm::dot(between, axis) / slope) - between;
    return std::atan2(glm::dot(hit, axes_[(held_.axis + 2) % 3]), glm::dot(hit, axes_[(held_.axis + 1) % 3]));
}

void Gizmo::begin(const GizmoHandle& handle, const Affine& placed, const GizmoSettings& settings,
                  const ScreenView& view, Vec2 mouse) {
    isDragging_ = true;
    held_ = handle;
    start_ = placed;
    axes_ = axesFor(placed, settings);
    from_ = mouse;
    startParameter_ = 0.0f;
    if (handle.kind == GizmoHandle::Kind::Axis) { startParameter_ = along(view, mouse); }
    if (handle.kind == GizmoHandle::Kind::Ring) { startParameter_ = angle(view, mouse); }
}

Affine Gizmo::moved(const GizmoSettings& settings, const ScreenView& view, Vec2 mouse, bool snaps) const {
    Affine out = start_;
    if (held_.kind == GizmoHandle::Kind::Axis) {
        const float way = along(view, mouse) - startParameter_;
        out.translation += axes_[held_.axis] * snapped(way, settings.moveStep, snaps);
        return out;
    }
    const Vec3 origin = start_.translation;
    const float depth = glm::length(origin - view.position());
    const Vec3 way = (view.directionAt(mouse) - view.directionAt(from_)) * depth;
    for (int i = 0; i < 3; ++i) {
        out.translation[i] += snapped(way[i], settings.moveStep, snaps);
    }
    return out;
}

Affine Gizmo::turned(const GizmoSettings& settings, const ScreenView& view, Vec2 mouse, bool snaps) const {
    const float step = settings.turnStepDeg * kPi / 180.0f;
    const float by = snapped(angle(view, mouse) - startParameter_, step, snaps);
    Affine out = start_;
    out.linear = rotate(axes_[held_.axis], by).linear * start_.linear;
    return out;
}

Affine Gizmo::stretched(const GizmoSettings& settings, const ScreenView& view, Vec2 mouse, bool snaps) const {
    Affine out = start_;
    if (held_.kind == GizmoHandle::Kind::Middle) {
        const float factor = std::exp2((mouse.x - from_.x) / kStretchUnits);
        out.linear *= std::max(kLeastStretch, snapped(factor, settings.scaleStep, snaps));
        return out;
    }
    const float factor = startParameter_ != 0.0f ? along(view, mouse) / startParameter_ : 1.0f;
    out.linear[held_.axis] *= std::max(kLeastStretch, snapped(factor, settings.scaleStep, snaps));
    return out;
}

Affine Gizmo::drag(const GizmoSettings& settings, const ScreenView& view, Vec2 mouse, bool snaps) const {
    if (mouse == from_) { return start_; }
    if (settings.mode == GizmoMode::Rotate) { return turned(settings, view, mouse, snaps); }
    return settings.mode == GizmoMode::Scale ? stretched(settings, view, mouse, snaps)
                                             : moved(settings, view, mouse, snaps);
}

}  // namespace glint
