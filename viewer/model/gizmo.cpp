#include "viewer/model/gizmo.h"

#include <algorithm>
#include <cmath>

#include "viewer/model/placement.h"

namespace glint {
namespace {

constexpr int kRingSteps = 48;
constexpr float kStretchUnits = 120.0f;  // of a drag of the middle that doubles the size
constexpr float kLeastStretch = 1e-3f;
constexpr float kNudgeShare = 0.1f;  // of a handle
constexpr float kNudgeDegrees = 5.0f;
constexpr float kNudgeStretch = 0.05f;
constexpr float kFineShare = 0.1f;

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

ScreenView::ScreenView(const Camera& camera, Vec2i image, const PlacedImage& placed)
    : position_(camera.position),
      view_(axesOf(camera)),
      isParallel_(camera.kind == ProjectionKind::Orthographic),
      placed_(placed) {
    half_.y = 0.5f * heightOfView(camera, 1.0f);
    half_.x = half_.y * camera.horizontalScale * static_cast<float>(image.x) /
              static_cast<float>(std::max(image.y, 1));
    middle_ = 2.0f * half_.y * camera.shift * Vec2(camera.horizontalScale, 1.0f);
}

std::optional<Vec2> ScreenView::project(const Vec3& point) const {
    const Vec3 away = point - position_;
    const float depth = glm::dot(away, view_.forward);
    if (!(depth > 0.0f)) { return std::nullopt; }
    const float reach = isParallel_ ? 1.0f : depth;
    const Vec2 ndc = (Vec2(glm::dot(away, view_.right), glm::dot(away, view_.up)) / reach - middle_) / half_;
    return placed_.min + (0.5f + 0.5f * ndc * Vec2(1.0f, -1.0f)) * (placed_.max - placed_.min);
}

Ray ScreenView::rayAt(Vec2 screen) const {
    const Vec2 share = (screen - placed_.min) / (placed_.max - placed_.min) * 2.0f - 1.0f;
    const Vec2 place = share * Vec2(1.0f, -1.0f) * half_ + middle_;
    const Vec3 offset = view_.right * place.x + view_.up * place.y;
    return isParallel_ ? Ray{position_ + offset, view_.forward}
                       : Ray{position_, glm::normalize(view_.forward + offset)};
}

float ScreenView::metresPer(float units, const Vec3& point) const {
    const float depth = glm::dot(point - position_, view_.forward);
    return (isParallel_ ? 1.0f : depth) * 2.0f * half_.y * units / (placed_.max.y - placed_.min.y);
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
    const Ray ray = view.rayAt(mouse);
    const Vec3 between = start_.translation - ray.origin;
    const float b = glm::dot(axis, ray.direction);
    const float denominator = 1.0f - b * b;
    if (denominator < 1e-5f) { return startParameter_; }
    return (b * glm::dot(ray.direction, between) - glm::dot(axis, between)) / denominator;
}

/// About the axis, from where the mouse's ray meets the ring's plane.
float Gizmo::angle(const ScreenView& view, Vec2 mouse) const {
    const Vec3 axis = axes_[held_.axis];
    const Ray ray = view.rayAt(mouse);
    const float slope = glm::dot(ray.direction, axis);
    if (std::fabs(slope) < 0.05f) { return startParameter_; }
    const Vec3 between = start_.translation - ray.origin;
    const Vec3 hit = ray.direction * (glm::dot(between, axis) / slope) - between;
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
    const float distance = glm::length(origin - view.position());
    const Vec3 way = view.rayAt(mouse).at(distance) - view.rayAt(from_).at(distance);
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

Affine Gizmo::nudged(const Affine& placed, const GizmoSettings& settings, const GizmoNudge& by,
                     float handleMetres) {
    const Mat3 axes = axesFor(placed, settings);
    const float unit = by.isFine ? kFineShare : 1.0f;
    const auto step = [&](float snap, float free) { return settings.snaps ? snap : unit * free; };
    Affine out = placed;
    if (settings.mode == GizmoMode::Scale) {
        const float factor = std::pow(1.0f + step(settings.scaleStep, kNudgeStretch), by.direction);
        for (int axis = 0; axis < 3; ++axis) {
            if (!by.axis || axis == *by.axis) { out.linear[axis] *= factor; }
        }
    } else if (settings.mode == GizmoMode::Move && by.axis) {
        out.translation +=
            axes[*by.axis] * (by.direction * step(settings.moveStep, kNudgeShare * handleMetres));
    } else if (settings.mode == GizmoMode::Rotate && by.axis) {
        const float degrees = by.direction * step(settings.turnStepDeg, kNudgeDegrees);
        out.linear = rotate(axes[*by.axis], degrees * kPi / 180.0f).linear * placed.linear;
    }
    return out;
}

Affine Gizmo::drag(const GizmoSettings& settings, const ScreenView& view, Vec2 mouse, bool snaps) const {
    if (mouse == from_) { return start_; }
    if (settings.mode == GizmoMode::Rotate) { return turned(settings, view, mouse, snaps); }
    return settings.mode == GizmoMode::Scale ? stretched(settings, view, mouse, snaps)
                                             : moved(settings, view, mouse, snaps);
}

}  // namespace glint
