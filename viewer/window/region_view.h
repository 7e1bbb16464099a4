// The region over the picture: drawn with the mouse, framed, and the spot that follows the mouse.
#pragma once

#include <optional>

#include "viewer/model/workspace.h"

namespace glint {

class RegionView {
  public:
    /// `held`: the mouse holds the image's area, which was drawn last; `hovered`: the pixel that it is on.
    /// True: the mouse draws a region, and nothing else is to follow it.
    bool handle(Workspace* workspace, const PlacedImage& placed, const std::optional<Vec2i>& hovered,
                bool held);
    void draw(const Workspace& workspace, const PlacedImage& placed) const;

  private:
    std::optional<Vec2i> began_;
    Vec2i at_{0};
};

}  // namespace glint
