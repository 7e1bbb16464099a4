// PNG through libpng. Its errors arrive by longjmp, which runs no destructors: what has one lives outside of
// the functions that libpng calls are made from.
#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>

#include <fmt/format.h>
#include <png.h>

#include "engine/io/exif.h"
#include "engine/io/image_builder.h"
#include "engine/io/image_formats.h"
#include "engine/io/image_io.h"

namespace glint {
namespace {

/// Deflate reaches 1032 : 1, and a pixel takes at least a bit.
constexpr double kMostPixelsPerByte = 8.0 * 1032.0;

struct Reading {
    std::string_view rest;
    const std::string& path;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::string reason = {};  ///< libpng's own, when it gives up
    Status size = {};
    std::optional<Image8Builder> builder = {};
    std::vector<uint8_t> rows = {};
    std::vector<std::array<uint8_t, 4>> palette = {};  ///< empty: the pixels are no indices
    std::vector<uint8_t> colors = {};                  ///< a row of those of the palette
};

void onError(png_structp png, png_const_charp message) {
    static_cast<Reading*>(png_get_error_ptr(png))->reason = message;
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

void readBytes(png_structp png, png_bytep out, size_t count) {
    auto* reading = static_cast<Reading*>(png_get_io_ptr(png));
    if (count > reading->rest.size()) { png_error(png, "the file ends too early"); }
    std::memcpy(out, reading->rest.data(), count);
    reading->rest.remove_prefix(count);
}

Orientation orientationOf(const Reading& reading) {
    png_bytep exif = nullptr;
    png_uint_32 size = 0;
    const bool found = png_get_eXIf_1(reading.png, reading.info, &size, &exif) != 0;
    return found ? exifOrientation({reinterpret_cast<const char*>(exif), size}) : Orientation::TopLeft;
}

/// libpng would show what lies outside of the palette as black, and its own check sees nothing behind its
/// expansion: indices come as they are stored, one to a byte.
void readPalette(Reading* reading) {
    png_colorp colors = nullptr;
    png_bytep alphas = nullptr;
    int count = 0, alphaCount = 0;
    png_get_PLTE(reading->png, reading->info, &colors, &count);
    png_get_tRNS(reading->png, reading->info, &alphas, &alphaCount, nullptr);
    for (int i = 0; i < count; ++i) {
        const uint8_t alpha = i < alphaCount ? alphas[i] : uint8_t{255};
        reading->palette.push_back({colors[i].red, colors[i].green, colors[i].blue, alpha});
    }
    reading->colors.resize(size_t{4} * png_get_image_width(reading->png, reading->info));
    png_set_packing(reading->png);
}

/// `stored` is as libpng hands it out: colours, or indices into the palette.
void setRow(Reading* reading, int row, std::span<const uint8_t> stored) {
    if (reading->palette.empty()) { return reading->builder->setRow(row, stored); }
    for (size_t column = 0; column < stored.size(); ++column) {
        if (stored[column] >= reading->palette.size()) {
            reading->reason = fmt::format("the pixel in column {}, row {} has colour {} of a palette of {}",
                                          column, row, stored[column], reading->palette.size());
            png_longjmp(reading->png, 1);
        }
        std::ranges::copy(reading->palette[stored[column]], &reading->colors[4 * column]);
    }
    reading->builder->setRow(row, reading->colors);
}

void expandColors(png_structp png) {
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
}

[[gnu::noinline]] void readHeader(Reading* reading) {
    png_structp png = reading->png;
    png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // checkStatedSize() has the limit
    png_set_read_fn(png, reading, readBytes);
    const uint64_t bytes = reading->rest.size();
    png_read_info(png, reading->info);
    const auto width = png_get_image_width(png, reading->info);
    const auto height = png_get_image_height(png, reading->info);
    reading->size = checkStatedSize(reading->path, width, height, bytes, kMostPixelsPerByte);
    if (!reading->size) { return; }
    if (png_get_color_type(png, reading->info) == PNG_COLOR_TYPE_PALETTE) {
        readPalette(reading);
    } else {
        expandColors(png);
    }
    reading->builder.emplace(
        PixelPlaces{static_cast<int>(width), static_cast<int>(height), orientationOf(*reading)});
}

/// Interlaced pictures come in several passes over all of their rows.
[[gnu::noinline]] void readRows(Reading* reading) {
    const int passes = png_set_interlace_handling(reading->png);
    png_read_update_info(reading->png, reading->info);
    const PixelPlaces& places = reading->builder->places();
    const size_t bytesAPixel = reading->palette.empty() ? 4 : 1;
    const size_t rowSize = bytesAPixel * static_cast<size_t>(places.storedWidth);
    const bool interlaced = passes > 1;
    reading->rows.assign(interlaced ? rowSize * static_cast<size_t>(places.storedHeight) : rowSize, 0);
    for (int pass = 0; pass < passes; ++pass) {
        for (int row = 0; row < places.storedHeight; ++row) {
            uint8_t* stored = reading->rows.data() + (interlaced ? static_cast<size_t>(row) * rowSize : 0);
            png_read_row(reading->png, stored, nullptr);
            if (pass + 1 == passes) { setRow(reading, row, {stored, rowSize}); }
        }
    }
    png_read_end(reading->png, nullptr);
}

/// False where libpng has given up. What is inlined here would have its variables in the frame that longjmp
/// comes back to, which is why the two readers are not.
bool readImage(Reading* reading) {
    if (setjmp(png_jmpbuf(reading->png)) != 0) { return false; }
    readHeader(reading);
    if (reading->size) { readRows(reading); }
    return true;
}

Result<SceneImage> decode(const std::string& bytes, const std::string& path) {
    Reading reading{.rest = bytes, .path = path};
    reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, onError, onWarning);
    reading.info = reading.png != nullptr ? png_create_info_struct(reading.png) : nullptr;
    const bool whole = reading.info != nullptr && readImage(&reading);
    png_destroy_read_struct(&reading.png, &reading.info, nullptr);
    if (!whole) { return brokenImage(path, reading.reason); }
    if (!reading.size) { return reading.size.error(); }
    return reading.builder->take();
}

}  // namespace

extern const ImageFormat kImagePng;
const ImageFormat kImagePng{
    .name = "PNG",
    .extensions = ".png",
    .looksLike = [](std::string_view head) { return head.starts_with("\x89PNG"); },
    .decode = decode,
    .save = [](const std::string& path, const ImageForms& image) { return savePng(path, image.display()); }};

}  // namespace glint
