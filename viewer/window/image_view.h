// The picture's area: draws it, and turns the mouse and the keyboard into camera moves.
//
// Room for picking and click-to-focus: they belong here too, as further meanings of a click.
#pragma once

#include <optional>

#include "viewer/window/split_view.h"
#include "viewer/window/viewer_model.h"

namespace glint {

class ImageView {
  public:
    /// Draws into the given rectangle (ImGui units). Returns true while the user holds the camera.
    bool draw(ViewerModel* model, const ImageFiles& images, Vec2 min, Vec2 max);

    /// The film's pixel under the mouse.
    const std::optional<Vec2i>& hoveredPixel() const { return hoveredPixel_; }
    /// While the picture is split: the mouse is on the side of the integrator that snapshot() does not show.
    bool hoversOther() const { return hoversOther_; }
    /// Screen units per film pixel.
    float zoom() const { return zoom_; }

  private:
    void placeImage(const ViewerModel& model, Vec2 min, Vec2 max);
    bool navigate(Camera* camera, bool hovered, bool held);

    Vec2 imageMin_{0.0f};
    Vec2 imageMax_{0.0f};
    float zoom_ = 1.0f;
    double lastWheel_ = -1.0;
    std::optional<Vec2i> hoveredPixel_;
    bool hoversOther_ = false;
};

}  // namespace glint
