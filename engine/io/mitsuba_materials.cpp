#include "engine/io/mitsuba_materials.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/math/color.h"

namespace glint {
namespace {

constexpr float kBk7 = 1.5046f;
constexpr std::string_view kReliefShading =
    "approximated: where bumps and normal maps lean away from the light, shading ends as Glint has it";

}  // namespace

struct MitsubaMaterials::Kind {
    std::string_view name;
    Read read;
};

const MitsubaSurface& MitsubaMaterials::surfaceOf(const MitsubaElement* bsdf, UvOrigin origin) {
    const Key key{bsdf, origin};
    if (const auto found = surfaces_.find(key); found != surfaces_.end()) { return found->second; }
    MitsubaSurface surface;
    if (bsdf != nullptr) {
        surface = read(*bsdf, origin);
        const std::string_view id = bsdf->attribute("id");
        surface.material.name = id.empty() ? bsdf->attribute("type") : id;
    } else {
        surface.material.name = "default";
    }
    surface.material.alphaCutsOut = false;
    return surfaces_.emplace(key, std::move(surface)).first->second;
}

int MitsubaMaterials::take(const MitsubaElement* bsdf, UvOrigin origin) {
    const Key key{bsdf, origin};
    if (const auto found = numbers_.find(key); found != numbers_.end()) { return found->second; }
    return numbers_[key] = add(surfaceOf(bsdf, origin), {Vec3(0.0f)}, false);
}

int MitsubaMaterials::add(const MitsubaSurface& surface, const ColorInput& emission, bool bothSides) {
    Material material = surface.material;
    material.emission = emission;
    material.emitsBothSides = bothSides;
    context_.scene.materials.push_back(std::move(material));
    return static_cast<int>(context_.scene.materials.size()) - 1;
}

int MitsubaMaterials::black(const MitsubaSurface& surface) {
    const NumberInput& opacity = surface.material.opacity;
    const auto [known, isNew] = blacks_.try_emplace({opacity.value, opacity.texture}, 0);
    if (isNew) {
        MitsubaSurface back;
        back.material.name = "black";
        back.material.color.value = Vec3(0.0f);
        back.material.opacity = opacity;
        known->second = add(back, {Vec3(0.0f)}, false);
    }
    return known->second;
}

MitsubaSurface MitsubaMaterials::read(const MitsubaElement& bsdf, UvOrigin origin) {
    static constexpr Kind kKinds[] = {{"diffuse", &MitsubaMaterials::readDiffuse},
                                      {"lambertian", &MitsubaMaterials::readDiffuse},
                                      {"roughdiffuse", &MitsubaMaterials::readDiffuse},
                                      {"difftrans", &MitsubaMaterials::readTransmitter},
                                      {"dielectric", &MitsubaMaterials::readDielectric},
                                      {"thindielectric", &MitsubaMaterials::readDielectric},
                                      {"roughdielectric", &MitsubaMaterials::readDielectric},
                                      {"conductor", &MitsubaMaterials::readConductor},
                                      {"roughconductor", &MitsubaMaterials::readConductor},
                                      {"plastic", &MitsubaMaterials::readPlastic},
                                      {"roughplastic", &MitsubaMaterials::readPlastic},
                                      {"phong", &MitsubaMaterials::readPhong},
                                      {"ward", &MitsubaMaterials::readWard},
                                      {"coating", &MitsubaMaterials::readCoating},
                                      {"roughcoating", &MitsubaMaterials::readCoating},
                                      {"mask", &MitsubaMaterials::readMask},
                                      {"twosided", &MitsubaMaterials::readTwoSided},
                                      {"bumpmap", &MitsubaMaterials::readBump},
                                      {"bump", &MitsubaMaterials::readBump},
                                      {"normalmap", &MitsubaMaterials::readNormalMap},
                                      {"blendbsdf", &MitsubaMaterials::readBlend},
                                      {"mixturebsdf", &MitsubaMaterials::readBlend},
                                      {"null", &MitsubaMaterials::readNull},
                                      {"principled", &MitsubaMaterials::readPrincipled},
                                      {"principledthin", &MitsubaMaterials::readPrincipled}};
    MitsubaSurface out;
    MitsubaObject object(&context_, bsdf);
    if (context_.failed()) { return out; }
    const auto kind = std::ranges::find(kKinds, object.type(), &Kind::name);
    if (kind == std::end(kKinds)) {
        context_.refuse(bsdf, fmt::format("Glint has no bsdf \"{}\"", object.type()));
        return out;
    }
    (this->*kind->read)(&object, origin, &out);
    object.finish();
    return out;
}

MitsubaSurface MitsubaMaterials::nested(MitsubaObject* object, UvOrigin origin) {
    const MitsubaElement* bsdf = object->next({"bsdf"});
    if (bsdf == nullptr) {
        context_.fail(object->element(), fmt::format("the \"{}\" holds no bsdf", object->type()));
        return {};
    }
    return surfaceOf(bsdf, origin);
}

ColorInput MitsubaMaterials::colorOf(const MitsubaInput& input, UvOrigin origin,
                                     const MitsubaTextures::Change& change) {
    if (input.texture != nullptr) { return textures_.color(*input.texture, origin, change); }
    return {change ? change(input.color) : input.color};
}

float MitsubaMaterials::meanNumber(MitsubaObject* object, std::string_view name, float otherwise) {
    const auto input = mitsubaInput(object, {name}, SpectrumRole::Index);
    if (!input) { return otherwise; }
    return luminance(input->texture != nullptr ? textures_.meanOf(*input->texture) : input->color);
}

float MitsubaMaterials::readIndex(MitsubaObject* object, std::string_view name, float otherwise) {
    const MitsubaElement* at = object->property(name);
    if (at == nullptr) { return otherwise; }
    if (at->tag != "string") {
        return std::clamp(luminance(mitsubaColor(&context_, *at, SpectrumRole::Index)), 0.01f, 100.0f);
    }
    const auto index = mitsubaIndex(at->attribute("value"));
    if (!index) { context_.fail(*at, fmt::format("no index of \"{}\" is known", at->attribute("value"))); }
    return index.value_or(otherwise);
}

void MitsubaMaterials::readRoughness(MitsubaObject* object, UvOrigin origin, Material* material) {
    const std::string_view distribution = object->text("distribution", "beckmann");
    const bool isGgx = distribution == "ggx";
    material->distribution = isGgx ? FacetDistribution::Ggx : FacetDistribution::Beckmann;
    if (!isGgx && distribution != "beckmann") {
        object->approximated("approximated: facets of Phong's distribution are Beckmann's of the same alpha");
    }
    const auto u = mitsubaInput(object, {"alpha", "alpha_u"}, SpectrumRole::Index);
    const auto v = mitsubaInput(object, {"alpha_v"}, SpectrumRole::Index);
    object->passOver({"sample_visible"});
    const auto inputOf = [&](const MitsubaInput& input) {
        return input.texture != nullptr ? textures_.number(*input.texture, origin)
                                        : NumberInput{std::clamp(luminance(input.color), 0.0f, 1.0f)};
    };
    material->roughness = u ? inputOf(*u) : NumberInput{0.1f};
    const bool isAlike = !v || (u && v->texture == nullptr && u->texture == nullptr && v->color == u->color);
    if (!isAlike) { material->crossRoughness = inputOf(*v); }
}

void MitsubaMaterials::readTints(MitsubaObject* object, UvOrigin origin, std::string_view reflected,
                                 std::string_view passed, Material* material) {
    const auto first = mitsubaInput(object, {reflected}, SpectrumRole::Reflectance);
    const auto second = mitsubaInput(object, {passed}, SpectrumRole::Reflectance);
    const MitsubaInput white{Vec3(1.0f), nullptr};
    const MitsubaInput a = first.value_or(white), b = second.value_or(white);
    material->color = colorOf(second ? b : a, origin);
    if (a.texture != b.texture || a.color != b.color) {
        object->approximated("approximated: what glass reflects is tinted as what it lets through");
    }
}

void MitsubaMaterials::readDiffuse(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    const auto color =
        mitsubaInput(object, {"reflectance", "diffuse_reflectance"}, SpectrumRole::Reflectance);
    if (object->type() == "roughdiffuse") {
        if (meanNumber(object, "alpha", 0.2f) > 0.0f) {
            object->approximated("approximated: rough diffuse surfaces are Lambert's");
        }
        object->passOver({"use_fast_approx"});
    }
    if (!color) { return; }
    if (color->texture != nullptr) { out->attribute = textures_.attributeOf(*color->texture); }
    if (out->attribute.empty()) {
        out->material.color = colorOf(*color, origin);
    } else {
        out->material.color.value = Vec3(1.0f);
    }
}

void MitsubaMaterials::readTransmitter(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    Material& material = out->material;
    material.kind = MaterialKind::Translucent;
    material.color.value = Vec3(0.0f);
    material.transmission.value = Vec3(0.5f);
    if (const auto color = mitsubaInput(object, {"transmittance"}, SpectrumRole::Reflectance)) {
        material.transmission = colorOf(*color, origin);
    }
    out->isTwoSided = true;
}

void MitsubaMaterials::readDielectric(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    Material& material = out->material;
    material.kind = MaterialKind::Dielectric;
    material.ior.value = readIndex(object, "int_ior", kBk7) / readIndex(object, "ext_ior", kAir);
    material.thin = object->type() == "thindielectric";
    readTints(object, origin, "specular_reflectance", "specular_transmittance", &material);
    if (object->type() == "roughdielectric") { readRoughness(object, origin, &material); }
    out->isTwoSided = true;
}

void MitsubaMaterials::readConductor(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    Material& material = out->material;
    material.kind = MaterialKind::Conductor;
    material.metal.clear();
    const float outside = context_.xml.majorVersion() < 2 ? readIndex(object, "ext_eta", kAir) : 1.0f;
    const auto eta = mitsubaInput(object, {"eta"}, SpectrumRole::Index);
    const auto k = mitsubaInput(object, {"k"}, SpectrumRole::Index);
    const bool isOld = context_.xml.majorVersion() < 2;
    const std::string_view name = object->text("material", isOld && !eta ? "Cu" : "none");
    MitsubaMetal metal{Vec3(1e-3f), Vec3(1e4f)};  // reflects all but 4e-11
    if (const auto known = mitsubaMetal(name)) {
        metal = *known;
    } else if (name != "none") {
        context_.refuse(object->element(), fmt::format("Glint has no constants of the metal \"{}\"", name));
    }
    const auto constant = [&](const std::optional<MitsubaInput>& input, const Vec3& otherwise) {
        if (!input) { return ColorInput{otherwise / outside}; }
        ColorInput color = colorOf(*input, origin);
        color.value = glm::max(color.value / outside, Vec3(1e-4f));
        return color;
    };
    material.eta = constant(eta, eta || k ? Vec3(1e-4f) : metal.eta);
    material.k = constant(k, eta || k ? Vec3(1.0f) : metal.k);
    material.color.value = Vec3(1.0f);
    if (const auto tint = mitsubaInput(object, {"specular_reflectance"}, SpectrumRole::Reflectance)) {
        material.color = colorOf(*tint, origin);
    }
    if (object->type() == "roughconductor") {
        readRoughness(object, origin, &material);
    } else if (name == "none" && !eta && !k) {
        material.kind = MaterialKind::Mirror;
    }
}

void MitsubaMaterials::readMask(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    const auto opacity = mitsubaInput(object, {"opacity"}, SpectrumRole::Reflectance);
    *out = nested(object, origin);
    const MitsubaInput half{Vec3(0.5f), nullptr};
    const MitsubaInput& share = opacity ? *opacity : half;
    out->material.opacity = share.texture != nullptr ? textures_.number(*share.texture, origin)
                                                     : NumberInput{luminance(share.color)};
}

void MitsubaMaterials::readTwoSided(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    *out = nested(object, origin);
    out->isTwoSided = true;
    out->back = object->next({"bsdf"});
}

void MitsubaMaterials::readBump(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    const float scale = object->number("scale", 1.0f);
    const MitsubaElement* heights = object->next({"texture"});
    *out = nested(object, origin);
    if (heights == nullptr) {
        context_.fail(object->element(), "the bump map has no texture");
        return;
    }
    object->approximated(kReliefShading);
    out->material.bump = textures_.number(*heights, origin);
    out->material.bumpHeight = scale;
}

void MitsubaMaterials::readNormalMap(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    const MitsubaElement* normals = object->next({"texture"});
    object->passOver({"use_shadowing_function", "flip_invalid_normals"});
    *out = nested(object, origin);
    if (normals == nullptr) {
        context_.fail(object->element(), "the normal map has no texture");
        return;
    }
    object->approximated(kReliefShading);
    // Mitsuba's y runs along the cross product of the normal and u, whichever way v does.
    const auto turned = [](const Vec3& c) { return Vec3(c.x, 1.0f - c.y, c.z); };
    out->material.normalMap =
        textures_.color(*normals, origin, origin == UvOrigin::Top ? turned : MitsubaTextures::Change());
}

void MitsubaMaterials::readNull(MitsubaObject*, UvOrigin, MitsubaSurface* out) { out->isThere = false; }

}  // namespace glint
