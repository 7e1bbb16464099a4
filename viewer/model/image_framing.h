// How large the picture is drawn, and which part of it: zoom and pan of the image by itself, which no camera
// and no render knows of.
//
// Areas are in units of the window, of which a screen of high density has several pixels each; zooms count
// screen pixels per picture pixel.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engine/math/vec.h"

namespace glint {

/// Where a picture may be drawn.
struct ImageArea {
    Vec2 min{0.0f};
    Vec2 max{0.0f};
    Vec2i image{1};           ///< its size in pixels, at least 1
    float pixelScale = 1.0f;  ///< screen pixels per unit
};

/// Where it is drawn.
struct PlacedImage {
    Vec2 min{0.0f};  ///< on a screen pixel
    Vec2 max{0.0f};
    float unitsPerPixel = 1.0f;  ///< of the picture
    float zoom = 1.0f;
};

class ImageFraming {
  public:
    /// Automatic: the most screen pixels per picture pixel, a whole number, that there is room for; smaller
    /// pictures than 1:1 fit. Zoom: one of imageZooms().
    enum class Size { Automatic, Fit, Zoom };

    PlacedImage place(const ImageArea& area) const;

    /// Larger (steps > 0) or smaller by so many steps of imageZooms(); the picture's point at `at`, in units,
    /// stays there as far as the edges let it.
    void zoomBy(int steps, Vec2 at, const ImageArea& area);
    /// Moves it by these units, no farther than its edges.
    void panBy(Vec2 units, const ImageArea& area);

    /// As one choice: Automatic, Fit, then imageZooms().
    static std::vector<std::string> choices();
    int choice() const;
    void choose(int index);
    /// 1:1, around the same middle.
    void chooseOneToOne();

  private:
    Size size_ = Size::Automatic;
    size_t step_ = 0;    ///< of imageZooms(), where that is the size
    Vec2 middle_{0.5f};  ///< the picture's point in the area's middle, in shares, where that is the size
};

/// The pixel of the picture there, also beyond its edges.
Vec2i pixelAt(const PlacedImage& placed, Vec2 at);

/// From the smallest to the largest: whole numbers and their inverses, 1 among them.
std::span<const float> imageZooms();

}  // namespace glint
