// OpenEXR pictures with any number of named channels and text attributes.
//
// exr_io.cpp writes through OpenEXR's C++ library, whose exceptions do not escape it; exr_file.h reads. Which
// layers and attributes a render saves is decided in render/image_file.h.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/image.h"

namespace glint {

/// The largest finite number of a half.
constexpr float kLargestHalf = 65504.0f;

enum class ExrPixelType : uint8_t { Half, Float, Uint };

/// One channel: `floats` for Half and Float, `ids` for Uint, width * height values, row 0 at the top.
struct ExrChannel {
    std::string name;  ///< "R", or "layer.R" for a layer
    ExrPixelType type = ExrPixelType::Half;
    std::vector<float> floats;
    std::vector<uint32_t> ids;
};

struct ExrImage {
    int width = 0;
    int height = 0;
    std::vector<ExrChannel> channels;
    std::map<std::string, std::string> attributes;  ///< text attributes; numbers are written as text

    /// The channel of that name, or null.
    const ExrChannel* find(std::string_view name) const;
};

/// True when the bytes begin like an OpenEXR file.
bool looksLikeExr(std::string_view bytes);

/// The channels of the file's first flat part that `wanted` accepts, in the data window, but for those that
/// are not there for each pixel; no others are unpacked to memory. Error: not an OpenEXR file, broken,
/// truncated, deep, more pixels than kMaxImagePixels (image_io.h) or than its size allows. Only text
/// attributes are returned. `path` is used in messages.
Result<ExrImage> decodeExr(
    std::string_view bytes, const std::string& path,
    const std::function<bool(std::string_view name)>& wanted = [](std::string_view) { return true; });
Result<ExrImage> loadExr(const std::string& path);

/// The colour of a file, and its text attributes.
struct ExrColorImage {
    ImageF color;  ///< linear Rec.709, in the display window; values may be negative or not finite
    std::map<std::string, std::string> attributes;
};

/// Reads the colour alone: R, G and B, or luminance Y with or without chroma RY and BY, of the file's own
/// layer, else of its only one with R, G and B ("ViewLayer.Combined.R"), else of one with a usual name.
/// Chromaticities are followed, without adapting the white. Error: as decodeExr(); no such layer, with the
/// channels that are there.
Result<ExrColorImage> decodeExrColor(std::string_view bytes, const std::string& path);
Result<ExrColorImage> loadExrColor(const std::string& path);

/// ZIP-compressed scan lines. Finite half values beyond 65504 are stored as 65504. `path` is used
/// in messages.
Result<std::string> encodeExr(const ExrImage& image, const std::string& path);
/// The same, saved atomically.
Status saveExr(const std::string& path, const ExrImage& image);

}  // namespace glint
