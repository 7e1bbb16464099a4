// JPEG through libjpeg-turbo. Its errors are left by longjmp, which runs no destructors: what has one lives
// outside of the functions that the library is called from.
#include <csetjmp>
#include <cstdio>
#include <cstring>

#include <jerror.h>
#include <jpeglib.h>

#include "engine/io/exif.h"
#include "engine/io/image_builder.h"
#include "engine/io/image_formats.h"

namespace glint {
namespace {

/// A block of 8 x 8 pixels takes at least a bit.
constexpr double kMostPixelsPerByte = 512.0;
/// Each scan of a progressive picture decodes all of it again.
constexpr int kMostScans = 500;

struct Reading {
    const std::string& bytes;
    const std::string& path;
    jpeg_decompress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg_progress_mgr progress{};
    std::jmp_buf giveUp{};
    char reason[JMSG_LENGTH_MAX] = {};
    Status size{};
    std::optional<Image8Builder> builder{};
    std::vector<uint8_t> stored{}, rgba{};
};

void onError(j_common_ptr jpeg) {
    auto* reading = static_cast<Reading*>(jpeg->client_data);
    jpeg->err->format_message(jpeg, reading->reason);
    std::longjmp(reading->giveUp, 1);
}

/// Where libjpeg would go on with made-up pixels, it gives up; what costs no pixel is passed over.
void onMessage(j_common_ptr jpeg, int level) {
    const int code = jpeg->err->msg_code;
    const bool isHarmless = level >= 0 || code == JWRN_EXTRANEOUS_DATA || code == JWRN_JFIF_MAJOR ||
                            code == JWRN_ADOBE_XFORM || code == JWRN_BOGUS_PROGRESSION;
    if (!isHarmless) { onError(jpeg); }
}

void onProgress(j_common_ptr common) {
    auto* reading = static_cast<Reading*>(common->client_data);
    if (reading->jpeg.input_scan_number > kMostScans) {
        std::snprintf(reading->reason, sizeof reading->reason, "it has more than %d scans", kMostScans);
        std::longjmp(reading->giveUp, 1);
    }
}

[[gnu::noinline]] void readHeader(Reading* reading) {
    jpeg_decompress_struct& jpeg = reading->jpeg;
    jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(reading->bytes.data()), reading->bytes.size());
    jpeg_read_header(&jpeg, TRUE);
    reading->size = checkStatedSize(reading->path, jpeg.image_width, jpeg.image_height, reading->bytes.size(),
                                    kMostPixelsPerByte);
    if (!reading->size) { return; }
    jpeg.out_color_space = jpeg.num_components == 4 ? JCS_CMYK : JCS_RGB;
    jpeg_start_decompress(&jpeg);
    reading->builder.emplace(PixelPlaces{static_cast<int>(jpeg.output_width),
                                         static_cast<int>(jpeg.output_height),
                                         jpegOrientation(reading->bytes)});
    reading->stored.resize(size_t{jpeg.output_width} * static_cast<size_t>(jpeg.output_components));
    reading->rgba.assign(size_t{4} * jpeg.output_width, 255);
}

/// Cyan, magenta and yellow darken red, green and blue. Adobe's programs store what is left of the
/// light instead.
void setRowFromCmyk(Reading* reading, int row) {
    for (size_t i = 0; i < reading->stored.size(); i += 4) {
        const auto light = [&](size_t c) {
            const int stored = reading->stored[i + c];
            return reading->jpeg.saw_Adobe_marker != 0 ? stored : 255 - stored;
        };
        for (size_t c = 0; c < 3; ++c) {
            reading->rgba[i + c] = static_cast<uint8_t>((light(c) * light(3) + 127) / 255);
        }
    }
    reading->builder->setRow(row, reading->rgba);
}

void setRowFromRgb(Reading* reading, int row) {
    for (size_t i = 0; i < reading->stored.size() / 3; ++i) {
        std::copy_n(&reading->stored[3 * i], 3, &reading->rgba[4 * i]);
    }
    reading->builder->setRow(row, reading->rgba);
}

[[gnu::noinline]] void readRows(Reading* reading) {
    jpeg_decompress_struct& jpeg = reading->jpeg;
    while (jpeg.output_scanline < jpeg.output_height) {
        const int row = static_cast<int>(jpeg.output_scanline);
        unsigned char* stored = reading->stored.data();
        jpeg_read_scanlines(&jpeg, &stored, 1);
        jpeg.output_components == 4 ? setRowFromCmyk(reading, row) : setRowFromRgb(reading, row);
    }
    jpeg_finish_decompress(&jpeg);
}

/// False where libjpeg has given up. What is inlined here would have its variables in the frame that longjmp
/// comes back to, which is why the two readers are not.
bool readImage(Reading* reading) {
    if (setjmp(reading->giveUp) != 0) { return false; }
    jpeg_create_decompress(&reading->jpeg);
    reading->jpeg.client_data = reading;
    reading->jpeg.progress = &reading->progress;
    readHeader(reading);
    if (reading->size) { readRows(reading); }
    return true;
}

Result<SceneImage> decode(const std::string& bytes, const std::string& path) {
    Reading reading{.bytes = bytes, .path = path};
    reading.jpeg.err = jpeg_std_error(&reading.errors);
    reading.jpeg.client_data = &reading;
    reading.errors.error_exit = onError;
    reading.errors.emit_message = onMessage;
    reading.progress.progress_monitor = onProgress;
    const bool whole = readImage(&reading);
    jpeg_destroy_decompress(&reading.jpeg);
    if (!whole) { return brokenImage(path, reading.reason); }
    if (!reading.size) { return reading.size.error(); }
    return reading.builder->take();
}

}  // namespace

extern const ImageFormat kImageJpeg;
const ImageFormat kImageJpeg{.name = "JPEG",
                             .extensions = ".jpg .jpeg",
                             .looksLike = [](std::string_view head) { return head.starts_with("\xff\xd8"); },
                             .decode = decode};

}  // namespace glint
