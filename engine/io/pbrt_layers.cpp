// pbrt's materials of several layers or lobes, which Glint's models express in part.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/burley.h"
#include "engine/io/clear_coat.h"
#include "engine/io/pbrt_materials.h"
#include "engine/math/color.h"

namespace glint {
namespace {

constexpr float kCoatThickness = 0.01f;  // where the file does not say

/// What a half-space of scatterers of that single-scattering albedo reflects of diffuse light: van de Hulst
/// 1980, "Multiple Light Scattering", volume 2.
float halfSpaceAlbedo(float albedo) {
    const float s = std::sqrt(1.0f - std::clamp(albedo, 0.0f, 1.0f));
    return (1.0f - s) * (1.0f - 0.139f * s) / (1.0f + 1.17f * s);
}

/// The colour of hair that absorbs so much: Chiang et al. 2016, "A Practical and Controllable Hair and Fur
/// Model for Production Path Tracing", for an azimuthal roughness of 0.3.
Vec3 hairColor(const Vec3& absorption) {
    constexpr float kScale =
        5.969f - 0.215f * 0.3f + 2.532f * 0.09f - 10.73f * 0.027f + 5.574f * 0.0081f + 0.245f * 0.00243f;
    return glm::exp(-kScale * glm::sqrt(glm::max(absorption, Vec3(0.0f))));
}

bool isPlainDiffuse(const PbrtSurface& surface) {
    const Material& m = surface.material;
    return surface.isThere && m.kind == MaterialKind::Diffuse && m.bump.texture < 0 &&
           m.normalMap.texture < 0 && !surface.share.image && surface.share.value == Vec3(1.0f);
}

}  // namespace

float PbrtMaterials::coatIndex(const PbrtParams& params, std::string_view name) {
    const PbrtParam* eta = params.find(name);
    if (eta == nullptr) { return 1.5f; }
    if (eta->type == PbrtType::Texture) { return std::clamp(meanNumber(params, name, 1.5f), 1.0f, 100.0f); }
    const Vec3 index = pbrtColor(params, *eta, SpectrumRole::Index);
    const bool isGrey = index.x == index.y && index.y == index.z;
    const bool isNamedGlass = !eta->texts.empty() && !pbrtGlass(eta->texts[0]).empty();
    if (!isGrey || isNamedGlass) { params.approximated("approximated: coats do not disperse"); }
    return std::clamp(isGrey ? index.x : luminance(index), 1.0f, 100.0f);
}

void PbrtMaterials::readCoatedDiffuse(const PbrtParams& params, PbrtSurface* out) {
    Material& material = out->material;
    material.kind = MaterialKind::Plastic;
    material.color = reflectance(params, {"reflectance"}, 0.5f);
    readRoughness(params, "", 0.0f, &material);
    material.ior.value = coatIndex(params, "eta");
    if (meanNumber(params, "thickness", kCoatThickness) > kCoatThickness) {
        params.approximated("approximated: coats of plastic absorb nothing");
    }
    params.passOver({"maxdepth", "nsamples", "twosided", "g"});
    if (const auto albedo = textures_.color(params, "albedo", SpectrumRole::Reflectance);
        albedo && (albedo->image || !isZero(albedo->value))) {
        params.approximated("approximated: nothing scatters within coats");
    }
}

void PbrtMaterials::readCoatedReflectance(const PbrtParams& params, const PbrtValue& bare, float index,
                                          Material* material) {
    material->metal.clear();
    if (!bare.image) {
        const Vec3 r = glm::min(bare.value, Vec3(0.9999f));  // at right angles, of eta 1
        material->eta.value = Vec3(1.0f / index);
        material->k.value = (2.0f / index) * glm::sqrt(r / (Vec3(1.0f) - r));
        return;
    }
    params.approximated("approximated: metals that reflect a picture do so alike at all angles");
    material->eta.value = Vec3(1e-3f);
    material->k.value = Vec3(1e4f);
    material->color = textures_.colorInput(textures_.changed(params, bare, [index](float r) {
        const float below = square(index - 1.0f), above = square(index + 1.0f);
        r = std::clamp(r, 0.0f, 1.0f);
        return (below * (1.0f - r) + 4.0f * r) / (above * (1.0f - r) + 4.0f * r);
    }));
}

/// A unit of the coat's thickness is one optical depth: what does not scatter is absorbed.
void PbrtMaterials::readCoatedConductor(const PbrtParams& params, PbrtSurface* out) {
    Material& material = out->material;
    params.approximated("approximated: light does not go back and forth under coats over metal");
    const float index = coatIndex(params, "interface.eta");
    material.kind = MaterialKind::Conductor;
    material.color.value = Vec3(1.0f);
    readRoughness(params, "conductor.", 0.0f, &material);
    if (const auto color = textures_.color(params, "reflectance", SpectrumRole::Reflectance)) {
        readCoatedReflectance(params, *color, index, &material);
    } else {
        readMetal(params, "conductor.", index, &material);
    }
    Material coat;
    readRoughness(params, "interface.", 0.0f, &coat);
    if (hasCrossRoughness(coat)) {
        params.approximated("approximated: coats over metal are rough as along u");
    }
    if (coat.roughness.value > 0.0f || coat.roughness.texture >= 0) {
        params.approximated("approximated: rough coats over metal do not broaden what passes them");
    }
    coatMetal(index, coat.roughness, &material);
    Vec3 absorbed(std::max(meanNumber(params, "thickness", kCoatThickness), 0.0f));
    if (const auto albedo = textures_.color(params, "albedo", SpectrumRole::Reflectance);
        albedo && (albedo->image || !isZero(albedo->value))) {
        absorbed *= Vec3(1.0f) - glm::clamp(textures_.meanOf(*albedo), Vec3(0.0f), Vec3(1.0f));
        params.approximated("approximated: nothing scatters within coats");
    }
    material.coatAbsorption.value = absorbed;
    params.passOver({"maxdepth", "nsamples", "g"});
}

void PbrtMaterials::readTransmission(const PbrtParams& params, PbrtSurface* out) {
    const PbrtValue usual{Vec3(0.25f)};
    auto reflected = textures_.color(params, "reflectance", SpectrumRole::Reflectance);
    auto passed = textures_.color(params, "transmittance", SpectrumRole::Reflectance);
    float scale = params.number("scale", 1.0f, 0.0f);
    if (const auto both =
            textures_.color(params, "Kd", SpectrumRole::Reflectance)) {  // pbrt-v3's translucent
        params.approximated("approximated: pbrt-v3's translucent reflects half, and has no highlights");
        reflected = passed = both;
        scale *= 0.5f;
    }
    params.passOver({"Ks", "roughness", "reflect", "transmit", "remaproughness"});
    const auto scaled = [&](const std::optional<PbrtValue>& value) {
        return textures_.colorInput(PbrtTextures::adjusted(value.value_or(usual), 0.0f, scale, 1.0f));
    };
    out->material.kind = MaterialKind::Translucent;
    out->material.color = scaled(reflected);
    out->material.transmission = scaled(passed);
}

void PbrtMaterials::readMix(const PbrtParams& params, PbrtSurface* out) {
    std::vector<std::string> names;
    if (const PbrtParam* list = params.find("materials")) { names = list->texts; }
    if (names.empty() && params.has("namedmaterial1")) {
        names = {params.text("namedmaterial1"), params.text("namedmaterial2")};
    }
    if (names.size() != 2) {
        params.fail("expected the names of two \"materials\" to mix");
        return;
    }
    const PbrtSurface first = surfaceOf(numberOf(names[0], params.place())),
                      second = surfaceOf(numberOf(names[1], params.place()));
    const PbrtValue amount = textures_.number(params, "amount").value_or(PbrtValue{Vec3(0.5f)});
    if (context_.failed()) { return; }
    if (first.isThere != second.isThere) {
        *out = first.isThere ? first : second;
        out->share = first.isThere ? PbrtTextures::adjusted(amount, 1.0f, -1.0f, 1.0f) : amount;
        return;
    }
    if (isPlainDiffuse(first) && isPlainDiffuse(second)) {
        const auto valueOf = [&](const Material& material) {
            PbrtValue value{material.color.value};
            if (material.color.texture >= 0) {
                value.image = context_.scene.textures[static_cast<size_t>(material.color.texture)];
            }
            return value;
        };
        out->material.color = textures_.colorInput(
            textures_.mixed(params, valueOf(first.material), valueOf(second.material), amount));
        return;
    }
    params.approximated("approximated: of mixed materials the one that weighs more is taken");
    *out = luminance(textures_.meanOf(amount)) > 0.5f ? second : first;
}

void PbrtMaterials::readMeasured(const PbrtParams& params, PbrtSurface* out) {
    params.approximated("approximated: measured materials are a rough grey plastic");
    params.passOver({"filename"});
    out->material.kind = MaterialKind::Plastic;
    out->material.color.value = Vec3(0.3f);
    out->material.roughness.value = 0.3f;
}

void PbrtMaterials::readHair(const PbrtParams& params, PbrtSurface* out) {
    params.approximated("approximated: hair is diffuse, of its colour");
    params.passOver({"eta", "beta_m", "beta_n", "alpha"});
    const float eumelanin = meanNumber(params, "eumelanin", params.has("pheomelanin") ? 0.0f : 1.3f);
    const float pheomelanin = meanNumber(params, "pheomelanin", 0.0f);
    Vec3 absorption = eumelanin * Vec3(0.419f, 0.697f, 1.37f) + pheomelanin * Vec3(0.187f, 0.4f, 1.05f);
    if (const auto given = textures_.color(params, "sigma_a", SpectrumRole::Index)) {
        absorption = textures_.meanOf(*given);
    }
    out->material.color.value = hairColor(absorption);
    if (const auto color = textures_.color(params, params.has("color") ? "color" : "reflectance",
                                           SpectrumRole::Reflectance)) {
        out->material.color = textures_.colorInput(*color);
    }
}

void PbrtMaterials::readSubsurface(const PbrtParams& params, PbrtSurface* out) {
    params.approximated("approximated: what scatters below its surface is plastic");
    Material& material = out->material;
    material.kind = MaterialKind::Plastic;
    readRoughness(params, "", 0.0f, &material);
    material.ior.value = params.number("eta", 1.33f, 1.0f, 100.0f);
    params.passOver({"mfp", "g", "scale", "Kr", "Kt"});
    Vec3 absorbed(0.0011f, 0.0024f, 0.014f), scattered(2.55f, 3.21f, 3.77f);
    if (params.has("name")) {
        params.approximated("approximated: named media below surfaces are pbrt's default one");
    }
    const auto a = textures_.color(params, "sigma_a", SpectrumRole::Index);
    const auto s = textures_.color(params, "sigma_s", SpectrumRole::Index);
    if (a && s) {
        absorbed = textures_.meanOf(*a);
        scattered = textures_.meanOf(*s);
    }
    for (int c = 0; c < 3; ++c) {
        material.color.value[c] = halfSpaceAlbedo(scattered[c] / maxf(scattered[c] + absorbed[c], 1e-9f));
    }
    const bool isKd = params.has("Kd");
    if (const auto color = textures_.color(params, isKd ? "Kd" : "reflectance", SpectrumRole::Reflectance)) {
        material.color = textures_.colorInput(*color);
    }
}

void PbrtMaterials::readOldCoated(const PbrtParams& params, PbrtSurface* out) {
    params.approximated("approximated: pbrt-v3's plastic, substrate and uber are plastic");
    Material& material = out->material;
    material.kind = MaterialKind::Plastic;
    material.color = reflectance(params, {"Kd"}, 0.5f);
    readRoughness(params, "", 0.1f, &material);
    params.passOver({"Ks", "Kr", "Kt"});
    const float eta = params.number(params.has("index") ? "index" : "eta", 1.5f, 1.0f, 100.0f);
    material.ior.value = eta;
    if (const auto opacity = textures_.color(params, "opacity", SpectrumRole::Reflectance)) {
        out->share = {textures_.meanOf(*opacity)};
    }
}

void PbrtMaterials::readDisney(const PbrtParams& params, PbrtSurface* out) {
    params.approximated("approximated: the layers of pbrt-v3's disney gain nothing");
    Material& material = out->material;
    material.kind = MaterialKind::Principled;
    material.color = reflectance(params, {"color"}, 0.5f);
    material.ior.value = params.number("eta", 1.5f, 1.0f, 100.0f);
    const auto share = [&](std::string_view name, float otherwise, float exponent, float gain = 1.0f) {
        const PbrtValue value = textures_.number(params, name).value_or(PbrtValue{Vec3(otherwise)});
        NumberInput input = textures_.numberInput(PbrtTextures::adjusted(value, 0.0f, gain, exponent));
        input.value = std::clamp(input.value, 0.0f, 1.0f);
        return input;
    };
    material.metallic = share("metallic", 0.0f, 1.0f);
    const float root = std::sqrt(burleyAspect(meanNumber(params, "anisotropic", 0.0f)));
    material.roughness = share("roughness", 0.5f, 2.0f, 1.0f / root);
    if (root < 1.0f) { material.crossRoughness = share("roughness", 0.5f, 2.0f, root); }
    material.clearcoat.value = kBurleyCoat * std::clamp(meanNumber(params, "clearcoat", 0.0f), 0.0f, 1.0f);
    material.clearcoatRoughness.value = burleyCoatAlpha(meanNumber(params, "clearcoatgloss", 1.0f));
    const Vec3& base = material.color.value;
    material.specularTint.value = burleyTint(base, meanNumber(params, "speculartint", 0.0f));
    material.sheenColor.value = kBurleySheen * std::clamp(meanNumber(params, "sheen", 0.0f), 0.0f, 1.0f) *
                                burleyTint(base, meanNumber(params, "sheentint", 0.5f));
    material.sheenRoughness.value = kBurleySheenAlpha;
    material.specularTransmission = share("spectrans", 0.0f, 1.0f);
    material.rootTint = transmits(material);
    material.thin = material.rootTint && params.flag("thin", false);
    params.passOver({"flatness", "difftrans", "thin", "scatterdistance"});
}

}  // namespace glint
