// Portable float maps: linear colour (PF) or grey (Pf), the lowest row first (P. Debevec, "PFM Portable
// FloatMap Image Format").
#include <charconv>
#include <cmath>
#include <cstring>

#include "engine/io/image_builder.h"
#include "engine/io/image_formats.h"

namespace glint {
namespace {

bool looksLike(std::string_view head) {
    return head.size() > 2 && (head.starts_with("PF") || head.starts_with("Pf")) &&
           std::string_view(" \t\r\n").find(head[2]) != std::string_view::npos;
}

/// The number that comes next, and the blank behind it; 0: none.
template <class Number>
Number take(std::string_view* text) {
    text->remove_prefix(std::min(text->find_first_not_of(" \t\r\n"), text->size()));
    Number number{};
    const auto [end, code] = std::from_chars(text->data(), text->data() + text->size(), number);
    const auto used = static_cast<size_t>(end - text->data());
    text->remove_prefix(std::min(used + 1, text->size()));
    return code == std::errc() ? number : Number{};
}

float floatAt(const char* stored, bool isBigEndian) {
    uint8_t bytes[4];
    for (size_t i = 0; i < sizeof bytes; ++i) {
        bytes[isBigEndian ? 3 - i : i] = static_cast<uint8_t>(stored[i]);
    }
    float value = 0.0f;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

Result<SceneImage> decode(const std::string& bytes, const std::string& path) {
    if (!looksLike(bytes)) { return brokenImage(path, "it does not begin with PF or Pf"); }
    const size_t channels = bytes[1] == 'F' ? 3 : 1;
    std::string_view rest = std::string_view(bytes).substr(2);
    const uint32_t width = take<uint32_t>(&rest), height = take<uint32_t>(&rest);
    const float scale = take<float>(&rest);  // below 0 in little-endian files; its size means nothing fixed
    if (!std::isfinite(scale) || scale == 0.0f) { return brokenImage(path, "its header is wrong"); }
    const double pixelsPerByte = 1.0 / static_cast<double>(sizeof(float) * channels);
    if (Status size = checkStatedSize(path, width, height, rest.size(), pixelsPerByte); !size) {
        return size.error();
    }
    ImageF image{static_cast<int>(width), static_cast<int>(height), {}};
    image.rgb.resize(size_t{3} * width * height);
    for (size_t i = 0; i < image.rgb.size(); ++i) {
        const size_t pixel = i / 3, row = height - 1 - pixel / width;
        const size_t stored = (row * width + pixel % width) * channels + (channels == 3 ? i % 3 : 0);
        image.rgb[i] = floatAt(&rest[sizeof(float) * stored], scale > 0.0f);
    }
    return SceneImage{.floats = std::make_shared<const ImageF>(std::move(image))};
}

}  // namespace

extern const ImageFormat kImagePfm;
const ImageFormat kImagePfm{.name = "PFM", .extensions = ".pfm", .looksLike = looksLike, .decode = decode};

}  // namespace glint
