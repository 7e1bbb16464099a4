// The image's area: draws it, and turns the mouse and the keyboard into camera moves and clicks to focus.
#pragma once

#include <optional>

#include "viewer/model/workspace.h"
#include "viewer/window/image_pane.h"

namespace glint {

class ImageView {
  public:
    /// Draws into the given rectangle (ImGui units). Returns true while the user holds the camera.
    bool draw(Workspace* workspace, const ImagePanes& panes, Vec2 min, Vec2 max);

    /// The film's pixel under the mouse.
    const std::optional<Vec2i>& hoveredPixel() const { return hoveredPixel_; }
    /// While the image is split: the mouse is on the side that otherSnapshot() is on.
    bool hoversOther() const { return hoversOther_; }
    /// Screen units per film pixel.
    float zoom() const { return zoom_; }

  private:
    void placeImage(const Workspace& workspace, Vec2 min, Vec2 max);
    void findPixel(const Workspace& workspace);
    void pick(Workspace* workspace, bool isClick);
    void drawOverlay(const FocusOverlay& overlay, const ImageDisplay& display) const;
    Vec2 dragged(bool held);
    bool navigate(Camera* camera, bool hovered, bool held);

    Vec2 imageMin_{0.0f};
    Vec2 imageMax_{0.0f};
    float zoom_ = 1.0f;
    double lastWheel_ = -1.0;
    bool isDragging_ = false;
    std::optional<Vec2i> hoveredPixel_;
    bool hoversOther_ = false;
};

}  // namespace glint
