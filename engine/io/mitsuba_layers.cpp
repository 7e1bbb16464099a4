// Materials of several layers or lobes, which Glint's models express in part.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/mitsuba_materials.h"
#include "engine/math/color.h"

namespace glint {
namespace {

constexpr float kAir = 1.000277f;

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

float alphaOfExponent(float exponent) { return std::clamp(std::sqrt(2.0f / (exponent + 2.0f)), 0.0f, 1.0f); }

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

void MitsubaMaterials::readPhong(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    object->approximated(
        object->type() == "ward"
            ? std::string_view("approximated: Ward's model is plastic of the same roughness")
            : std::string_view("approximated: Phong's model is plastic of a like highlight"));
    Material& material = out->material;
    material.kind = MaterialKind::Plastic;
    material.color.value = Vec3(0.5f);
    if (const auto color = mitsubaInput(object, {"diffuse_reflectance"}, SpectrumRole::Reflectance)) {
        material.color = colorOf(*color, origin);
    }
    const float specular = meanNumber(object, "specular_reflectance", 0.2f);
    const float root = std::sqrt(std::clamp(specular, 0.0f, 0.81f));
    material.ior.value = (1.0f + root) / (1.0f - root);
    if (object->type() == "ward") {
        object->passOver({"variant"});
        const float u = std::clamp(meanNumber(object, "alpha_u", 0.1f), 0.0f, 1.0f);
        material.roughness.value = std::sqrt(u * std::clamp(meanNumber(object, "alpha_v", u), 0.0f, 1.0f));
        if (const auto alpha = mitsubaInput(object, {"alpha"}, SpectrumRole::Index)) {
            material.roughness.value = std::clamp(luminance(alpha->color), 0.0f, 1.0f);
        }
    } else {
        material.roughness.value =
            alphaOfExponent(std::clamp(meanNumber(object, "exponent", 30.0f), 0.0f, 1e8f));
    }
}

void MitsubaMaterials::readCoating(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    *out = nested(object, origin);
    object->passOver({"thickness", "sigma_a", "specular_reflectance"});
    const float ior = readIndex(object, "int_ior", 1.5046f) / readIndex(object, "ext_ior", kAir);
    if (object->type() == "roughcoating") { readRoughness(object, origin, &out->material); }
    if (out->material.kind != MaterialKind::Diffuse) {
        object->approximated("approximated: coats over anything but diffuse surfaces are left out");
        return;
    }
    object->approximated("approximated: coats over diffuse surfaces are plastic that absorbs nothing");
    out->material.kind = MaterialKind::Plastic;
    out->material.ior.value = std::clamp(ior, 1.0f, 100.0f);
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

void MitsubaMaterials::readPrincipled(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    object->approximated("approximated: the principled model is a conductor, glass, plastic or a sheet");
    Material& material = out->material;
    material.color.value = Vec3(0.5f);
    const auto color = mitsubaInput(object, {"base_color"}, SpectrumRole::Reflectance);
    if (color) { material.color = colorOf(*color, origin); }
    const float metallic = meanNumber(object, "metallic", 0.0f);
    const float passes = meanNumber(object, "spec_trans", 0.0f);
    const float specular = meanNumber(object, "specular", 0.5f);
    const float eta = meanNumber(object, "eta", 0.0f);
    const float roughness = std::clamp(meanNumber(object, "roughness", 0.5f), 0.0f, 1.0f);
    const float share = 0.5f * std::clamp(meanNumber(object, "diff_trans", 0.0f), 0.0f, 2.0f);
    object->passOver({"anisotropic", "clearcoat", "clearcoat_gloss", "sheen", "sheen_tint", "spec_tint",
                      "flatness", "diffuse_reflectance_sampling_rate", "specular_reflectance_sampling_rate",
                      "main_specular_sampling_rate", "clearcoat_sampling_rate"});
    material.roughness.value = square(roughness);
    const float root = std::sqrt(0.08f * std::clamp(specular, 0.0f, 10.0f));
    material.ior.value = eta > 0.0f ? std::clamp(eta, 1.0f, 100.0f) : (1.0f + root) / (1.0f - root);
    out->isTwoSided = object->type() == "principledthin" || passes > 0.0f;
    if (passes >= 0.5f) {
        material.kind = MaterialKind::Dielectric;
        material.thin = object->type() == "principledthin";
        return;
    }
    if (share > 0.0f && metallic < 0.5f) {
        const MitsubaInput base = color.value_or(MitsubaInput{Vec3(0.5f), nullptr});
        material.kind = MaterialKind::Translucent;
        material.color = colorOf(base, origin, [share](const Vec3& c) { return (1.0f - share) * c; });
        material.transmission = colorOf(base, origin, [share](const Vec3& c) { return share * c; });
        return;
    }
    material.kind = metallic >= 0.5f ? MaterialKind::Conductor : MaterialKind::Plastic;
    material.metal.clear();
    material.eta.value = Vec3(1e-3f);  // the base colour is then the reflectance
    material.k.value = Vec3(1e4f);
}

}  // namespace glint
