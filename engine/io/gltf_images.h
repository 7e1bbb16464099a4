// The pictures of a glTF file that is written: files as they are where glTF shows them as Glint does,
// anything else as PNG. Internal to the glTF exporter (export_gltf.cpp).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/io/gltf_writer.h"
#include "engine/scene/scene.h"

namespace glint {

/// How programs read a picture: sRGB colours and alpha, tangent-space normals, roughness (green) over
/// metalness (blue; 1 without a texture of its own), a share of all (red), or a share or a roughness in
/// the alpha.
enum class GltfImageUse { Color, Normal, Roughness, Share, ShareInAlpha, RoughnessInAlpha };

/// The single number that a pixel shows (kernels/texture.h).
float shownNumber(const Texture& texture, size_t pixel);

class GltfImages {
  public:
    /// `scene`, `out` and `warnings` must outlive it; pictures are embedded where `path` is a .glb file, and
    /// lie beside it otherwise.
    GltfImages(const SceneDescription& scene, const std::string& path, GltfWriter* out,
               std::vector<std::string>* warnings)
        : scene_(scene), path_(path), out_(*out), warnings_(*warnings) {}

    /// A textureInfo of one of the scene's textures; with `alpha` >= 0, that texture's number is the alpha of
    /// the picture, which `use` says the meaning of, or, of `use` Roughness, its metalness. Either may be -1,
    /// not both. `isFlipped`: the file's v is 1 - v of the scene.
    GltfJson info(int color, int alpha, GltfImageUse use, bool isFlipped);
    /// What the picture of a GGX alpha is multiplied by to be glTF's roughness.
    float roughnessFactor(int texture) const;
    /// The same for a metalness and other shares.
    float shareFactor(int texture) const;

    /// The first error: a picture that was not read, or that cannot be written.
    const Status& status() const { return status_; }

  private:
    struct Image {
        int color, alpha;
        GltfImageUse use;
        auto operator<=>(const Image&) const = default;
    };
    const Texture& texture(int index) const { return scene_.textures[static_cast<size_t>(index)]; }
    size_t imageOf(const Image& image);
    bool fits(int color, int alpha);
    /// The image's file where it can be used as it is; null: it cannot.
    std::shared_ptr<const std::string> fileOf(const Image& image);
    Image8 bake(const Image& image);
    size_t addImage(const std::string& name, const std::shared_ptr<const std::string>& bytes);
    GltfJson samplerOf(const Texture& texture);

    const SceneDescription& scene_;
    std::string path_;
    GltfWriter& out_;
    std::vector<std::string>& warnings_;
    Status status_;
    std::map<Image, size_t> images_;
    std::map<std::string, size_t> files_, samplers_, textures_;
    int baked_ = 0;
};

}  // namespace glint
