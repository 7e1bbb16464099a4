// glTF 2.0 specification, section 3.9, and the KHR_materials extensions.
#include "engine/io/gltf_materials.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>

#include "engine/io/file_path.h"
#include "engine/io/gltf_accessor.h"
#include "engine/io/gltf_surface.h"
#include "engine/io/image_io.h"

namespace glint {
namespace {

WrapMode wrapOf(int mode) {
    return mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? WrapMode::Clamp
           : mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? WrapMode::Mirror
                                                           : WrapMode::Repeat;
}

/// glTF counts v from the top row, as flipV does; its transform scales, turns and moves in this order. What
/// it calls counter-clockwise is so for who sees v running down, as all programs have it; the specification's
/// own matrix turns the other way.
void place(const tinygltf::Value* transform, Texture* texture) {
    texture->flipV = true;
    if (transform == nullptr) { return; }
    const auto pair = [transform](const char* key, Vec2 otherwise) {
        const tinygltf::Value& value = transform->Get(key);
        if (!value.IsArray() || value.ArrayLen() != 2) { return otherwise; }
        return Vec2(gltfNumber(value.Get(0).GetNumberAsDouble(), -1e6, 1e6),
                    gltfNumber(value.Get(1).GetNumberAsDouble(), -1e6, 1e6));
    };
    texture->scale = pair("scale", Vec2(1.0f));
    texture->offset = pair("offset", Vec2(0.0f));
    const double turnDeg = numberOf(transform, "rotation", 0.0) * (180.0 / std::numbers::pi);
    texture->rotationDeg = 0.0f - gltfNumber(turnDeg, -1e6, 1e6);
}

}  // namespace

Result<ImageSource> GltfMaterials::sourceOf(int index) {
    const auto& images = file_.model.images;
    if (index < 0 || static_cast<size_t>(index) >= images.size()) {
        return file_.error(fmt::format("there is no image {}; the file has {}", index, images.size()));
    }
    const tinygltf::Image& image = images[static_cast<size_t>(index)];
    const std::string extension = image.mimeType == "image/png"    ? ".png"
                                  : image.mimeType == "image/webp" ? ".webp"
                                                                   : ".jpg";
    const std::string stem = std::filesystem::path(file_.path).stem().string();
    const std::string name = fmt::format("{}-image{}{}", stem, index, extension);
    if (image.bufferView >= 0) {
        const auto bytes = bufferViewBytes(file_, image.bufferView, fmt::format("image {}", index));
        if (!bytes) { return bytes.error(); }
        return ImageSource(EmbeddedFile{name, std::make_shared<const std::string>(*bytes)});
    }
    const auto& kept = file_.dataImages;
    if (static_cast<size_t>(index) < kept.size() && kept[static_cast<size_t>(index)]) {
        return ImageSource(EmbeddedFile{name, kept[static_cast<size_t>(index)]});
    }
    return ImageSource(FileSource{gltfPath(image.uri)});
}

template <class Info>
Result<int> GltfMaterials::takeTexture(const Info& info, const Reading& reading) {
    if (info.index < 0) { return -1; }
    const auto& textures = file_.model.textures;
    if (static_cast<size_t>(info.index) >= textures.size()) {
        return file_.error(
            fmt::format("there is no texture {}; the file has {}", info.index, textures.size()));
    }
    const tinygltf::Texture& from = textures[static_cast<size_t>(info.index)];
    const int image = gltfImage(from);
    if (image < 0) {
        file_.remark("textures without an image that Glint reads are left out", from.name);
        return -1;
    }
    Result<ImageSource> source = sourceOf(image);
    if (!source) { return source.error(); }
    Texture texture;
    texture.name = file_.model.images[static_cast<size_t>(image)].name;
    if (texture.name.empty()) { texture.name = fmt::format("image {}", image); }
    texture.image.source = std::move(*source);
    texture.encoding = reading.encoding;
    texture.channel = reading.channel;
    texture.gain = reading.gain;
    texture.exponent = reading.exponent;
    const tinygltf::Value* transform = extensionOf(info, "KHR_texture_transform");
    place(transform, &texture);
    if (from.sampler >= 0 && static_cast<size_t>(from.sampler) < file_.model.samplers.size()) {
        const tinygltf::Sampler& sampler = file_.model.samplers[static_cast<size_t>(from.sampler)];
        texture.wrapU = wrapOf(sampler.wrapS);
        texture.wrapV = wrapOf(sampler.wrapT);
        const bool isNearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
        texture.filter = isNearest ? TexelFilter::Nearest : TexelFilter::Bilinear;
    }
    const std::string key =
        fmt::format("{} {} {} {} {} {} {} {} {} {} {}", info.index, static_cast<int>(reading.encoding),
                    static_cast<int>(reading.channel), reading.gain, reading.exponent, texture.scale.x,
                    texture.scale.y, texture.offset.x, texture.offset.y, texture.rotationDeg, image);
    const auto [known, isNew] = textures_.try_emplace(key, static_cast<int>(scene_.textures.size()));
    if (isNew) { scene_.textures.push_back(std::move(texture)); }
    uvSets_.push_back(indexOf(transform, "texCoord", info.texCoord));
    return known->second;
}

template Result<int> GltfMaterials::takeTexture(const tinygltf::TextureInfo&, const Reading&);

Result<GltfMaterials::Surface> GltfMaterials::surfaceImage(int index) {
    if (const auto known = surfaces_.find(index); known != surfaces_.end()) { return known->second; }
    if (static_cast<size_t>(index) >= file_.model.textures.size()) {
        return file_.error(
            fmt::format("there is no texture {}; the file has {}", index, file_.model.textures.size()));
    }
    const int number = gltfImage(file_.model.textures[static_cast<size_t>(index)]);
    if (number < 0) { return Surface(); }
    const Result<ImageSource> source = sourceOf(number);
    if (!source) { return source.error(); }
    const auto* embedded = std::get_if<EmbeddedFile>(&*source);
    const Result<SceneImage> image = embedded != nullptr
                                         ? decodeImage(*embedded->bytes, embedded->name)
                                         : loadImage(resolvePath(pathOf(*source), file_.path));
    Surface surface;
    if (image && image->bytes) {
        const std::vector<uint8_t>& rgb = image->bytes->rgb;
        double roughness = 0.0, metalness = 0.0;
        for (size_t i = 0; i + 2 < rgb.size(); i += 3) {
            roughness += rgb[i + 1];
            metalness += rgb[i + 2];
            surface.isEvenlyRough = surface.isEvenlyRough && rgb[i + 1] == rgb[1];
            surface.isEvenlyMetallic = surface.isEvenlyMetallic && rgb[i + 2] == rgb[2];
        }
        const double scale = 3.0 / (255.0 * static_cast<double>(rgb.size()));
        surface.roughness = static_cast<float>(roughness * scale);
        surface.metalness = static_cast<float>(metalness * scale);
    } else {
        file_.remark("images of roughness or metalness cannot be read", pathOf(*source));
    }
    return surfaces_[index] = surface;
}

Status GltfMaterials::takeSurfaceImage(const tinygltf::TextureInfo& info, bool isMetallic, Material* out) {
    const Result<Surface> image = surfaceImage(info.index);
    if (!image) { return image.error(); }
    if (!image->isEvenlyRough) {
        const float factor = std::sqrt(out->roughness.value);
        const auto map = takeTexture(info, {ColorEncoding::Linear, TextureChannel::Green, factor, 2.0f});
        if (!map) { return map.error(); }
        out->roughness.texture = *map;
    }
    if (isMetallic && !image->isEvenlyMetallic) {
        const float factor = out->metallic.value;
        const auto map = takeTexture(info, {ColorEncoding::Linear, TextureChannel::Blue, factor});
        if (!map) { return map.error(); }
        out->metallic.texture = *map;
    }
    out->roughness.value *= square(image->roughness);
    out->metallic.value *= image->metalness;
    return {};
}

Status GltfMaterials::takeSurface(const tinygltf::Material& from, Material* out) {
    const tinygltf::PbrMetallicRoughness pbr = gltfSurface(from);
    const bool isGlass = isOnlyGlass(from);
    out->roughness.value = square(gltfNumber(pbr.roughnessFactor, 0.0, 1.0));
    out->metallic.value = gltfNumber(pbr.metallicFactor, 0.0, 1.0);
    if (pbr.metallicRoughnessTexture.index >= 0) {
        const bool isMetallic = !isGlass && out->metallic.value > 0.0f;
        Status status = takeSurfaceImage(pbr.metallicRoughnessTexture, isMetallic, out);
        if (!status) { return status; }
    }
    const float most = isGlass ? 0.01f : 1.0f;
    out->ior.value = gltfNumber(numberOf(extensionOf(from, "KHR_materials_ior"), "ior", 1.5),
                                static_cast<double>(most), 100.0);
    if (extensionOf(from, "KHR_materials_unlit") != nullptr) {
        out->kind = MaterialKind::Diffuse;
        out->emission = out->color;
        out->color = {Vec3(0.0f)};
        out->emitsBothSides = true;
        file_.remark("unlit materials are taken for surfaces that shine", from.name);
    } else if (isGlass) {
        out->kind = MaterialKind::Dielectric;
        takeVolume(extensionOf(from, "KHR_materials_volume"), out);
        if (Status status = takeAnisotropy(from, out); !status) { return status; }
    } else if (const auto* sheet = extensionOf(from, "KHR_materials_diffuse_transmission");
               out->metallic.value < 0.5f && numberOf(sheet, "diffuseTransmissionFactor", 0.0) > 0.0) {
        takeSheet(*sheet, out);
        if (Status status = takeSheetImages(*sheet, out); !status) { return status; }
        file_.remark("sheets that light passes diffusely have no highlights", from.name);
    } else {
        out->kind = MaterialKind::Principled;
        if (Status status = takeLayers(from, out); !status) { return status; }
        if (transmits(*out)) { takeVolume(extensionOf(from, "KHR_materials_volume"), out); }
        if (Status status = takeAnisotropy(from, out); !status) { return status; }
        if (const auto* film = extensionOf(from, "KHR_materials_iridescence")) {
            takeIridescence(*film, out);
            file_.remark("approximated: iridescence is the colour that it shows from the front", from.name);
        }
    }
    return {};
}

void GltfMaterials::takeAlpha(const tinygltf::Material& from, int colorTexture, Material* out) {
    const float factor = gltfNumber(gltfSurface(from).baseColorFactor[3], 0.0, 1.0);
    const float limit = gltfNumber(from.alphaCutoff, 0.0, 1e3);
    const bool isMask = from.alphaMode == "MASK";
    out->alphaCutsOut = from.alphaMode == "BLEND";
    if (out->alphaCutsOut) { out->opacity = {factor, out->color.texture < 0 ? colorTexture : -1}; }
    if (!isMask) { return; }
    out->opacity = {factor >= limit ? 1.0f : 0.0f, -1};
    if (colorTexture < 0) { return; }
    constexpr float kSteep = 1e4f;
    Texture mask = scene_.textures[static_cast<size_t>(colorTexture)];
    mask.channel = TextureChannel::Alpha;
    mask.gain = kSteep * factor;
    mask.base = 1.0f - kSteep * limit;
    out->opacity.texture = static_cast<int>(scene_.textures.size());
    scene_.textures.push_back(std::move(mask));
}

void GltfMaterials::remarkLeftOut(const tinygltf::Material& from) {
    if (from.occlusionTexture.index >= 0) {
        file_.remark("occlusion maps are left out: light is occluded by itself", from.name);
    }
    for (const auto& [name, value] : from.extensions) {
        if (!readsGltfExtension(name)) { file_.remark("extensions of materials are left out", name); }
    }
}

Result<GltfMaterial> GltfMaterials::take(int index) {
    if (const auto known = taken_.find(index); known != taken_.end()) { return known->second; }
    const auto& materials = file_.model.materials;
    if (index >= static_cast<int>(materials.size())) {
        return file_.error(fmt::format("there is no material {}; the file has {}", index, materials.size()));
    }
    static const tinygltf::Material kDefault;
    const tinygltf::Material& from = index >= 0 ? materials[static_cast<size_t>(index)] : kDefault;
    uvSets_.clear();
    Material out;
    out.name = !from.name.empty() ? from.name : index >= 0 ? fmt::format("material {}", index) : "default";
    const tinygltf::PbrMetallicRoughness pbr = gltfSurface(from);
    const Result<int> color = takeTexture(pbr.baseColorTexture, {ColorEncoding::Srgb});
    if (!color) { return color.error(); }
    out.color = {gltfColor(pbr.baseColorFactor), *color};
    GltfMaterial taken{.index = static_cast<int>(scene_.materials.size())};
    if (*color >= 0) { taken.vertexFactor = out.color.value; }
    if (const Status status = takeSurface(from, &out); !status) { return status.error(); }
    const Result<int> normal = takeTexture(from.normalTexture, {});
    if (!normal) { return normal.error(); }
    out.normalMap.texture = *normal;
    out.normalStrength = gltfNumber(from.normalTexture.scale, 0.0, 1e3);
    const Result<int> emission = takeTexture(from.emissiveTexture, {ColorEncoding::Srgb});
    if (!emission) { return emission.error(); }
    const Vec3 factor = from.emissiveFactor.empty() ? Vec3(0.0f) : gltfColor(from.emissiveFactor, 1e6);
    const auto* strength = extensionOf(from, "KHR_materials_emissive_strength");
    const float times = gltfNumber(numberOf(strength, "emissiveStrength", 1.0), 0.0, 1e9);
    if (maxComponent(factor) > 0.0f) {
        out.emission = {factor, *emission};
        out.emissionStrength = times * (*emission >= 0 ? maxComponent(factor) : 1.0f);
        out.emitsBothSides = from.doubleSided;
        if (*emission >= 0 && minComponent(factor) < maxComponent(factor)) {
            file_.remark("emission maps lose the colour of their factor", from.name);
        }
    }
    takeAlpha(from, *color, &out);
    taken.usesTangents = out.normalMap.texture >= 0 || isAnisotropic(out);
    if (!uvSets_.empty()) { taken.uvSet = uvSets_.front(); }
    if (std::ranges::any_of(uvSets_, [&](int set) { return set != taken.uvSet; })) {
        file_.remark("all maps of a material use the texture coordinates of one of them", from.name);
    }
    remarkLeftOut(from);
    scene_.materials.push_back(std::move(out));
    return taken_[index] = taken;
}

}  // namespace glint
