// The handles of the selected object or light over the picture, and the mouse that drags them.
#pragma once

#include <array>
#include <functional>
#include <memory>

#include "viewer/model/gizmo.h"
#include "viewer/model/workspace.h"

namespace glint {

class GizmoView {
  public:
    /// `held`: the mouse holds the image's area, which was drawn last; `hovered`: it is over it. True: the
    /// mouse is on a handle or drags one, and nothing else is to follow it.
    bool handle(Workspace* workspace, const PlacedImage& placed, bool hovered, bool held);
    void draw() const;
    /// A key that moves the selection is down.
    bool isNudging() const { return isNudging_; }

  private:
    /// What the handles are of.
    struct Target {
        GizmoSettings settings;
        Affine placed;
        std::optional<Vec3> beam;  ///< where it shines, of unit length
        std::function<void(const Affine&)> place;
    };
    struct Mark {
        Vec2 at;
        int light;
    };
    std::optional<Target> targetOf(Workspace* workspace);
    /// True: a key has moved it.
    bool nudge(const KeyMap& keys, const ScreenView& view, const Target& target);
    bool handleMarks(Workspace* workspace, const ScreenView& view, Vec2 mouse, bool isPressed);
    Vec3 pivotOf(const SceneDescription& scene, const Object& object);

    Gizmo gizmo_;
    std::vector<GizmoHandle> handles_;
    std::vector<Mark> marks_;
    std::vector<Vec2> beam_;  ///< on the screen; empty: none
    std::optional<GizmoHandle> meant_;
    bool wasHeld_ = false;
    bool isNudging_ = false;
    std::array<bool, 8> isMeant_{};  ///< of each key that nudges: it was pressed for that, and is held
    std::shared_ptr<const MeshData> pivotMesh_;  ///< that `meshPivot_` is of
    Vec3 meshPivot_{0.0f};
};

}  // namespace glint
