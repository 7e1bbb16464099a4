// From glTF's metallic-roughness materials and textures to Glint's.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "engine/io/gltf_file.h"
#include "engine/scene/scene.h"

namespace glint {

/// What a mesh needs to know of its material.
struct GltfMaterial {
    int index = 0;            ///< in the scene
    int uvSet = 0;            ///< the texture coordinates that its textures use
    Vec3 vertexFactor{1.0f};  ///< what its colour's texture is multiplied by, as vertex colours
};

class GltfMaterials {
  public:
    /// Both must outlive it; materials and textures are appended to the scene when they are asked for.
    GltfMaterials(GltfFile* file, SceneDescription* scene) : file_(*file), scene_(*scene) {}

    /// The first that applies gives the kind:
    ///   - KHR_materials_unlit: a black surface that shines with the base colour.
    ///   - KHR_materials_transmission of at least 0.5: a dielectric tinted by the base colour, with the index
    ///   of
    ///     KHR_materials_ior; thin where KHR_materials_volume gives no thickness.
    ///   - metallic of at least 0.5, on the average of its texture: a GGX conductor whose reflectance is the
    ///   base
    ///     colour.
    ///   - else plastic over the base colour, with the index of KHR_materials_ior (1.5).
    /// GGX alpha is the square of the roughness, on the average of its texture. Emission is the emissive
    /// factor times KHR_materials_emissive_strength, on both sides where the material is double-sided.
    /// Normal maps are taken as they are; alpha cuts out unless the material is opaque.
    /// Everything else that a material has is left out with a remark. Error: an index or a buffer beyond what
    /// the file has.
    Result<GltfMaterial> take(int material);

  private:
    struct Map {
        int texture = -1;
        int uvSet = 0;
    };

    template <class Info>
    Result<Map> takeTexture(const Info& info, ColorEncoding encoding);
    Result<ImageSource> sourceOf(int image);
    /// Means of the three channels of a texture's image in [0, 1]; 1 each where it cannot be read.
    Result<Vec3> meanOf(int texture);
    Status takeSurface(const tinygltf::Material& from, Material* out);
    /// What of the surface is there.
    void takeAlpha(const tinygltf::Material& from, int colorTexture, Material* out);
    void remarkLeftOut(const tinygltf::Material& from);

    GltfFile& file_;
    SceneDescription& scene_;
    std::map<int, GltfMaterial> taken_;
    std::map<std::string, int> textures_;
    std::map<int, Vec3> means_;
};

}  // namespace glint
