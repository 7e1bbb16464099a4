// The textures that a scene's materials use, as kernels read them.
//
// Pixels are not copied: the table shares the immutable images. Textures that nothing refers to are left out.
#pragma once

#include <memory>
#include <vector>

#include "engine/base/result.h"
#include "engine/kernels/geometry_view.h"
#include "engine/kernels/shading_view.h"
#include "engine/scene/scene.h"

namespace glint {

struct TextureTable {
    std::vector<TextureView> textures;
    /// for each texture of the description its index in `textures`, or kNone
    std::vector<uint32_t> packedIndex;
    std::vector<SceneImage> images;  ///< keep the pixels alive; same indices as `textures`
    std::vector<std::shared_ptr<const std::vector<float>>>
        mips;  ///< likewise; null where there is no mip map

    /// The kernels' index of the description's texture `index`; kNone for -1 and for what is not used.
    uint32_t packed(int index) const {
        const bool isListed = index >= 0 && static_cast<size_t>(index) < packedIndex.size();
        return isListed ? packedIndex[static_cast<size_t>(index)] : kNone;
    }

    /// Memory of the pixels, an image that several textures share counted once, and of mip maps.
    size_t bytes() const;
};

/// Memory of the images' pixels; an image that stands there several times counts once.
size_t imageBytes(const std::vector<SceneImage>& images);

/// `previous` (may be null) is returned itself where nothing changed. Error: a used material refers to a
/// texture that does not exist, or a used texture has no pixels or a scale that is not finite. Mip maps are
/// taken from `previous` where they are the same.
Result<std::shared_ptr<const TextureTable>> buildTextureTable(
    const SceneDescription& scene, const std::shared_ptr<const TextureTable>& previous);

}  // namespace glint
