// stb_image_write comes compiled from the distribution's libstb; only its declarations are included.
#include "engine/io/image_io.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <stb/stb_image_write.h>

#include "engine/io/atomic_file.h"
#include "engine/io/file_kind.h"
#include "engine/io/foreign_kind.h"
#include "engine/io/image_builder.h"
#include "engine/io/image_formats.h"
#include "engine/math/color.h"

namespace glint {
namespace {

constexpr uint64_t kMaxImageFileBytes = uint64_t{2} << 30;

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

Result<SceneImage> decodeImage(const std::string& bytes, const std::string& path) {
    if (bytes.empty()) {
        return imageError(path, fmt::format("the file is empty; expected {}", listReadableImages()));
    }
    const ImageFormat* format = imageFormatOf(path, bytes);
    if (format == nullptr || !format->looksLike(bytes)) {
        return imageError(path, foreignImage(path, headOf(bytes)));
    }
    return format->decode(bytes, path);
}

Result<std::string> readImageFile(const std::string& path) {
    const auto isImage = [&](std::string_view head) {
        const ImageFormat* format = imageFormatOf(path, head);
        return format != nullptr && format->looksLike(head);
    };
    return readFileOfKind(path, isImage, kMaxImageFileBytes);
}

Status checkFinite(const ImageF& image, const std::string& path) {
    const auto found = std::ranges::find_if(image.rgb, [](float value) { return !std::isfinite(value); });
    if (found == image.rgb.end()) { return {}; }
    const auto pixel = static_cast<size_t>(found - image.rgb.begin()) / 3;
    const auto width = static_cast<size_t>(image.width);
    return imageError(path, fmt::format("the pixel in column {}, row {} is {}; expected finite numbers",
                                        pixel % width, pixel / width, *found));
}

Result<SceneImage> loadImage(const std::string& path) {
    const Result<std::string> bytes = readImageFile(path);
    if (!bytes) { return bytes.error(); }
    Result<SceneImage> image = decodeImage(*bytes, path);
    if (!image) { return image; }
    if (image->floats) {
        if (Status finite = checkFinite(*image->floats, path); !finite) { return finite.error(); }
    }
    image->source = FileSource{path};
    return image;
}

Result<std::shared_ptr<const Image8>> loadImage8(const std::string& path) {
    const Result<SceneImage> image = loadImage(path);
    if (!image) { return image.error(); }
    if (!image->bytes) {
        return imageError(path,
                          "holds high-dynamic-range values; expected an 8-bit image (PNG, JPEG, BMP, TGA)");
    }
    return image->bytes;
}

Result<std::shared_ptr<const ImageF>> loadImageF(const std::string& path) {
    const Result<SceneImage> image = loadImage(path);
    if (!image) { return image.error(); }
    return linearColors(*image);
}

std::shared_ptr<const ImageF> linearColors(const SceneImage& image) {
    return image.floats ? image.floats : decodedFromSrgb(*image.bytes);
}

Result<std::string> encodePng(const Image8& image, const std::string& path) {
    if (Status whole = checkToSave(image, path); !whole) { return whole.error(); }
    std::vector<uint8_t> pixels;
    for (size_t i = 0; i < image.alpha.size(); ++i) {
        pixels.insert(pixels.end(),
                      {image.rgb[3 * i], image.rgb[3 * i + 1], image.rgb[3 * i + 2], image.alpha[i]});
    }
    const int channels = pixels.empty() ? 3 : 4;
    std::string bytes;
    if (stbi_write_png_to_func(appendBytes, &bytes, image.width, image.height, channels,
                               pixels.empty() ? image.rgb.data() : pixels.data(),
                               channels * image.width) == 0) {
        return imageError(path, "not enough memory to compress the picture");
    }
    return bytes;
}

Status savePng(const std::string& path, const Image8& image) {
    const Result<std::string> bytes = encodePng(image, path);
    return bytes ? writeFileAtomically(path, *bytes) : Status(bytes.error());
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
