// 6.837-style scenes: materials with the three scattering types, and image textures.
#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "engine/io/scene_text_reader.h"
#include "engine/io/used_assets.h"

namespace glint {
namespace {

/// The original's heights run from -1 to 1 metre; its published ball of bricks has the relief of a tenth.
constexpr float kBumpHeight = 0.2f;

}  // namespace

void SceneTextReader::readMaterials() {
    tokens_.take();
    tokens_.expect("{", "Materials");
    tokens_.expect("numMaterials", "'Materials {'");
    const int count = tokens_.integer("numMaterials", 0, 1'000'000);
    // The file cannot hold more; growing as they come takes half as much again.
    constexpr size_t kLeastBytes = std::string_view("Material{}").size();
    scene_.materials.reserve(
        std::min(static_cast<size_t>(count), tokens_.source().text.size() / kLeastBytes));
    for (int i = 0; i < count && !tokens_.failed(); ++i) {
        tokens_.expect("Material", fmt::format("{} of {} materials", i, count));
        readMaterial();
    }
    tokens_.expect("}", fmt::format("{} materials", count));
}

void SceneTextReader::readMaterial() {
    constexpr std::string_view kFields[] = {"color",     "diffuseColor", "specularColor", "emission", "type",
                                            "shininess", "refr",         "texture",       "bump"};
    Material material;
    material.name = fmt::format("material {}", scene_.materials.size());
    material.color.value = Vec3(1.0f);
    float shininess = 0.0f;
    Vec3 weights(1.0f, 0.0f, 0.0f);
    float ior = 1.0f;
    bool hasIor = false;
    TextToken weightsAt = tokens_.peek();
    tokens_.expect("{", "Material");
    while (!tokens_.accept("}") && !tokens_.failed()) {
        if (tokens_.accept("color") || tokens_.accept("diffuseColor")) {
            material.color.value = glm::min(tokens_.color("color"), Vec3(1.0f));
        } else if (tokens_.accept("specularColor")) {
            material.phongSpecular = tokens_.color("specularColor");
        } else if (tokens_.accept("emission")) {
            material.emission.value = tokens_.color("emission");
            material.emitsBothSides = true;  // The original adds it whichever side a ray meets.
        } else if (tokens_.accept("type")) {
            weightsAt = tokens_.peek();
            weights = tokens_.color("type");
        } else if (tokens_.accept("shininess")) {
            shininess = tokens_.number("shininess", 0.0f, 1e6f, "an exponent from 0 to 1e6");
        } else if (tokens_.accept("refr")) {
            ior = tokens_.number("refr", 0.01f, 100.0f, "an index of refraction from 0.01 to 100");
            hasIor = true;
        } else if (tokens_.accept("texture")) {
            const TextToken pathAt = tokens_.peek();
            material.color.texture = addTexture(pathAt, tokens_.path("a texture"));
        } else if (tokens_.accept("bump")) {
            const TextToken pathAt = tokens_.peek();
            material.bump.texture = addTexture(pathAt, tokens_.path("a bump map"));
            material.bumpHeight = kBumpHeight;
        } else {
            tokens_.failUnknown("Material", kFields);
        }
    }
    if (!isZero(material.phongSpecular)) { material.phongExponent = shininess; }
    setScattering(weightsAt, weights, hasIor, ior, &material);
    scene_.materials.push_back(std::move(material));
}

void SceneTextReader::setScattering(const TextToken& at, const Vec3& weights, bool hasIor, float ior,
                                    Material* material) {
    const float sum = weights.x + weights.y + weights.z;
    if (!tokens_.failed() && !(sum > 0.0f)) {
        tokens_.fail(at, "type is 0 0 0; expected shares of diffuse, mirror and refractive scattering");
    }
    if (tokens_.failed()) { return; }
    if (weights.x == sum) {
        material->kind = MaterialKind::Diffuse;
    } else if (weights.y == sum) {
        material->kind = MaterialKind::Mirror;
    } else if (weights.z == sum) {
        material->kind = MaterialKind::Dielectric;
    } else {
        material->kind = MaterialKind::Mixture;
        material->mixtureWeights.value = weights / sum;
    }
    if (weights.z > 0.0f) { material->ior.value = hasIor ? ior : 1.0f; }
}

int SceneTextReader::addTexture(const TextToken& at, const std::string& path) {
    if (tokens_.failed()) { return -1; }
    const auto [found, isNew] = textures_.try_emplace(path, static_cast<int>(scene_.textures.size()));
    if (isNew) {
        Texture texture;
        texture.name = path;
        texture.image.source = FileSource{locate(path)};
        texture.encoding = ColorEncoding::Linear;  // The original's pictures are linear from end to end.
        scene_.textures.push_back(std::move(texture));
        texturePlaces_.push_back(at);
    }
    return found->second;
}

void SceneTextReader::readTextures() {
    const auto isMissing = [this](const Asset& asset) {
        return !fileExists(resolvePath(assetFile(scene_, asset), scene_.path));
    };
    for (const Asset& asset : idleAssets(scene_)) {
        if (isMissing(asset)) {
            remark(texturePlaces_[asset.index], "textures are missing that no object uses",
                   scene_.textures[asset.index].name);
        }
    }
    readUsedAssets(&assets_, &scene_, [&](const Asset& asset, const Error& error) {
        const TextToken& at = texturePlaces_[asset.index];
        if (isMissing(asset)) {
            remark(at, "textures are missing; the material's own colour takes their place",
                   scene_.textures[asset.index].name);
            return true;
        }
        tokens_.fail(at, fmt::format("the texture cannot be read: {}", error.format()));
        return false;
    });
}

}  // namespace glint
