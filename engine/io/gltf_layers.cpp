// KHR_materials_specular, _clearcoat, _sheen, _transmission and _anisotropy of glTF's materials.
#include <cmath>
#include <numbers>

#include "engine/io/gltf_materials.h"
#include "engine/io/gltf_surface.h"

namespace glint {
namespace {

/// The reference to a texture that stands under `key`.
tinygltf::TextureInfo textureOf(const tinygltf::Value* extension, const char* key) {
    tinygltf::TextureInfo info;
    if (extension == nullptr || !extension->Get(key).IsObject()) { return info; }
    const tinygltf::Value& value = extension->Get(key);
    info.index = indexOf(&value, "index");
    info.texCoord = indexOf(&value, "texCoord", 0);
    const tinygltf::Value& extensions = value.Get("extensions");
    for (const std::string& name : extensions.IsObject() ? extensions.Keys() : std::vector<std::string>()) {
        info.extensions[name] = extensions.Get(name);
    }
    return info;
}

}  // namespace

Status GltfMaterials::takeNumber(const tinygltf::Value* extension, const LayerKeys& keys, Reading reading,
                                 NumberInput* out) {
    const float factor =
        gltfNumber(numberOf(extension, keys.factor, static_cast<double>(keys.otherwise)), 0.0, 1.0);
    *out = {std::pow(factor, reading.exponent), -1};
    if (factor == 0.0f) { return {}; }
    reading.gain = factor;
    const Result<int> map = takeTexture(textureOf(extension, keys.image), reading);
    if (!map) { return map.error(); }
    out->texture = *map;
    return {};
}

Status GltfMaterials::takeColor(const tinygltf::Value* extension, const LayerKeys& keys, ColorInput* out) {
    *out = {gltfColor(extension, keys.factor, Vec3(keys.otherwise)), -1};
    if (isZero(out->value)) { return {}; }
    const float gain = maxComponent(out->value);
    const Result<int> map =
        takeTexture(textureOf(extension, keys.image), {ColorEncoding::Srgb, TextureChannel::Red, gain});
    if (!map) { return map.error(); }
    out->texture = *map;
    if (*map >= 0 && minComponent(out->value) < gain) {
        file_.remark("maps of specular and sheen colours lose the colour of their factor");
    }
    return {};
}

Status GltfMaterials::takeLayers(const tinygltf::Material& from, Material* out) {
    const auto* specular = extensionOf(from, "KHR_materials_specular");
    const auto* coat = extensionOf(from, "KHR_materials_clearcoat");
    const auto* sheen = extensionOf(from, "KHR_materials_sheen");
    constexpr ColorEncoding kLinear = ColorEncoding::Linear;
    Status status = takeNumber(specular, {"specularFactor", "specularTexture", 1.0f},
                               {kLinear, TextureChannel::Alpha}, &out->specular);
    if (status) {
        status =
            takeColor(specular, {"specularColorFactor", "specularColorTexture", 1.0f}, &out->specularTint);
    }
    if (status) {
        status = takeNumber(coat, {"clearcoatFactor", "clearcoatTexture", 0.0f},
                            {kLinear, TextureChannel::Red}, &out->clearcoat);
    }
    if (status) {
        status = takeNumber(coat, {"clearcoatRoughnessFactor", "clearcoatRoughnessTexture", 0.0f},
                            {kLinear, TextureChannel::Green, 1.0f, 2.0f}, &out->clearcoatRoughness);
    }
    if (status) {
        status = takeColor(sheen, {"sheenColorFactor", "sheenColorTexture", 0.0f}, &out->sheenColor);
    }
    if (status) {
        status = takeNumber(sheen, {"sheenRoughnessFactor", "sheenRoughnessTexture", 0.0f},
                            {kLinear, TextureChannel::Alpha, 1.0f, 2.0f}, &out->sheenRoughness);
    }
    if (status) {
        status = takeNumber(extensionOf(from, "KHR_materials_transmission"),
                            {"transmissionFactor", "transmissionTexture", 0.0f},
                            {kLinear, TextureChannel::Red}, &out->specularTransmission);
    }
    const bool isBare = !transmits(*out) && out->metallic == NumberInput{0.0f} &&
                        out->clearcoat == NumberInput{0.0f} && out->sheenColor == ColorInput{Vec3(0.0f)};
    if (isBare && (out->specular == NumberInput{0.0f} || out->ior.value == 1.0f)) {
        out->kind = MaterialKind::Diffuse;
    }
    if (coat != nullptr && coat->Has("clearcoatNormalTexture")) {
        file_.remark("coats have the normals of what they coat", from.name);
    }
    return status;
}

Status GltfMaterials::takeSheetImages(const tinygltf::Value& sheet, Material* out) {
    const float share = gltfNumber(numberOf(&sheet, "diffuseTransmissionFactor", 0.0), 0.0, 1.0);
    if (out->color.texture >= 0) {
        Texture reflected = scene_.textures[static_cast<size_t>(out->color.texture)];
        reflected.gain *= 1.0f - share;
        out->color.texture = static_cast<int>(scene_.textures.size());
        scene_.textures.push_back(std::move(reflected));
    }
    ColorInput passing;
    const LayerKeys keys{"diffuseTransmissionColorFactor", "diffuseTransmissionColorTexture", 1.0f};
    if (Status status = takeColor(&sheet, keys, &passing); !status) { return status; }
    if (passing.texture >= 0) {
        scene_.textures[static_cast<size_t>(passing.texture)].gain *= share;
        out->transmission.texture = passing.texture;
    }
    if (sheet.Has("diffuseTransmissionTexture")) {
        file_.remark("images of how much light a sheet lets pass are left out");
    }
    return {};
}

/// Along the direction alpha is mix(alpha, 1, strength^2), across it stays (the extension's text).
Status GltfMaterials::takeAnisotropy(const tinygltf::Material& from, Material* out) {
    const auto* extension = extensionOf(from, "KHR_materials_anisotropy");
    float strength = gltfNumber(numberOf(extension, "anisotropyStrength", 0.0), 0.0, 1.0);
    if (!(strength > 0.0f)) { return {}; }
    if (const tinygltf::TextureInfo info = textureOf(extension, "anisotropyTexture"); info.index >= 0) {
        const Result<Surface> image = surfaceImage(info.index);
        if (!image) { return image.error(); }
        strength *= image->metalness;
        if (!image->isEvenlyMetallic) {
            file_.remark("strengths of anisotropy in images count by their mean", from.name);
        }
        const Result<int> direction = takeTexture(info, {});
        if (!direction) { return direction.error(); }
        out->anisotropyDirection.texture = *direction;
    }
    // Texture coordinates count v downwards here, and the rotation counts upwards.
    const double rotation = numberOf(extension, "anisotropyRotation", 0.0);
    out->anisotropyRotationDeg = static_cast<float>(-rotation * (180.0 / std::numbers::pi));
    out->crossRoughness = out->roughness;
    const float share = square(strength);
    out->roughness.value = glm::mix(out->roughness.value, 1.0f, share);
    if (out->roughness.texture >= 0) {
        // (strength + gain x)^2, which is right where x is 0 and where it is 1.
        Texture along = scene_.textures[static_cast<size_t>(out->roughness.texture)];
        along.base = strength;
        along.gain = std::sqrt(glm::mix(square(along.gain), 1.0f, share)) - strength;
        out->roughness.texture = static_cast<int>(scene_.textures.size());
        scene_.textures.push_back(std::move(along));
        file_.remark("images of roughness are approximated where they are anisotropic", from.name);
    }
    return {};
}

}  // namespace glint
