#include "engine/io/gltf_surface.h"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

Vec3 colorOf(const tinygltf::Value* extension, const char* key) {
    std::vector<double> factor;
    if (extension != nullptr && extension->Get(key).IsArray()) {
        const tinygltf::Value& value = extension->Get(key);
        for (size_t c = 0; c < value.ArrayLen(); ++c) {
            factor.push_back(value.Get(static_cast<int>(c)).GetNumberAsDouble());
        }
    }
    return gltfColor(factor);
}

}  // namespace

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
        surface.baseColorTexture.index = static_cast<int>(numberOf(&map, "index", -1.0));
        surface.baseColorTexture.texCoord = static_cast<int>(numberOf(&map, "texCoord", 0.0));
    }
    surface.metallicFactor = 0.0;
    surface.roughnessFactor = 1.0 - numberOf(older, "glossinessFactor", 1.0);
    return surface;
}

void makeMetal(const Vec3& color, bool isTextured, Material* out) {
    out->kind = MaterialKind::Conductor;
    out->metal.clear();
    const Vec3 r = isTextured ? Vec3(0.999f) : glm::clamp(color, Vec3(0.0f), Vec3(0.999f));
    out->eta.value = (Vec3(1.0f) - r) / (Vec3(1.0f) + r);
    out->k.value = 2.0f * glm::sqrt(r) / (Vec3(1.0f) + r);
    out->color.value = Vec3(1.0f);
}

void takeVolume(const tinygltf::Value* volume, Material* out) {
    out->thin = !(numberOf(volume, "thicknessFactor", 0.0) > 0.0);
    const double distance = numberOf(volume, "attenuationDistance", 0.0);
    if (out->thin || !(distance > 0.0)) { return; }
    out->attenuationColor = colorOf(volume, "attenuationColor");
    out->attenuationDistance = gltfNumber(distance, 1e-9, 1e9);
}

void takeSheet(const tinygltf::Value& sheet, Material* out) {
    const float share = gltfNumber(numberOf(&sheet, "diffuseTransmissionFactor", 0.0), 0.0, 1.0);
    out->kind = MaterialKind::Translucent;
    out->color.value *= 1.0f - share;
    out->transmission.value = share * colorOf(&sheet, "diffuseTransmissionColorFactor");
}

}  // namespace glint
