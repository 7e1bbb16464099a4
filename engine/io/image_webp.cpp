// WebP through libwebp.
#include <webp/decode.h>

#include "engine/io/exif.h"
#include "engine/io/image_builder.h"
#include "engine/io/image_formats.h"

namespace glint {
namespace {

/// A picture of one colour needs no bits for its pixels; libwebp reads sides up to 16383.
constexpr double kMostPixelsPerByte = 1e9;

std::string_view reasonOf(VP8StatusCode code) {
    switch (code) {
        case VP8_STATUS_OUT_OF_MEMORY:
            return "there is not enough memory for it";
        case VP8_STATUS_NOT_ENOUGH_DATA:
        case VP8_STATUS_SUSPENDED:
            return "the file ends too early";
        case VP8_STATUS_UNSUPPORTED_FEATURE:
            return "it uses a feature that libwebp does not know";
        default:
            return "its data are wrong";
    }
}

Result<SceneImage> decode(const std::string& bytes, const std::string& path) {
    WebPDecoderConfig config;
    if (WebPInitDecoderConfig(&config) == 0) { return imageError(path, "libwebp is of another version"); }
    const auto* data = reinterpret_cast<const uint8_t*>(bytes.data());
    if (const VP8StatusCode code = WebPGetFeatures(data, bytes.size(), &config.input);
        code != VP8_STATUS_OK) {
        return brokenImage(path, reasonOf(code));
    }
    if (config.input.has_animation != 0) {
        return imageError(path, "is an animation; expected a WebP image that stands still");
    }
    const auto width = static_cast<size_t>(config.input.width);
    const auto height = static_cast<size_t>(config.input.height);
    if (Status size = checkStatedSize(path, width, height, bytes.size(), kMostPixelsPerByte); !size) {
        return size.error();
    }
    std::vector<uint8_t> rgba(4 * width * height);
    config.output.colorspace = MODE_RGBA;
    config.output.is_external_memory = 1;
    config.output.u.RGBA = {rgba.data(), static_cast<int>(4 * width), rgba.size()};
    const VP8StatusCode code = WebPDecode(data, bytes.size(), &config);
    WebPFreeDecBuffer(&config.output);
    if (code != VP8_STATUS_OK) { return brokenImage(path, reasonOf(code)); }
    Image8Builder builder({config.input.width, config.input.height, webpOrientation(bytes)});
    for (size_t row = 0; row < height; ++row) {
        builder.setRow(static_cast<int>(row), std::span(rgba).subspan(4 * width * row, 4 * width));
    }
    return builder.take();
}

}  // namespace

extern const ImageFormat kImageWebp;
const ImageFormat kImageWebp{.name = "WebP",
                             .extensions = ".webp",
                             .looksLike =
                                 [](std::string_view head) {
                                     return head.starts_with("RIFF") && head.substr(0, 12).ends_with("WEBP");
                                 },
                             .decode = decode};

}  // namespace glint
