// A decoded image in memory: what textures and environments are made of, and what is saved.
//
// Row 0 is the top row. Pixels are interleaved. Immutable once shared. Knows nothing of files or formats.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/kinds.h"
#include "engine/scene/generated_sky.h"

namespace glint {

/// 8-bit colour as stored in PNG, JPEG and BMP files: usually sRGB-encoded. 3 channels.
struct Image8 {
    int width = 0;
    int height = 0;
    std::vector<uint8_t> rgb;
};

/// Linear float colour. 3 channels.
struct ImageF {
    int width = 0;
    int height = 0;
    std::vector<float> rgb;
};

/// An image together with where it came from, so that a scene can be saved again. At most one of the two is
/// set; neither while the image has not been read because nothing uses it (engine/io/used_assets.h).
struct ImageSource {
    std::string path;  ///< as written in the scene file, for saving; empty for generated images
    std::shared_ptr<const Image8> bytes;
    std::shared_ptr<const ImageF> floats;
    std::optional<SkySource> sky = {};  ///< how `floats` is generated, where it is

    bool isRead() const { return bytes != nullptr || floats != nullptr; }
};

}  // namespace glint
