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
    bool usesTangents = false;
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
    ///   - KHR_materials_diffuse_transmission and metallic below 0.5: a translucent sheet.
    ///   - else principled, with the index of KHR_materials_ior (1.5) and what KHR_materials_specular,
    ///     _clearcoat and _sheen say.
    /// KHR_materials_anisotropy gives the last and glass a roughness across.
    /// GGX alpha is the square of the roughness and its texture. Emission is the emissive
    /// factor times KHR_materials_emissive_strength, on both sides where the material is double-sided.
    /// Normal maps are taken as they are; alpha cuts out unless the material is opaque.
    /// Everything else that a material has is left out with a remark. Error: an index or a buffer beyond what
    /// the file has.
    Result<GltfMaterial> take(int material);

  private:
    /// How an image's numbers are read.
    struct Reading {
        ColorEncoding encoding = ColorEncoding::Linear;
        TextureChannel channel = TextureChannel::Red;
        float gain = 1.0f, exponent = 1.0f;
    };
    /// Its number in the scene; -1: none.
    template <class Info>
    Result<int> takeTexture(const Info& info, const Reading& reading);
    Result<ImageSource> sourceOf(int image);
    /// What a texture's image holds of roughness (green) and metalness (blue), in [0, 1].
    struct Surface {
        float roughness = 1.0f, metalness = 1.0f;  ///< means; 1 where the image cannot be read
        bool isEvenlyRough = true, isEvenlyMetallic = true;
    };
    Result<Surface> surfaceImage(int texture);
    Status takeSurface(const tinygltf::Material& from, Material* out);
    /// What the image says of roughness, and of metalness where that is asked for.
    Status takeSurfaceImage(const tinygltf::TextureInfo& info, bool isMetallic, Material* out);
    /// KHR_materials_specular, _clearcoat and _sheen. In gltf_layers.cpp, as are those below.
    Status takeLayers(const tinygltf::Material& from, Material* out);
    /// The images of a sheet that takeSheet() has made; `out` has that of the colour.
    Status takeSheetImages(const tinygltf::Value& sheet, Material* out);
    /// KHR_materials_anisotropy; the roughness is set.
    Status takeAnisotropy(const tinygltf::Material& from, Material* out);
    /// A factor of an extension and its image; both of them to the power of `reading.exponent`.
    struct LayerKeys {
        const char *factor, *image;
        float otherwise;  ///< where the extension does not say the factor
    };
    Status takeNumber(const tinygltf::Value* extension, const LayerKeys& keys, Reading reading,
                      NumberInput* out);
    Status takeColor(const tinygltf::Value* extension, const LayerKeys& keys, ColorInput* out);
    /// What of the surface is there.
    void takeAlpha(const tinygltf::Material& from, int colorTexture, Material* out);
    void remarkLeftOut(const tinygltf::Material& from);

    GltfFile& file_;
    SceneDescription& scene_;
    std::map<int, GltfMaterial> taken_;
    std::map<std::string, int> textures_;
    std::map<int, Surface> surfaces_;
    std::vector<int> uvSets_;  ///< of the textures of the material that is taken
};

}  // namespace glint
