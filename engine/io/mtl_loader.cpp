#include "engine/io/mtl_loader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "engine/io/burley.h"
#include "engine/io/file_kind.h"
#include "engine/io/mtl_glass.h"
#include "engine/io/plain_text.h"

namespace glint {
namespace {

constexpr float kBlack = 1e-3f;

Vec3 unitColor(const tinyobj::real_t (&rgb)[3]) {
    return glm::clamp(Vec3(rgb[0], rgb[1], rgb[2]), Vec3(0.0f), Vec3(1.0f));
}

void makeDielectric(const tinyobj::material_t& values, const MtlGlass& glass, Material* out) {
    out->kind = MaterialKind::Dielectric;
    out->color.value = glass.tint;
    out->thin = !(values.ior > 1.0f);
    out->ior.value = out->thin ? 1.5f : std::min(values.ior, 100.0f);
    out->roughness.value = 0.0f;
}

void makeConductor(const Vec3& reflectance, Material* out) {
    out->kind = MaterialKind::Conductor;
    out->metal.clear();
    out->color.value = Vec3(1.0f);
    const Vec3 r = glm::clamp(reflectance, Vec3(0.0f), Vec3(0.999f));
    out->eta.value = (Vec3(1.0f) - r) / (Vec3(1.0f) + r);
    out->k.value = 2.0f * glm::sqrt(r) / (Vec3(1.0f) + r);
}

void makePlastic(const tinyobj::material_t& values, Material* out) {
    out->kind = MaterialKind::Plastic;
    out->ior.value = values.ior > 1.0f ? std::min(values.ior, 100.0f) : 1.5f;
}

/// Whether it lies between plastic and metal, or under a coat or sheen.
bool isLayered(const MtlEntry& entry, const tinyobj::material_t& values) {
    return entry.has(MtlKey::MapPm) || (values.metallic > 0.0f && values.metallic < 1.0f) ||
           values.clearcoat_thickness > 0.0f || values.sheen > 0.0f;
}

void makePrincipled(const tinyobj::material_t& values, Material* out) {
    const auto share = [](float value) { return std::clamp(value, 0.0f, 1.0f); };
    out->kind = MaterialKind::Principled;
    out->metallic.value = share(values.metallic);
    out->clearcoat.value = share(values.clearcoat_thickness);
    out->clearcoatRoughness.value = square(share(values.clearcoat_roughness));
    out->sheenColor.value = Vec3(share(values.sheen));
}

/// Zeros are what exporters write that know the keys and not the material.
bool usesPbr(const MtlEntry& entry, const tinyobj::material_t& values) {
    return isLayered(entry, values) || (entry.has(MtlKey::Pm) && values.metallic > 0.0f) ||
           (entry.has(MtlKey::Pr) && values.roughness > 0.0f) || entry.has(MtlKey::MapPr);
}

/// aniso and anisor of the PBR extension are Burley's.
void setAnisotropy(const tinyobj::material_t& values, Material* out) {
    const float aspect = burleyAspect(values.anisotropy);
    if (!(aspect < 1.0f) || !hasFacets(out->kind) || out->roughness.value == 0.0f) { return; }
    const float alpha = out->roughness.value;
    out->roughness.value = std::min(alpha / aspect, 1.0f);
    out->crossRoughness.value = alpha * aspect;
    out->anisotropyRotationDeg = 360.0f * std::clamp(values.anisotropy_rotation, -1e3f, 1e3f);
}

void makePbr(const MtlEntry& entry, const tinyobj::material_t& values, const Vec3& base, Material* out) {
    if (entry.has(MtlKey::Pr)) {
        const float roughness = std::clamp(values.roughness, 0.0f, 1.0f);
        out->roughness.value = roughness * roughness;
    }
    if (values.metallic >= 1.0f && !isLayered(entry, values)) {
        makeConductor(base, out);
    } else {
        makePlastic(values, out);
        if (isLayered(entry, values)) { makePrincipled(values, out); }
    }
}

void makePhong(const tinyobj::material_t& values, const Vec3& diffuse, Material* out) {
    const bool mirrorLike = values.illum == 3 || values.illum == 5;
    const Vec3 specular = values.illum == 0 || values.illum == 1 ? Vec3(0.0f) : unitColor(values.specular);
    const bool isBlackBase = maxComponent(diffuse) <= kBlack && values.diffuse_texname.empty();
    if (mirrorLike) { out->roughness.value = 0.0f; }
    if (maxComponent(specular) <= kBlack) {
        out->roughness.value = 0.0f;
    } else if (isBlackBase && mirrorLike) {
        out->kind = MaterialKind::Mirror;
        out->color.value = specular;
    } else if (isBlackBase) {
        makeConductor(specular, out);
    } else {
        makePlastic(values, out);
    }
}

Material toGlint(const MtlEntry& entry, const tinyobj::material_t& values, const MtlGlass& glass) {
    Material out;
    out.name = entry.name;
    out.emission.value =
        glm::max(Vec3(values.emission[0], values.emission[1], values.emission[2]), Vec3(0.0f));
    out.emitsBothSides = out.emissive();
    out.color.value =
        entry.has(MtlKey::Kd) || entry.has(MtlKey::MapKd) ? unitColor(values.diffuse) : Vec3(0.5f);
    out.roughness.value = clampf(std::sqrt(2.0f / (std::max(values.shininess, 0.0f) + 2.0f)), 0.0f, 1.0f);
    const Vec3 diffuse = out.color.value;
    if (!glass.isGlass && !entry.has(MtlKey::MapD)) { out.opacity.value = glass.opacity; }
    if (glass.isGlass) {
        makeDielectric(values, glass, &out);
    } else if (usesPbr(entry, values)) {
        makePbr(entry, values, diffuse, &out);
    } else {
        makePhong(values, diffuse, &out);
    }
    setAnisotropy(values, &out);
    return out;
}

TextureChannel channelOf(char imfchan) {
    switch (imfchan) {
        case 'g':
            return TextureChannel::Green;
        case 'b':
            return TextureChannel::Blue;
        case 'l':
            return TextureChannel::Luminance;
        default:
            return TextureChannel::Red;  // "m" is alpha, which counts before the channel where it is asked
                                         // for
    }
}

MtlMap mapOf(const std::string& file, const tinyobj::texture_option_t& options, int line) {
    MtlMap map{file, {}, line};
    map.shown.scale = {options.scale[0], options.scale[1]};
    map.shown.offset = {options.origin_offset[0], options.origin_offset[1]};
    map.shown.base = options.brightness;
    map.shown.gain = options.contrast;
    if (options.clamp) { map.shown.wrapU = map.shown.wrapV = WrapMode::Clamp; }
    return map;
}

MtlMap numberMapOf(const std::string& file, const tinyobj::texture_option_t& options, int line) {
    MtlMap map = mapOf(file, options, line);
    map.shown.channel = channelOf(options.imfchan);
    return map;
}

}  // namespace

Result<MtlLibrary> loadMtl(const std::string& path) {
    Result<std::string> text = readFileOfKind(path, looksLikeText);
    if (!text) { return text.error(); }
    const std::optional<PlainText> plain = asPlainText(*text);
    MtlLibrary library{.path = path, .file = readMtlEntries(plain ? plain->text : *text, path)};
    if (plain) {
        library.file.remarks.add(plain->repaired, [&] { return path; });
    }
    library.trIsOpacity = trIsOpacity(library.file.entries);
    return library;
}

MtlMaterial materialOf(const MtlEntry& entry, MtlLibrary* library) {
    const tinyobj::material_t values = entry.values();
    const MtlGlass glass = glassOf(entry, values, library->trIsOpacity);
    MtlMaterial mtl{
        .material = toGlint(entry, values, glass),
        .color = mapOf(values.diffuse_texname, values.diffuse_texopt, entry.lineOf(MtlKey::MapKd)),
        .emission = mapOf(values.emissive_texname, values.emissive_texopt, entry.lineOf(MtlKey::MapKe)),
        .roughness =
            numberMapOf(values.roughness_texname, values.roughness_texopt, entry.lineOf(MtlKey::MapPr)),
        .crossRoughness = {},
        .metallic = numberMapOf(values.metallic_texname, values.metallic_texopt, entry.lineOf(MtlKey::MapPm)),
        .height = numberMapOf(values.bump_texname, values.bump_texopt,
                              entry.lineOf(entry.has(MtlKey::Bump) ? MtlKey::Bump : MtlKey::MapBump)),
        .bumpFactor = values.bump_texopt.bump_multiplier,
        .normal = mapOf(values.normal_texname, values.normal_texopt, entry.lineOf(MtlKey::Norm)),
        .opacity = numberMapOf(values.alpha_texname, values.alpha_texopt, entry.lineOf(MtlKey::MapD)),
        .glass = glass.isGlass ? glass.why : "",
        .doubt = glass.isGlass ? "" : glass.why};
    mtl.roughness.shown.exponent = 2.0f;
    if (hasCrossRoughness(mtl.material)) {
        const float root = std::sqrt(burleyAspect(values.anisotropy));
        mtl.crossRoughness = mtl.roughness;
        mtl.roughness.shown.gain /= root;
        mtl.crossRoughness.shown.gain *= root;
        mtl.roughness.shown.base /= root;
        mtl.crossRoughness.shown.base *= root;
    }
    mtl.material.normalStrength = values.normal_texopt.bump_multiplier;
    if (mtl.opacity.file == mtl.color.file) { mtl.opacity.file.clear(); }
    return mtl;
}

}  // namespace glint
