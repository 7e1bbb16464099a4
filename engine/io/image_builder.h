// What readers of picture files share: checks of what a header states, and pixels that come row by row.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "engine/base/result.h"
#include "engine/scene/image.h"

namespace glint {

Error imageError(const std::string& path, std::string message);
/// "the image is broken or cut off (reason)".
Error brokenImage(const std::string& path, std::string_view reason);

/// Before anything is allocated for them. Error: there are no pixels, more than kMaxImagePixels (image_io.h),
/// or more than `bytes` bytes can hold where the format packs at most `mostPixelsPerByte` into one.
Status checkStatedSize(const std::string& path, uint64_t width, uint64_t height, uint64_t bytes,
                       double mostPixelsPerByte);

/// The bits of `pixel` under `mask`, as a share of 255; `otherwise` where the mask is empty.
uint8_t maskedByte(uint32_t pixel, uint32_t mask, uint8_t otherwise);

/// The float of 2 or 4 bytes at `stored`.
float storedFloat(const uint8_t* stored, size_t bytes);

/// Which way up a picture is stored: the numbers 1 to 8 that TIFF and EXIF give to where its first row and
/// column belong.
enum class Orientation : uint8_t {
    TopLeft = 1,
    TopRight,
    BottomRight,
    BottomLeft,
    LeftTop,
    RightTop,
    RightBottom,
    LeftBottom
};

/// Where the pixels of a stored picture belong in the upright one.
struct PixelPlaces {
    int storedWidth = 0;
    int storedHeight = 0;
    Orientation orientation = Orientation::TopLeft;

    bool swapsSides() const { return orientation >= Orientation::LeftTop; }
    int width() const { return swapsSides() ? storedHeight : storedWidth; }
    int height() const { return swapsSides() ? storedWidth : storedHeight; }
    /// The index of a stored pixel in the upright picture, whose row 0 is the top row.
    size_t place(int column, int row) const;
};

/// An upright 8-bit picture in the making, from stored rows of red, green, blue and alpha. Rows that are
/// never set are black.
class Image8Builder {
  public:
    explicit Image8Builder(const PixelPlaces& places);

    const PixelPlaces& places() const { return places_; }
    /// `rgba` has 4 bytes for each pixel of the stored row.
    void setRow(int row, std::span<const uint8_t> rgba);
    /// `emptyAlphaIsNone`: of formats that have 4 channels where programs mean 3, and leave the last one 0.
    SceneImage take(bool emptyAlphaIsNone = false);

  private:
    PixelPlaces places_;
    std::shared_ptr<Image8> image_;
};

/// The same of linear floats, pixel by pixel.
class ImageFBuilder {
  public:
    explicit ImageFBuilder(const PixelPlaces& places);

    const PixelPlaces& places() const { return places_; }
    /// Red, green and blue of a stored pixel.
    float* pixel(int column, int row) { return &image_->rgb[3 * places_.place(column, row)]; }
    SceneImage take() { return {.floats = std::move(image_)}; }

  private:
    PixelPlaces places_;
    std::shared_ptr<ImageF> image_;
};

}  // namespace glint
