// The handles of the selected object over the picture, and the mouse that drags them.
#pragma once

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

  private:
    Vec3 pivotOf(const SceneDescription& scene, const Object& object);

    Gizmo gizmo_;
    std::vector<GizmoHandle> handles_;
    std::optional<GizmoHandle> meant_;
    bool wasHeld_ = false;
    std::shared_ptr<const MeshData> pivotMesh_;  ///< that `meshPivot_` is of
    Vec3 meshPivot_{0.0f};
};

}  // namespace glint
