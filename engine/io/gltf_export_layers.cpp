// The layers of a principled material, and what passes it, as extensions of a glTF file's materials:
// KHR_materials_specular, _clearcoat, _sheen, _transmission and _volume.
#include <cmath>

#include "engine/io/gltf_export.h"
#include "engine/io/scene_export.h"

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
            share(from_.specular, GltfImageUse::ShareInAlpha, "specularFactor", "specularTexture", &to);
            color(from_.specularTint, "specularColorFactor", "specularColorTexture", &to);
        }
        return to;
    }
    GltfJson coat() {
        GltfJson to;
        if (from_.clearcoat.value > 0.0f || from_.clearcoat.texture >= 0) {
            share(from_.clearcoat, GltfImageUse::Share, "clearcoatFactor", "clearcoatTexture", &to);
            roughness(from_.clearcoatRoughness, GltfImageUse::Roughness, "clearcoatRoughnessFactor",
                      "clearcoatRoughnessTexture", &to);
        }
        return to;
    }
    GltfJson sheen() {
        GltfJson to;
        if (!isZero(from_.sheenColor.value) || from_.sheenColor.texture >= 0) {
            color(from_.sheenColor, "sheenColorFactor", "sheenColorTexture", &to);
            roughness(from_.sheenRoughness, GltfImageUse::RoughnessInAlpha, "sheenRoughnessFactor",
                      "sheenRoughnessTexture", &to);
        }
        return to;
    }
    GltfJson transmission() {
        GltfJson to;
        if (transmits(from_)) {
            share(from_.specularTransmission, GltfImageUse::Share, "transmissionFactor",
                  "transmissionTexture", &to);
        }
        return to;
    }

  private:
    void addImage(int texture, GltfImageUse use, const char* key, GltfJson* to) {
        if (texture < 0) { return; }
        const bool isAlpha = use == GltfImageUse::ShareInAlpha || use == GltfImageUse::RoughnessInAlpha;
        (*to)[key] = images_.info(isAlpha ? -1 : texture, isAlpha ? texture : -1, use, isFlipped_);
    }
    void share(const NumberInput& input, GltfImageUse use, const char* factor, const char* imageKey,
               GltfJson* to) {
        (*to)[factor] = gltfJson(input.texture >= 0 ? images_.shareFactor(input.texture) : input.value);
        addImage(input.texture, use, imageKey, to);
    }
    /// By the GGX alpha, which is the square of glTF's roughness.
    void roughness(const NumberInput& input, GltfImageUse use, const char* factor, const char* imageKey,
                   GltfJson* to) {
        (*to)[factor] =
            gltfJson(input.texture >= 0 ? images_.roughnessFactor(input.texture) : std::sqrt(input.value));
        addImage(input.texture, use, imageKey, to);
    }
    void color(const ColorInput& input, const char* factor, const char* imageKey, GltfJson* to) {
        (*to)[factor] = gltfJson(input.texture >= 0 ? Vec3(1.0f) : input.value);
        addImage(input.texture, GltfImageUse::Color, imageKey, to);
    }

    const Material& from_;
    bool isFlipped_;
    GltfImages& images_;
};

}  // namespace

void writeGltfLayers(const Material& material, bool isFlipped, GltfImages* images, GltfWriter* out,
                     GltfJson* to, std::vector<std::string>* warnings) {
    LayerWriter layers(material, isFlipped, images);
    const auto extend = [&](const char* name, GltfJson layer) {
        if (!layer.is_null()) { out->extend(to, name, std::move(layer)); }
    };
    extend("KHR_materials_specular", layers.specular());
    extend("KHR_materials_clearcoat", layers.coat());
    extend("KHR_materials_sheen", layers.sheen());
    if (!transmits(material)) { return; }
    if (material.rootTint) {
        warnOnce("approximated: what passes is tinted by the colour at each surface", warnings);
    }
    extend("KHR_materials_transmission", layers.transmission());
    writeGltfVolume(material, out, to);
}

void writeGltfVolume(const Material& material, GltfWriter* out, GltfJson* to) {
    if (material.thin) { return; }
    GltfJson volume = GltfJson::object({{"thicknessFactor", 1}});
    if (material.attenuationColor != Vec3(1.0f)) {
        volume["attenuationDistance"] = gltfJson(material.attenuationDistance);
        volume["attenuationColor"] = gltfJson(material.attenuationColor);
    }
    out->extend(to, "KHR_materials_volume", std::move(volume));
}

}  // namespace glint
