#include "engine/io/gltf_surface.h"

#include <algorithm>
#include <cmath>

namespace glint {

float gltfNumber(double value, double least, double most) {
    return static_cast<float>(std::isfinite(value) ? std::clamp(value, least, most) : least);
}

Vec3 gltfColor(const std::vector<double>& factor, double most) {
    Vec3 color(1.0f);
    for (size_t c = 0; c < 3 && c < factor.size(); ++c) {
        color[static_cast<int>(c)] = gltfNumber(factor[c], 0.0, most);
    }
    return color;
}

Vec3 gltfColor(const tinygltf::Value* extension, const char* key, const Vec3& otherwise) {
    if (extension == nullptr || !extension->Get(key).IsArray()) { return otherwise; }
    const tinygltf::Value& value = extension->Get(key);
    std::vector<double> factor;
    for (size_t c = 0; c < value.ArrayLen(); ++c) {
        factor.push_back(value.Get(static_cast<int>(c)).GetNumberAsDouble());
    }
    return gltfColor(factor);
}

int gltfImage(const tinygltf::Texture& texture) {
    const auto* webp = extensionOf(texture, "EXT_texture_webp");
    return webp != nullptr ? indexOf(webp, "source") : texture.source;
}

tinygltf::PbrMetallicRoughness gltfSurface(const tinygltf::Material& material) {
    const auto* older = extensionOf(material, "KHR_materials_pbrSpecularGlossiness");
    if (older == nullptr) { return material.pbrMetallicRoughness; }
    tinygltf::PbrMetallicRoughness surface;
    const tinygltf::Value& color = older->Get("diffuseFactor");
    for (size_t c = 0; c < 4 && color.ArrayLen() == 4; ++c) {
        surface.baseColorFactor[c] = color.Get(static_cast<int>(c)).GetNumberAsDouble();
    }
    const tinygltf::Value& map = older->Get("diffuseTexture");
    if (map.IsObject()) {
        surface.baseColorTexture.index = indexOf(&map, "index");
        surface.baseColorTexture.texCoord = indexOf(&map, "texCoord", 0);
    }
    surface.metallicFactor = 0.0;
    surface.roughnessFactor = 1.0 - numberOf(older, "glossinessFactor", 1.0);
    return surface;
}

bool isOnlyGlass(const tinygltf::Material& from) {
    const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
    const auto* transmission = extensionOf(from, "KHR_materials_transmission");
    const bool passesAll =
        numberOf(transmission, "transmissionFactor", 0.0) >= 1.0 && !transmission->Has("transmissionTexture");
    const bool isWhite = pbr.baseColorTexture.index < 0 && gltfColor(pbr.baseColorFactor) == Vec3(1.0f);
    const bool isSheet = !(numberOf(extensionOf(from, "KHR_materials_volume"), "thicknessFactor", 0.0) > 0.0);
    const bool hasLayers = extensionOf(from, "KHR_materials_specular") != nullptr ||
                           extensionOf(from, "KHR_materials_clearcoat") != nullptr ||
                           extensionOf(from, "KHR_materials_sheen") != nullptr ||
                           extensionOf(from, "KHR_materials_iridescence") != nullptr;
    return passesAll && isWhite && pbr.metallicFactor <= 0.0 && !hasLayers &&
           !(isSheet && pbr.roughnessFactor > 0.0);
}

void takeVolume(const tinygltf::Value* volume, Material* out) {
    out->thin = !(numberOf(volume, "thicknessFactor", 0.0) > 0.0);
    const double distance = numberOf(volume, "attenuationDistance", 0.0);
    if (out->thin || !(distance > 0.0)) { return; }
    out->attenuationColor = gltfColor(volume, "attenuationColor");
    out->attenuationDistance = gltfNumber(distance, 1e-9, 1e9);
}

void takeSheet(const tinygltf::Value& sheet, Material* out) {
    const float share = gltfNumber(numberOf(&sheet, "diffuseTransmissionFactor", 0.0), 0.0, 1.0);
    out->kind = MaterialKind::Translucent;
    out->color.value *= 1.0f - share;
    out->transmission.value = share * gltfColor(&sheet, "diffuseTransmissionColorFactor");
}

}  // namespace glint
