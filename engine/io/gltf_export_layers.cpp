// KHR_materials_specular, _clearcoat and _sheen of a glTF file that is written: what gltf_layers.cpp reads.
#include <cmath>

#include "engine/io/gltf_export.h"

namespace glint {
namespace {

class LayerWriter {
  public:
    LayerWriter(const Material& material, bool isFlipped, GltfImages* images)
        : from_(material), isFlipped_(isFlipped), images_(*images) {}

    /// Null: there is none.
    GltfJson specular() {
        GltfJson to;
        if (from_.specular != NumberInput{1.0f} || from_.specularTint != ColorInput{Vec3(1.0f)}) {
            share(from_.specular, GltfPictureUse::ShareInAlpha, "specularFactor", "specularTexture", &to);
            color(from_.specularTint, "specularColorFactor", "specularColorTexture", &to);
        }
        return to;
    }
    GltfJson coat() {
        GltfJson to;
        if (from_.clearcoat.value > 0.0f || from_.clearcoat.texture >= 0) {
            share(from_.clearcoat, GltfPictureUse::Share, "clearcoatFactor", "clearcoatTexture", &to);
            roughness(from_.clearcoatRoughness, GltfPictureUse::Roughness, "clearcoatRoughnessFactor",
                      "clearcoatRoughnessTexture", &to);
        }
        return to;
    }
    GltfJson sheen() {
        GltfJson to;
        if (!isZero(from_.sheenColor.value) || from_.sheenColor.texture >= 0) {
            color(from_.sheenColor, "sheenColorFactor", "sheenColorTexture", &to);
            roughness(from_.sheenRoughness, GltfPictureUse::RoughnessInAlpha, "sheenRoughnessFactor",
                      "sheenRoughnessTexture", &to);
        }
        return to;
    }

  private:
    void picture(int texture, GltfPictureUse use, const char* key, GltfJson* to) {
        if (texture < 0) { return; }
        const bool isAlpha = use == GltfPictureUse::ShareInAlpha || use == GltfPictureUse::RoughnessInAlpha;
        (*to)[key] = images_.info(isAlpha ? -1 : texture, isAlpha ? texture : -1, use, isFlipped_);
    }
    void share(const NumberInput& input, GltfPictureUse use, const char* factor, const char* image,
               GltfJson* to) {
        (*to)[factor] = gltfJson(input.texture >= 0 ? images_.shareFactor(input.texture) : input.value);
        picture(input.texture, use, image, to);
    }
    /// By the GGX alpha, which is the square of glTF's roughness.
    void roughness(const NumberInput& input, GltfPictureUse use, const char* factor, const char* image,
                   GltfJson* to) {
        (*to)[factor] =
            gltfJson(input.texture >= 0 ? images_.roughnessFactor(input.texture) : std::sqrt(input.value));
        picture(input.texture, use, image, to);
    }
    void color(const ColorInput& input, const char* factor, const char* image, GltfJson* to) {
        (*to)[factor] = gltfJson(input.texture >= 0 ? Vec3(1.0f) : input.value);
        picture(input.texture, GltfPictureUse::Color, image, to);
    }

    const Material& from_;
    bool isFlipped_;
    GltfImages& images_;
};

}  // namespace

void writeGltfLayers(const Material& material, bool isFlipped, GltfImages* images, GltfWriter* out,
                     GltfJson* to) {
    LayerWriter layers(material, isFlipped, images);
    const auto extend = [&](const char* name, GltfJson layer) {
        if (!layer.is_null()) { out->extend(to, name, std::move(layer)); }
    };
    extend("KHR_materials_specular", layers.specular());
    extend("KHR_materials_clearcoat", layers.coat());
    extend("KHR_materials_sheen", layers.sheen());
}

}  // namespace glint
