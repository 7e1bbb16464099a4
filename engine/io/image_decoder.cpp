// stb_image comes compiled from the distribution's libstb; only its declarations are included.
#include "engine/io/image_decoder.h"

#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <stb/stb_image.h>

#include "engine/io/file_kind.h"
#include "engine/io/hdr_check.h"
#include "engine/io/image_formats.h"
#include "engine/io/image_io.h"

namespace glint {
namespace {

/// Bounds on compression, so that a small file cannot ask for much memory and time. Deflate reaches 1032 : 1
/// and a PNG pixel takes at least a bit. An HDR run of at most 127 bytes takes 2, and a pixel has 4.
constexpr uint64_t kMostPixelsPerByte = 8 * 1032;
constexpr uint64_t kMostHdrPixelsPerByte = 16;

Error imageError(const std::string& path, std::string message) {
    return {std::move(message), {.file = path}};
}

const stbi_uc* stbBytes(std::string_view bytes) { return reinterpret_cast<const stbi_uc*>(bytes.data()); }

bool isHdr(std::string_view bytes) {
    return stbi_is_hdr_from_memory(stbBytes(bytes), static_cast<int>(bytes.size())) != 0;
}

/// Why stb_image found no header: it says "unknown type" also of known types whose header is wrong.
std::string unreadableReason(const std::string& bytes) {
    if (const ImageFormat* format = imageFormatOf("", bytes); format != nullptr) {
        return fmt::format("is a broken {} image, or a too large one; at most {} pixels are read",
                           format->name, kMaxImagePixels);
    }
    return fmt::format("is not an image that can be read; expected {}", listReadableImages());
}

/// Checks the size that the header states, before stb allocates for it.
Status checkHeader(const std::string& bytes, const std::string& path) {
    if (bytes.empty()) {
        return imageError(path, fmt::format("the file is empty; expected {}", listReadableImages()));
    }
    if (bytes.size() > INT32_MAX) {
        return imageError(path,
                          fmt::format("has {} bytes; an image file may have at most 2 GiB", bytes.size()));
    }
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(stbBytes(bytes), static_cast<int>(bytes.size()), &width, &height, &channels) ==
        0) {
        return imageError(path, unreadableReason(bytes));
    }
    if (width <= 0 || height <= 0) {
        return imageError(path, fmt::format("the image has no pixels ({} x {})", width, height));
    }
    const uint64_t pixels = static_cast<uint64_t>(width) * static_cast<uint64_t>(height);
    if (pixels > kMaxImagePixels) {
        return imageError(path, fmt::format("the image is too large ({} x {}); at most {} pixels are read",
                                            width, height, kMaxImagePixels));
    }
    if (pixels / (isHdr(bytes) ? kMostHdrPixelsPerByte : kMostPixelsPerByte) > bytes.size()) {
        return imageError(
            path, fmt::format("the image is broken or cut off: {} x {} pixels cannot be in {} bytes", width,
                              height, bytes.size()));
    }
    if (isHdr(bytes) && !hdrPixelsAreWhole(bytes, width, height)) {
        return imageError(path, "the image is broken or cut off (not all of its pixels are there)");
    }
    return {};
}

Error brokenImage(const std::string& path) {
    return imageError(path, fmt::format("the image is broken or cut off ({})", stbi_failure_reason()));
}

/// Decodes with stb's `load`, for 8-bit or float components.
template <typename ImageFile, typename Load>
Result<std::shared_ptr<ImageFile>> decodeWith(Load load, const std::string& bytes, const std::string& path) {
    if (Status header = checkHeader(bytes, path); !header) { return header.error(); }
    auto image = std::make_shared<ImageFile>();
    int channels = 0;
    auto* pixels =
        load(stbBytes(bytes), static_cast<int>(bytes.size()), &image->width, &image->height, &channels, 3);
    if (pixels == nullptr) { return brokenImage(path); }
    image->rgb.assign(
        pixels, pixels + size_t{3} * static_cast<size_t>(image->width) * static_cast<size_t>(image->height));
    stbi_image_free(pixels);
    return image;
}

Status checkFinite(const ImageF& image, const std::string& path) {
    for (size_t i = 0; i < image.rgb.size(); ++i) {
        if (!std::isfinite(image.rgb[i])) {
            const size_t pixel = i / 3;
            const size_t width = static_cast<size_t>(image.width);
            return imageError(path,
                              fmt::format("the pixel in column {}, row {} is {}; expected finite numbers",
                                          pixel % width, pixel / width, image.rgb[i]));
        }
    }
    return {};
}

}  // namespace

Result<SceneImage> decode8(const std::string& bytes, const std::string& path) {
    auto image = decodeWith<Image8>(stbi_load_from_memory, bytes, path);
    if (!image) { return image.error(); }
    return SceneImage{.bytes = std::move(*image)};
}

Result<SceneImage> decodeHdr(const std::string& bytes, const std::string& path) {
    auto image = decodeWith<ImageF>(stbi_loadf_from_memory, bytes, path);
    if (!image) { return image.error(); }
    if (Status finite = checkFinite(**image, path); !finite) { return finite.error(); }
    return SceneImage{.floats = std::move(*image)};
}

std::optional<uint64_t> statedPixelBytes(const std::string& path) {
    const std::string head = readHead(path, size_t{64} << 10);
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(stbBytes(head), static_cast<int>(head.size()), &width, &height, &channels) ==
            0 ||
        width <= 0 || height <= 0) {
        return {};
    }
    return uint64_t{3} * static_cast<uint64_t>(width) * static_cast<uint64_t>(height) *
           (isHdr(head) ? sizeof(float) : 1);
}

}  // namespace glint
