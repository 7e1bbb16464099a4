#include "engine/io/image_builder.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include <fmt/format.h>
#include <half.h>

#include "engine/io/image_io.h"

namespace glint {
namespace {

size_t pixelCount(const PixelPlaces& places) {
    return static_cast<size_t>(places.storedWidth) * static_cast<size_t>(places.storedHeight);
}

/// Calls set(pixel of the upright picture, pixel of the row) for a stored row.
template <class Set>
void forEachPlace(const PixelPlaces& places, int row, Set set) {
    const size_t first = places.place(0, row);
    // Unsigned numbers wrap around, so that steps to the left and up are right too.
    const size_t step = places.storedWidth > 1 ? places.place(1, row) - first : 0;
    for (size_t i = 0; i < static_cast<size_t>(places.storedWidth); ++i) {
        set(first + i * step, i);
    }
}

}  // namespace

Error imageError(const std::string& path, std::string message) {
    return {std::move(message), {.file = path}};
}

Error brokenImage(const std::string& path, std::string_view reason) {
    return imageError(path, fmt::format("the image is broken or cut off ({})",
                                        reason.empty() ? "not all of its pixels are there" : reason));
}

Status checkStatedSize(const std::string& path, uint64_t width, uint64_t height, uint64_t bytes,
                       double mostPixelsPerByte) {
    if (width == 0 || height == 0) {
        return imageError(path, fmt::format("the image has no pixels ({} x {})", width, height));
    }
    if (width > kMaxImagePixels || height > kMaxImagePixels / width) {
        return imageError(path, fmt::format("the image is too large ({} x {}); at most {} pixels are read",
                                            width, height, kMaxImagePixels));
    }
    if (static_cast<double>(width * height) > mostPixelsPerByte * static_cast<double>(bytes)) {
        return imageError(
            path, fmt::format("the image is broken or cut off: {} x {} pixels cannot be in {} bytes", width,
                              height, bytes));
    }
    return {};
}

uint8_t maskedByte(uint32_t pixel, uint32_t mask, uint8_t otherwise) {
    if (mask == 0) { return otherwise; }
    const int shift = std::countr_zero(mask);
    return static_cast<uint8_t>(uint64_t{(pixel & mask) >> shift} * 255 / (mask >> shift));
}

float storedFloat(const uint8_t* stored, size_t bytes) {
    if (bytes == 2) {
        half value;
        uint16_t bits = 0;
        std::memcpy(&bits, stored, sizeof bits);
        value.setBits(bits);
        return value;
    }
    float value = 0.0f;
    std::memcpy(&value, stored, sizeof value);
    return value;
}

size_t PixelPlaces::place(int column, int row) const {
    using enum Orientation;
    const bool fromRight = orientation == TopRight || orientation == BottomRight || orientation == RightTop ||
                           orientation == RightBottom;
    const bool fromBottom = orientation == BottomRight || orientation == BottomLeft ||
                            orientation == RightBottom || orientation == LeftBottom;
    const int x = swapsSides() ? row : column;
    const int y = swapsSides() ? column : row;
    return static_cast<size_t>(fromBottom ? height() - 1 - y : y) * static_cast<size_t>(width()) +
           static_cast<size_t>(fromRight ? width() - 1 - x : x);
}

Image8Builder::Image8Builder(const PixelPlaces& places)
    : places_(places), image_(std::make_shared<Image8>(Image8{places.width(), places.height(), {}})) {
    image_->rgb.resize(3 * pixelCount(places));
}

void Image8Builder::setRow(int row, std::span<const uint8_t> rgba) {
    forEachPlace(places_, row, [&](size_t pixel, size_t i) {
        std::copy_n(&rgba[4 * i], 3, &image_->rgb[3 * pixel]);
        const uint8_t alpha = rgba[4 * i + 3];
        if (alpha != 255 && image_->alpha.empty()) { image_->alpha.assign(pixelCount(places_), 255); }
        if (!image_->alpha.empty()) { image_->alpha[pixel] = alpha; }
    });
}

SceneImage Image8Builder::take(bool emptyAlphaIsNone) {
    const bool isEmpty = std::ranges::all_of(image_->alpha, [](uint8_t alpha) { return alpha == 0; });
    if (emptyAlphaIsNone && isEmpty) { image_->alpha = {}; }
    return {.bytes = std::move(image_)};
}

ImageFBuilder::ImageFBuilder(const PixelPlaces& places)
    : places_(places), image_(std::make_shared<ImageF>(ImageF{places.width(), places.height(), {}})) {
    image_->rgb.resize(3 * pixelCount(places));
}

}  // namespace glint
