// stb_image and stb_image_write come compiled from the distribution's libstb; only their declarations
// are included.
#include "engine/io/image_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include "engine/io/atomic_file.h"
#include "engine/io/exr_io.h"
#include "engine/io/hdr_check.h"
#include "engine/math/color.h"

namespace glint {
namespace {

constexpr const char* kExpectedFormats = "expected PNG, JPEG, BMP, TGA, HDR or EXR";

/// Bounds on compression, so that a small file cannot ask for much memory and time. Deflate reaches 1032 : 1
/// and a PNG pixel takes at least a bit. An HDR run of at most 127 bytes takes 2, and a pixel has 4.
constexpr uint64_t kMostPixelsPerByte = 8 * 1032;
constexpr uint64_t kMostHdrPixelsPerByte = 16;

Error imageError(const std::string& path, std::string message) {
    return {std::move(message), {.file = path}};
}

const stbi_uc* stbBytes(const std::string& bytes) { return reinterpret_cast<const stbi_uc*>(bytes.data()); }

bool looksLikeHdr(const std::string& bytes) {
    return stbi_is_hdr_from_memory(stbBytes(bytes), static_cast<int>(bytes.size())) != 0;
}

/// Why stb_image found no header: it says "unknown type" also of known types whose header is wrong.
std::string unreadableReason(const std::string& bytes) {
    static constexpr std::pair<std::string_view, const char*> kKinds[] = {
        {"\x89PNG", "PNG"}, {"\xff\xd8\xff", "JPEG"}, {"BM", "BMP"}, {"#?", "HDR"}, {"GIF8", "GIF"}};
    for (const auto& [magic, kind] : kKinds) {
        if (bytes.starts_with(magic)) {
            return fmt::format("is a broken {} image, or a too large one; at most {} pixels are read", kind,
                               kMaxImagePixels);
        }
    }
    return fmt::format("is not an image that can be read; {}", kExpectedFormats);
}

/// Checks the size that the header states, before stb allocates for it.
Status checkHeader(const std::string& bytes, const std::string& path) {
    if (bytes.empty()) { return imageError(path, fmt::format("the file is empty; {}", kExpectedFormats)); }
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
    if (pixels / (looksLikeHdr(bytes) ? kMostHdrPixelsPerByte : kMostPixelsPerByte) > bytes.size()) {
        return imageError(
            path, fmt::format("the image is broken or cut off: {} x {} pixels cannot be in {} bytes", width,
                              height, bytes.size()));
    }
    if (looksLikeHdr(bytes) && !hdrPixelsAreWhole(bytes, width, height)) {
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

Result<std::shared_ptr<const Image8>> decode8(const std::string& bytes, const std::string& path) {
    const auto image = decodeWith<Image8>(stbi_load_from_memory, bytes, path);
    if (!image) { return image.error(); }
    return std::shared_ptr<const Image8>(*image);
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

Result<std::shared_ptr<const ImageF>> decodeHdr(const std::string& bytes, const std::string& path) {
    const auto image = decodeWith<ImageF>(stbi_loadf_from_memory, bytes, path);
    if (!image) { return image.error(); }
    if (Status finite = checkFinite(**image, path); !finite) { return finite.error(); }
    return std::shared_ptr<const ImageF>(*image);
}

Result<std::shared_ptr<const ImageF>> decodeExrColor(const std::string& bytes, const std::string& path) {
    const Result<ExrImage> image = decodeExr(bytes, path);
    if (!image) { return image.error(); }
    Result<ImageF> color = exrColor(*image, path);
    if (!color) { return color.error(); }
    return std::shared_ptr<const ImageF>(std::make_shared<ImageF>(std::move(color).value()));
}

std::shared_ptr<const ImageF> decodedFromSrgb(const Image8& image) {
    std::array<float, 256> linear{};
    for (size_t i = 0; i < linear.size(); ++i) {
        linear[i] = srgbToLinear(static_cast<float>(i) / 255.0f);
    }
    auto out = std::make_shared<ImageF>();
    out->width = image.width;
    out->height = image.height;
    out->rgb.reserve(image.rgb.size());
    for (const uint8_t byte : image.rgb) {
        out->rgb.push_back(linear[byte]);
    }
    return out;
}

void appendBytes(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<size_t>(size));
}

template <class Image>
Status checkToSave(const Image& image, const std::string& path) {
    const bool whole =
        image.width > 0 && image.height > 0 &&
        image.rgb.size() == size_t{3} * static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
    return whole ? Status() : Status(imageError(path, "there is no picture to save"));
}

}  // namespace

Result<std::shared_ptr<const Image8>> loadImage8(const std::string& path) {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) { return bytes.error(); }
    if (looksLikeExr(*bytes) || looksLikeHdr(*bytes)) {
        return imageError(path,
                          "holds high-dynamic-range values; expected an 8-bit image (PNG, JPEG, BMP, TGA)");
    }
    return decode8(*bytes, path);
}

Result<std::shared_ptr<const ImageF>> loadImageF(const std::string& path) {
    const Result<ImageSource> source = loadImage(path);
    if (!source) { return source.error(); }
    return linearColors(*source);
}

std::shared_ptr<const ImageF> linearColors(const ImageSource& image) {
    return image.floats ? image.floats : decodedFromSrgb(*image.bytes);
}

Result<ImageSource> loadImage(const std::string& path) {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) { return bytes.error(); }
    ImageSource source{.path = path, .bytes = nullptr, .floats = nullptr};
    if (looksLikeExr(*bytes) || looksLikeHdr(*bytes)) {
        auto floats = looksLikeExr(*bytes) ? decodeExrColor(*bytes, path) : decodeHdr(*bytes, path);
        if (!floats) { return floats.error(); }
        source.floats = std::move(floats).value();
    } else {
        auto decoded = decode8(*bytes, path);
        if (!decoded) { return decoded.error(); }
        source.bytes = std::move(decoded).value();
    }
    return source;
}

std::optional<uint64_t> statedPixelBytes(const std::string& path) {
    if (!checkRegularFile(path, "an image")) { return {}; }
    std::string head(size_t{64} << 10, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(stbBytes(head), static_cast<int>(head.size()), &width, &height, &channels) ==
            0 ||
        width <= 0 || height <= 0) {
        return {};
    }
    return uint64_t{3} * static_cast<uint64_t>(width) * static_cast<uint64_t>(height) *
           (looksLikeHdr(head) ? sizeof(float) : 1);
}

Status savePng(const std::string& path, const Image8& image) {
    if (Status whole = checkToSave(image, path); !whole) { return whole; }
    std::string bytes;
    if (stbi_write_png_to_func(appendBytes, &bytes, image.width, image.height, 3, image.rgb.data(),
                               3 * image.width) == 0) {
        return imageError(path, "not enough memory to compress the picture");
    }
    return writeFileAtomically(path, bytes);
}

Status saveHdr(const std::string& path, const ImageF& image) {
    if (Status whole = checkToSave(image, path); !whole) { return whole; }
    std::vector<float> representable(image.rgb);
    for (float& value : representable) {
        value = clampf(value, 0.0f, 1e38f);
    }
    std::string bytes;
    if (stbi_write_hdr_to_func(appendBytes, &bytes, image.width, image.height, 3, representable.data()) ==
        0) {
        return imageError(path, "not enough memory to encode the picture");
    }
    return writeFileAtomically(path, bytes);
}

}  // namespace glint
