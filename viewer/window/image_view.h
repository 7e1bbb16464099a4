// The image's area: draws it, and turns the mouse and the keyboard into camera moves and clicks to focus.
#pragma once

#include <optional>

#include "viewer/model/workspace.h"
#include "viewer/window/gizmo_view.h"
#include "viewer/window/image_pane.h"
#include "viewer/window/region_view.h"

namespace glint {

class ImageView {
  public:
    /// Draws into the given rectangle (ImGui units). Returns true while the user holds the camera.
    bool draw(Workspace* workspace, const ImagePanes& panes, Vec2 min, Vec2 max);

    /// The film's pixel under the mouse.
    const std::optional<Vec2i>& hoveredPixel() const { return hoveredPixel_; }
    /// While the image is split: the mouse is on the side that otherSnapshot() is on.
    bool hoversOther() const { return hoversOther_; }
    /// Screen pixels per film pixel.
    float zoom() const { return placed_.zoom; }

  private:
    void findPixel(const Workspace& workspace, const ImageArea& area);
    void giveColor(const Workspace& workspace, bool isClick) const;
    void pick(Workspace* workspace, bool isClick);
    void takeMaterial(Workspace* workspace, const ImageArea& area);
    void drawOverlay(const FocusOverlay& overlay, const ImageDisplay& display) const;
    Vec2 dragged(bool held);
    bool navigate(Workspace* workspace, const ImageArea& area, bool hovered, bool held);
    void handleZoomKeys(const KeyMap& keys, const ImageArea& area, ImageFraming* framing) const;

    PlacedImage placed_;
    RegionView region_;
    GizmoView gizmo_;
    double lastWheel_ = -1.0;
    bool isDragging_ = false;
    bool drew_ = false;        ///< what is held moves a handle or draws a region: letting it go is no click
    float wheelSteps_ = 0.0f;  ///< of the zoom, less than one
    std::optional<Vec2i> hoveredPixel_;
    bool hoversOther_ = false;
};

}  // namespace glint
