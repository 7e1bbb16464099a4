// The picture's area: draws it, and turns the mouse and the keyboard into camera moves.
//
// Room for picking, click-to-focus and comparison: they belong here too, as further meanings of a click.
#pragma once

#include <optional>

#include "viewer/window/image_display.h"
#include "viewer/window/viewer_model.h"

namespace glint {

class ImageView {
  public:
    /// Draws into the given rectangle (ImGui units). Returns true while the user holds the camera.
    bool draw(ViewerModel* model, const ImageDisplay& display, Vec2 min, Vec2 max);

    /// The film's pixel under the mouse.
    const std::optional<Vec2i>& hoveredPixel() const { return hoveredPixel_; }
    /// Screen units per film pixel.
    float zoom() const { return zoom_; }

  private:
    void placePicture(const ViewerModel& model, Vec2 min, Vec2 max);
    bool navigate(Camera* camera, bool hovered, bool held);

    Vec2 pictureMin_{0.0f};
    Vec2 pictureMax_{0.0f};
    float zoom_ = 1.0f;
    double lastWheel_ = -1.0;
    std::optional<Vec2i> hoveredPixel_;
};

}  // namespace glint
