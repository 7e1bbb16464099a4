// Moving, turning and stretching an object with the mouse: where the handles are on the screen, which of them
// is meant, and what a drag does. Nothing here draws.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/math/ray.h"
#include "engine/math/transform.h"
#include "engine/scene/camera.h"
#include "viewer/model/image_framing.h"

namespace glint {

enum class GizmoMode : uint8_t { Off, Move, Rotate, Scale };

struct GizmoSettings {
    GizmoMode mode = GizmoMode::Off;
    bool isLocal = false;  ///< along the object's own axes; scaling always is
    bool snaps = false;
    float moveStep = 0.1f;  ///< metres
    float turnStepDeg = 15.0f;
    float scaleStep = 0.1f;
};

/// The camera as the picture on the screen shows the scene, through the lens's centre.
class ScreenView {
  public:
    ScreenView(const Camera& camera, Vec2i image, const PlacedImage& placed);
    /// Nothing for what is behind the camera.
    std::optional<Vec2> project(const Vec3& point) const;
    /// From the camera through that place of the screen; its direction has unit length.
    Ray rayAt(Vec2 screen) const;
    const Vec3& position() const { return position_; }
    /// Metres at the point's depth that `units` of the screen are.
    float metresPer(float units, const Vec3& point) const;

  private:
    Vec3 position_;
    CameraAxes view_;
    /// half of what the picture shows, and its middle off the axis: at a depth of 1, or of parallel rays
    Vec2 half_{1.0f}, middle_{0.0f};
    bool isParallel_ = false;
    PlacedImage placed_;
};

struct GizmoHandle {
    enum class Kind : uint8_t { Axis, Ring, Middle };
    Kind kind = Kind::Axis;
    int axis = 0;
    std::vector<Vec2> line;  ///< on the screen; of the middle, one point
};

/// A step of a key instead of the mouse.
struct GizmoNudge {
    std::optional<int> axis;  ///< without one: all, which is for sizes alone
    float direction = 1.0f;   ///< 1 or -1
    bool isFine = false;      ///< a tenth of it
};

class Gizmo {
  public:
    /// The handles of a placed object; none where it is behind the camera.
    std::vector<GizmoHandle> handles(const Affine& placed, const GizmoSettings& settings,
                                     const ScreenView& view, float lengthUnits) const;
    /// The one that is nearest to the mouse within `reach` units.
    static std::optional<GizmoHandle> nearest(const std::vector<GizmoHandle>& handles, Vec2 mouse,
                                              float reach);

    void begin(const GizmoHandle& handle, const Affine& placed, const GizmoSettings& settings,
               const ScreenView& view, Vec2 mouse);
    /// The object's place for the mouse as it is now. `snaps`: in the settings' steps.
    Affine drag(const GizmoSettings& settings, const ScreenView& view, Vec2 mouse, bool snaps) const;
    /// The object's place after one step of a key: one of the settings' where it snaps, otherwise 5 degrees,
    /// 5 % or a tenth of a handle of `handleMetres`. A step and the one back lead to the same place.
    static Affine nudged(const Affine& placed, const GizmoSettings& settings, const GizmoNudge& by,
                         float handleMetres);
    bool isDragging() const { return isDragging_; }
    const GizmoHandle& held() const { return held_; }
    void end() { isDragging_ = false; }

  private:
    Affine moved(const GizmoSettings& settings, const ScreenView& view, Vec2 mouse, bool snaps) const;
    Affine turned(const GizmoSettings& settings, const ScreenView& view, Vec2 mouse, bool snaps) const;
    Affine stretched(const GizmoSettings& settings, const ScreenView& view, Vec2 mouse, bool snaps) const;
    float along(const ScreenView& view, Vec2 mouse) const;
    float angle(const ScreenView& view, Vec2 mouse) const;

    bool isDragging_ = false;
    GizmoHandle held_;
    Affine start_;
    Mat3 axes_{1.0f};
    Vec2 from_{0.0f};
    float startParameter_ = 0.0f;
};

}  // namespace glint
