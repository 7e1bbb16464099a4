// OpenEXR pictures with any number of named channels and text attributes.
//
// The only place that sees OpenEXR's headers and its exceptions, none of which escape. Which layers and
// attributes a render saves is decided in render/image_file.h.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/image.h"

namespace glint {

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

/// Error: not an OpenEXR file, broken, truncated, deep, or more than kMaxImagePixels (image_io.h) in the data
/// window. Only text attributes are returned. `path` is used in messages.
Result<ExrImage> decodeExr(std::string_view bytes, const std::string& path);
Result<ExrImage> loadExr(const std::string& path);

/// The picture's colour: R, G and B, or Y alone as grey. Error: neither there, or a value is not finite.
Result<ImageF> exrColor(const ExrImage& image, const std::string& path);

/// ZIP-compressed scan lines, saved atomically. Finite half values beyond 65504 are stored as 65504.
Status saveExr(const std::string& path, const ExrImage& image);

}  // namespace glint
