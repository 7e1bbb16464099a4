// A decoded image in memory: what textures and environments are made of, and what is saved.
//
// Row 0 is the top row. Pixels are interleaved. Immutable once shared. Knows nothing of files or formats.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/base/kinds.h"
#include "engine/scene/asset_source.h"
#include "engine/scene/checkerboard.h"
#include "engine/scene/generated_sky.h"

namespace glint {

/// 8-bit colour as stored in PNG, JPEG and BMP files: usually sRGB-encoded. 3 channels, not multiplied by
/// alpha.
struct Image8 {
    int width = 0;
    int height = 0;
    std::vector<uint8_t> rgb;
    std::vector<uint8_t> alpha = {};  ///< of each pixel, 255 opaque; empty where all of them are
};

/// Linear float colour. 3 channels.
struct ImageF {
    int width = 0;
    int height = 0;
    std::vector<float> rgb;
};

using ImageSource = AssetSource<SkySource, Checkerboard>;

/// An image together with where it comes from. At most one of the two is set; neither while the image has not
/// been read because nothing uses it (engine/io/used_assets.h).
struct SceneImage {
    ImageSource source = {};
    std::shared_ptr<const Image8> bytes = {};
    std::shared_ptr<const ImageF> floats = {};

    bool isRead() const { return bytes != nullptr || floats != nullptr; }
    bool isGenerated() const {
        return std::holds_alternative<SkySource>(source) || std::holds_alternative<Checkerboard>(source);
    }
};

}  // namespace glint
