#include "engine/io/image_formats.h"

#include <algorithm>
#include <vector>

#include "engine/base/nearest_name.h"
#include "engine/io/file_kind.h"
#include "engine/io/image_decoder.h"
#include "engine/io/image_io.h"

namespace glint {
namespace {

/// Whether the 18 bytes of a TGA header make sense: the format has no mark of its own.
bool looksLikeTga(std::string_view head) {
    if (head.size() < 18) { return false; }
    const auto byte = [head](size_t i) { return static_cast<uint8_t>(head[i]); };
    const auto isOneOf = [](int value, std::initializer_list<int> known) {
        return std::find(known.begin(), known.end(), value) != known.end();
    };
    const bool hasPalette = byte(1) == 1;
    const bool isKnownKind = hasPalette ? isOneOf(byte(2), {1, 9}) : isOneOf(byte(2), {2, 3, 10, 11});
    const bool hasSize = (byte(12) | byte(13)) != 0 && (byte(14) | byte(15)) != 0;
    return byte(1) <= 1 && isKnownKind && hasSize && isOneOf(byte(16), {8, 15, 16, 24, 32});
}

Result<SceneImage> decodeExrColor(const std::string& bytes, const std::string& path) {
    const Result<ExrImage> image = decodeExr(bytes, path);
    if (!image) { return image.error(); }
    Result<ImageF> color = exrColor(*image, path);
    if (!color) { return color.error(); }
    return SceneImage{.floats = std::make_shared<const ImageF>(std::move(*color))};
}

std::string_view savedExtension(const ImageFormat& format) {
    return format.extensions.substr(0, format.extensions.find(' '));
}

Status saveLayers(const std::string& path, const ImageForms& image) {
    const Result<ExrImage> layers = image.layers();
    return layers ? saveExr(path, *layers) : Status(layers.error());
}

}  // namespace

std::span<const ImageFormat> imageFormats() {
    using Head = std::string_view;
    using Path = const std::string&;
    using Forms = const ImageForms&;
    static constexpr ImageFormat kAll[] = {
        {.name = "PNG",
         .extensions = ".png",
         .looksLike = [](Head head) { return head.starts_with("\x89PNG"); },
         .decode = decode8,
         .save = [](Path path, Forms image) { return savePng(path, image.display()); }},
        {.name = "JPEG",
         .extensions = ".jpg .jpeg",
         .looksLike = [](Head head) { return head.starts_with("\xff\xd8"); },
         .decode = decode8},
        {.name = "BMP",
         .extensions = ".bmp",
         .looksLike = [](Head head) { return head.starts_with("BM"); },
         .decode = decode8},
        {.name = "TGA", .extensions = ".tga", .looksLike = looksLikeTga, .decode = decode8},
        {.name = "HDR",
         .extensions = ".hdr .pic",
         .looksLike = [](Head head) { return head.starts_with("#?"); },
         .decode = decodeHdr,
         .save = [](Path path, Forms image) { return saveHdr(path, image.radiance()); }},
        {.name = "EXR",
         .extensions = ".exr",
         .looksLike = looksLikeExr,
         .decode = decodeExrColor,
         .save = saveLayers,
         .hasLayers = true},
        {.name = "GIF",
         .extensions = ".gif",
         .looksLike = [](Head head) { return head.starts_with("GIF8"); },
         .decode = decode8,
         .isListed = false},
        {.name = "PNM",
         .extensions = ".pgm .ppm .pnm",
         .looksLike = [](Head head) { return head.starts_with("P5") || head.starts_with("P6"); },
         .decode = decode8,
         .isListed = false},
        {.name = "PSD",
         .extensions = ".psd",
         .looksLike = [](Head head) { return head.starts_with("8BPS"); },
         .decode = decode8,
         .isListed = false},
        {.name = "Softimage PIC",
         .extensions = ".pic",
         .looksLike = [](Head head) { return head.starts_with("\x53\x80\xf6\x34"); },
         .decode = decode8,
         .isListed = false},
    };
    return kAll;
}

const ImageFormat* imageFormatOf(const std::string& path, std::string_view bytes) {
    return kindOf(imageFormats(), path, headOf(bytes));
}

const ImageFormat* savedFormatOf(const std::string& path) {
    for (const ImageFormat& format : imageFormats()) {
        if (format.save != nullptr && extensionOf(path) == savedExtension(format)) { return &format; }
    }
    return nullptr;
}

std::string listReadableImages() {
    std::vector<std::string_view> names;
    for (const ImageFormat& format : imageFormats()) {
        if (format.isListed) { names.push_back(format.name); }
    }
    return joinNames(names);
}

std::string listSavedExtensions() {
    std::vector<std::string_view> extensions;
    for (const ImageFormat& format : imageFormats()) {
        if (format.save != nullptr) { extensions.push_back(savedExtension(format)); }
    }
    return joinNames(extensions);
}

}  // namespace glint
