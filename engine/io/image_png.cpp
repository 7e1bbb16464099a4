// PNG through libpng. Its errors arrive by longjmp, which runs no destructors: what has one lives outside of
// the functions that libpng calls are made from.
#include <csetjmp>
#include <cstring>

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
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
    reading->builder.emplace(
        PixelPlaces{static_cast<int>(width), static_cast<int>(height), orientationOf(*reading)});
}

/// Interlaced pictures come in several passes over all of their rows.
[[gnu::noinline]] void readRows(Reading* reading) {
    const int passes = png_set_interlace_handling(reading->png);
    png_read_update_info(reading->png, reading->info);
    const PixelPlaces& places = reading->builder->places();
    const size_t rowSize = size_t{4} * static_cast<size_t>(places.storedWidth);
    const bool interlaced = passes > 1;
    reading->rows.assign(interlaced ? rowSize * static_cast<size_t>(places.storedHeight) : rowSize, 0);
    for (int pass = 0; pass < passes; ++pass) {
        for (int row = 0; row < places.storedHeight; ++row) {
            uint8_t* rgba = reading->rows.data() + (interlaced ? static_cast<size_t>(row) * rowSize : 0);
            png_read_row(reading->png, rgba, nullptr);
            if (pass + 1 == passes) { reading->builder->setRow(row, {rgba, rowSize}); }
        }
    }
    png_read_end(reading->png, nullptr);
}

/// False where libpng has given up. What is inlined here would have its variables in the frame that longjmp
/// comes back to, which is why the two readers are not.
bool readPicture(Reading* reading) {
    if (setjmp(png_jmpbuf(reading->png)) != 0) { return false; }
    readHeader(reading);
    if (reading->size) { readRows(reading); }
    return true;
}

Result<SceneImage> decode(const std::string& bytes, const std::string& path) {
    Reading reading{.rest = bytes, .path = path};
    reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, onError, onWarning);
    reading.info = reading.png != nullptr ? png_create_info_struct(reading.png) : nullptr;
    const bool whole = reading.info != nullptr && readPicture(&reading);
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
