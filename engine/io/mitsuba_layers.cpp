// Materials of several layers or lobes, which Glint's models express in part.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/burley.h"
#include "engine/io/clear_coat.h"
#include "engine/io/mitsuba_materials.h"
#include "engine/math/color.h"

namespace glint {
namespace {

/// What a smooth boundary reflects of diffuse light from outside: Walsh 1926, "The Reflection Factor of a
/// Polished Glass Surface for Diffused Light".
float diffuseFresnel(float index) {
    const double n = static_cast<double>(index), n2 = n * n, n4 = n2 * n2;
    if (n < 1.0 + 1e-4) { return 0.0f; }
    const double sum =
        0.5 + (n - 1.0) * (3.0 * n + 1.0) / (6.0 * (n + 1.0) * (n + 1.0)) +
        n2 * (n2 - 1.0) * (n2 - 1.0) / std::pow(n2 + 1.0, 3.0) * std::log((n - 1.0) / (n + 1.0)) -
        2.0 * n2 * n * (n2 + 2.0 * n - 1.0) / ((n2 + 1.0) * (n4 - 1.0)) +
        8.0 * n4 * (n4 + 1.0) / ((n2 + 1.0) * (n4 - 1.0) * (n4 - 1.0)) * std::log(n);
    return static_cast<float>(sum);
}

/// The colour of Glint's base, in which light goes on between base and coat, for Mitsuba's, in which a linear
/// one takes white for the base there.
Vec3 baseOfLinear(const Vec3& color, float internal) {
    return color / (Vec3(1.0f - internal) + internal * color);
}

/// Greys keep their digits.
float numberIn(const Vec3& color) {
    return color.x == color.y && color.y == color.z ? color.x : luminance(color);
}

}  // namespace

void MitsubaMaterials::readPlastic(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    Material& material = out->material;
    material.kind = MaterialKind::Plastic;
    const float ior = readIndex(object, "int_ior", 1.49f) / readIndex(object, "ext_ior", kAir);
    material.ior.value = std::clamp(ior, 1.0f, 100.0f);
    const auto color = mitsubaInput(object, {"diffuse_reflectance"}, SpectrumRole::Reflectance);
    const MitsubaInput grey{Vec3(0.5f), nullptr};
    MitsubaTextures::Change change;
    if (!object->flag("nonlinear", false)) {
        const float internal =
            1.0f - (1.0f - diffuseFresnel(material.ior.value)) / square(material.ior.value);
        change = [internal](const Vec3& c) { return baseOfLinear(c, internal); };
    }
    material.color = colorOf(color.value_or(grey), origin, change);
    const auto tint = mitsubaInput(object, {"specular_reflectance"}, SpectrumRole::Reflectance);
    if (tint && (tint->texture != nullptr || tint->color != Vec3(1.0f))) {
        object->approximated("approximated: coats reflect without a tint");
    }
    if (object->type() == "roughplastic") {
        readRoughness(object, origin, &material);
        object->approximated("approximated: rough plastic's coat loses no light between its facets");
    }
}

void MitsubaMaterials::readCoating(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    *out = nested(object, origin);
    const auto tint = mitsubaInput(object, {"specular_reflectance"}, SpectrumRole::Reflectance);
    if (tint && (tint->texture != nullptr || tint->color != Vec3(1.0f))) {
        object->approximated("approximated: coats reflect without a tint");
    }
    const float ior = readIndex(object, "int_ior", 1.5046f) / readIndex(object, "ext_ior", kAir);
    const float thickness = object->number("thickness", 1.0f, 0.0f);
    const auto absorption = mitsubaInput(object, {"sigma_a"}, SpectrumRole::Index);
    Material coat;
    if (object->type() == "roughcoating") { readRoughness(object, origin, &coat); }
    const MaterialKind below = out->material.kind;
    if (below == MaterialKind::Conductor || below == MaterialKind::Mirror) {
        coatMetal(std::clamp(ior, 1.0f, 100.0f), coat.roughness, &out->material);
        if (absorption) {
            out->material.coatAbsorption =
                colorOf(*absorption, origin, [thickness](const Vec3& c) { return thickness * c; });
        }
        if (object->type() == "roughcoating") {
            object->approximated(
                "approximated: rough coats over metal have GGX facets, alike in all directions");
        }
        return;
    }
    const bool isDiffuse = below == MaterialKind::Diffuse;
    if (!coatMaterial(std::clamp(ior, 1.0f, 100.0f), coat.roughness, &out->material)) {
        object->approximated(
            "approximated: coats over glass, plastic, sheets, highlights and coats are left out");
        return;
    }
    if (isDiffuse) {
        out->material.crossRoughness = coat.crossRoughness;
        out->material.distribution = coat.distribution;
    }
    object->approximated(isDiffuse
                             ? "approximated: coats over diffuse surfaces are plastic that absorbs nothing"
                             : "approximated: coats over principled materials are clear ones of index 1.5");
}

void MitsubaMaterials::readBlend(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    const auto input = mitsubaInput(object, {"weight"}, SpectrumRole::Index);
    float weight = 0.5f;
    if (object->type() == "mixturebsdf") {
        const auto weights = mitsubaWords(object->text("weights", "0.5 0.5"));
        weight = weights.size() < 2
                     ? 0.0f
                     : static_cast<float>(mitsubaNumber(&context_, object->element(), weights[1]));
        if (weights.size() > 2) { object->approximated("approximated: mixtures have two materials at most"); }
    }
    std::string attribute;
    if (input && input->texture != nullptr) {
        attribute = textures_.attributeOf(*input->texture);
        if (attribute.empty()) { weight = luminance(textures_.meanOf(*input->texture)); }
    } else if (input) {
        weight = luminance(input->color);
    }
    weight = std::clamp(weight, 0.0f, 1.0f);
    const MitsubaSurface first = nested(object, origin), second = nested(object, origin);
    const auto isPlainDiffuse = [](const MitsubaSurface& surface) {
        const Material& m = surface.material;
        return m.kind == MaterialKind::Diffuse && m.color.texture < 0 && surface.attribute.empty() &&
               m.opacity == NumberInput{1.0f};
    };
    *out = weight > 0.5f ? second : first;
    out->isTwoSided = first.isTwoSided && second.isTwoSided;
    const Vec3 a = first.material.color.value, b = second.material.color.value;
    if (!isPlainDiffuse(first) || !isPlainDiffuse(second)) {
        object->approximated("approximated: of blended materials the one that weighs more is taken");
    } else if (!attribute.empty()) {
        out->attribute = attribute;
        out->low = a;
        out->high = b;
        out->material.color.value = Vec3(1.0f);
    } else {
        out->material.color.value = glm::mix(a, b, weight);
        if (input && input->texture != nullptr) {
            object->approximated("approximated: blends by a texture are by its mean");
        }
    }
}

NumberInput MitsubaMaterials::numberOf(MitsubaObject* object, std::string_view name, UvOrigin origin,
                                       float otherwise, const std::function<float(float)>& change) {
    const auto input = mitsubaInput(object, {name}, SpectrumRole::Index);
    const auto shown = [change](float value) {
        const float clamped = std::clamp(value, 0.0f, 1.0f);
        return change ? change(clamped) : clamped;
    };
    if (!input) { return {shown(otherwise)}; }
    if (input->texture == nullptr) { return {shown(numberIn(input->color))}; }
    return textures_.number(*input->texture, origin,
                            [&](const Vec3& color) { return Vec3(shown(numberIn(color))); });
}

/// Of two images the anisotropy's counts by its mean.
void MitsubaMaterials::readPrincipledRoughness(MitsubaObject* object, UvOrigin origin, Material* material) {
    const auto rough = mitsubaInput(object, {"roughness"}, SpectrumRole::Index);
    const auto anisotropic = mitsubaInput(object, {"anisotropic"}, SpectrumRole::Index);
    const bool varies = anisotropic && anisotropic->texture != nullptr;
    if (varies && (!rough || rough->texture == nullptr)) {
        const float alpha = square(rough ? std::clamp(numberIn(rough->color), 0.0f, 1.0f) : 0.5f);
        material->roughness = numberOf(object, "anisotropic", origin, 0.0f,
                                       [=](float a) { return minf(alpha / burleyAspect(a), 1.0f); });
        material->crossRoughness =
            numberOf(object, "anisotropic", origin, 0.0f, [=](float a) { return alpha * burleyAspect(a); });
        return;
    }
    const float aspect = burleyAspect(meanNumber(object, "anisotropic", 0.0f));
    material->roughness =
        numberOf(object, "roughness", origin, 0.5f, [=](float r) { return minf(r * r / aspect, 1.0f); });
    if (aspect < 1.0f) {
        material->crossRoughness =
            numberOf(object, "roughness", origin, 0.5f, [=](float r) { return r * r * aspect; });
    }
}

void MitsubaMaterials::readPrincipledLayers(MitsubaObject* object, UvOrigin origin, const Vec3& base,
                                            Material* material) {
    material->kind = MaterialKind::Principled;
    readPrincipledRoughness(object, origin, material);
    material->metallic = numberOf(object, "metallic", origin, 0.0f);
    material->clearcoat =
        numberOf(object, "clearcoat", origin, 0.0f, [](float coat) { return kBurleyCoat * coat; });
    material->clearcoatRoughness = numberOf(object, "clearcoat_gloss", origin, 0.0f, burleyCoatAlpha);
    material->specularTint.value = burleyTint(base, meanNumber(object, "spec_tint", 0.0f));
    const Vec3 sheen = kBurleySheen * burleyTint(base, meanNumber(object, "sheen_tint", 0.0f));
    const auto share = mitsubaInput(object, {"sheen"}, SpectrumRole::Reflectance);
    material->sheenColor = colorOf(share.value_or(MitsubaInput{Vec3(0.0f), nullptr}), origin,
                                   [&](const Vec3& c) { return numberIn(c) * sheen; });
    material->sheenRoughness.value = kBurleySheenAlpha;
    object->passOver({"flatness"});
}

void MitsubaMaterials::readPrincipled(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    object->approximated("approximated: the principled model's layers gain nothing");
    Material& material = out->material;
    const auto given = mitsubaInput(object, {"base_color"}, SpectrumRole::Reflectance);
    const MitsubaInput base = given.value_or(MitsubaInput{Vec3(0.5f), nullptr});
    const float passes = meanNumber(object, "spec_trans", 0.0f);
    const float specular = meanNumber(object, "specular", 0.5f);
    const float eta = meanNumber(object, "eta", 0.0f);
    const float share = 0.5f * std::clamp(meanNumber(object, "diff_trans", 0.0f), 0.0f, 2.0f);
    object->passOver({"diffuse_reflectance_sampling_rate", "specular_reflectance_sampling_rate",
                      "main_specular_sampling_rate", "clearcoat_sampling_rate"});
    const float root = std::sqrt(0.08f * std::clamp(specular, 0.0f, 10.0f));
    material.ior.value = eta > 0.0f ? std::clamp(eta, 1.0f, 100.0f) : (1.0f + root) / (1.0f - root);
    const bool isSheet = object->type() == "principledthin";
    out->isTwoSided = isSheet || passes > 0.0f;
    const bool isMetal = meanNumber(object, "metallic", 0.0f) >= 0.5f;
    if (share > 0.0f && passes < 0.5f && !isMetal) {
        material.kind = MaterialKind::Translucent;
        material.color = colorOf(base, origin, [share](const Vec3& c) { return (1.0f - share) * c; });
        material.transmission = colorOf(base, origin, [share](const Vec3& c) { return share * c; });
        object->passOver({"roughness", "anisotropic", "sheen", "sheen_tint", "spec_tint", "flatness"});
        return;
    }
    material.color = colorOf(base, origin);
    const Vec3 mean = base.texture != nullptr ? textures_.meanOf(*base.texture) : base.color;
    readPrincipledLayers(object, origin, mean, &material);
    material.specularTransmission = numberOf(object, "spec_trans", origin, 0.0f);
    material.rootTint = !isSheet && passes > 0.0f;
    if (!isSheet) { return; }
    // A sheet reflects at its boundary as much of all light as it lets pass of what enters.
    material.specular = material.specularTransmission;
    material.thin = passes > 0.0f;
    if (passes > 0.0f) {
        object->approximated("approximated: what passes thin sheets is as rough as what they reflect");
    }
}

}  // namespace glint
