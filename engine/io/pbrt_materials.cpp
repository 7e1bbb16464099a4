#include "engine/io/pbrt_materials.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/math/color.h"
#include "engine/scene/metals.h"

namespace glint {
namespace {

constexpr std::string_view kReliefShading =
    "approximated: where bumps and normal maps lean away from the light, shading ends as Glint has it";

}  // namespace

struct PbrtMaterials::Kind {
    std::string_view name;
    Read read;
};

int PbrtMaterials::define(const std::string& kind, PbrtParams params) {
    definitions_.push_back({kind.empty() ? "interface" : kind, kind, std::move(params)});
    return static_cast<int>(definitions_.size()) - 1;
}

void PbrtMaterials::defineNamed(const std::string& name, PbrtParams params) {
    const std::string kind = params.text("type");
    if (kind.empty()) { params.fail(fmt::format("the material \"{}\" has no \"type\"", name)); }
    const auto known = named_.find(name);
    if (known != named_.end() && definitions_[static_cast<size_t>(known->second)].kind.empty()) {
        definitions_[static_cast<size_t>(known->second)] = {kind, name, std::move(params)};
    } else {
        named_[name] = define(kind, std::move(params));
        definitions_.back().name = name;
    }
}

int PbrtMaterials::numberOf(const std::string& name, const PbrtPlace& at) {
    const auto [known, isNew] = named_.try_emplace(name, static_cast<int>(definitions_.size()));
    if (isNew) { definitions_.push_back({"", name, PbrtParams(&context_, at, PbrtColorSpace::Srgb)}); }
    return known->second;
}

const PbrtSurface& PbrtMaterials::surfaceOf(int number) {
    if (number < 0) {
        if (!usual_) {
            usual_.emplace();
            usual_->material.name = "default";
            usual_->material.alphaCutsOut = false;
        }
        return *usual_;
    }
    Definition& definition = definitions_[static_cast<size_t>(number)];
    if (!definition.surface && definition.isOpen) {
        definition.params.fail("materials refer to each other in a circle");
        return surfaceOf(-1);
    }
    if (!definition.surface) {
        constexpr int kMaxNesting = 64;
        if (++nesting_ > kMaxNesting) {
            definition.params.fail("materials refer to each other more than 64 deep");
        }
        definition.isOpen = true;
        PbrtSurface surface = context_.failed() ? PbrtSurface() : read(definition);
        definition.isOpen = false;
        --nesting_;
        surface.material.name = definition.name.empty() ? definition.kind : definition.name;
        surface.material.alphaCutsOut = false;
        definition.surface = std::move(surface);
    }
    return *definition.surface;
}

int PbrtMaterials::take(int number, const PbrtValue& share, const PbrtEmission& emission,
                        const Vec3& absorption) {
    const PbrtSurface& surface = surfaceOf(number);
    PbrtValue both = surface.share;
    if (!share.image) {
        both = PbrtTextures::adjusted(std::move(both), 0.0f, std::clamp(share.value.x, 0.0f, 1.0f), 1.0f);
    } else {
        both = both.image ? share : PbrtTextures::adjusted(share, 0.0f, both.value.x, 1.0f);
    }
    NumberInput opacity = textures_.numberInput(both);
    opacity.value = std::clamp(opacity.value, 0.0f, 1.0f);
    const Vec3& light = emission.color.value;
    const Key key{number,
                  opacity.value,
                  opacity.texture,
                  {light.x, light.y, light.z, absorption.x, absorption.y, absorption.z},
                  emission.color.texture,
                  emission.strength,
                  emission.isTwoSided};
    const auto [known, isNew] = taken_.try_emplace(key, static_cast<int>(context_.scene.materials.size()));
    if (isNew) {
        Material material = surface.material;
        material.opacity = opacity;
        material.emission = emission.color;
        material.emissionStrength = emission.strength;
        material.emitsBothSides = emission.isTwoSided;
        if (!surface.isThere) { material.color.value = Vec3(0.0f); }
        if (const float most = maxComponent(absorption); most > 0.0f) {
            material.attenuationDistance = 1.0f / most;
            material.attenuationColor = glm::exp(-absorption / most);
        }
        context_.scene.materials.push_back(std::move(material));
    }
    return known->second;
}

PbrtSurface PbrtMaterials::read(const Definition& definition) {
    static constexpr Kind kKinds[] = {{"diffuse", &PbrtMaterials::readDiffuse},
                                      {"coateddiffuse", &PbrtMaterials::readCoatedDiffuse},
                                      {"conductor", &PbrtMaterials::readConductor},
                                      {"coatedconductor", &PbrtMaterials::readCoatedConductor},
                                      {"dielectric", &PbrtMaterials::readDielectric},
                                      {"thindielectric", &PbrtMaterials::readThinDielectric},
                                      {"diffusetransmission", &PbrtMaterials::readTransmission},
                                      {"mix", &PbrtMaterials::readMix},
                                      {"interface", &PbrtMaterials::readInterface},
                                      {"none", &PbrtMaterials::readInterface},
                                      {"measured", &PbrtMaterials::readMeasured},
                                      {"hair", &PbrtMaterials::readHair},
                                      {"subsurface", &PbrtMaterials::readSubsurface},
                                      {"matte", &PbrtMaterials::readDiffuse},
                                      {"mirror", &PbrtMaterials::readMirror},
                                      {"metal", &PbrtMaterials::readConductor},
                                      {"glass", &PbrtMaterials::readDielectric},
                                      {"plastic", &PbrtMaterials::readOldCoated},
                                      {"substrate", &PbrtMaterials::readOldCoated},
                                      {"uber", &PbrtMaterials::readOldCoated},
                                      {"disney", &PbrtMaterials::readDisney},
                                      {"translucent", &PbrtMaterials::readTransmission},
                                      {"kdsubsurface", &PbrtMaterials::readSubsurface}};
    PbrtSurface out;
    if (definition.kind.empty()) {
        context_.refuse(definition.params.place(),
                        fmt::format("there is no material \"{}\"", definition.name));
        return out;
    }
    const auto kind = std::ranges::find(kKinds, definition.kind, &Kind::name);
    if (kind == std::end(kKinds)) {
        context_.refuse(definition.params.place(),
                        fmt::format("Glint has no material \"{}\"", definition.kind));
        return out;
    }
    (this->*kind->read)(definition.params, &out);
    readRelief(definition.params, &out.material);
    definition.params.passOver({"type"});
    definition.params.finish();
    return out;
}

void PbrtMaterials::readRelief(const PbrtParams& params, Material* material) {
    auto heights = textures_.number(params, "displacement");
    if (!heights) { heights = textures_.number(params, "bumpmap"); }
    if (heights && heights->image) {
        material->bump = textures_.numberInput(*heights);
        material->bumpHeight = 1.0f;
    }
    const bool hasNormals = params.has("normalmap");
    if (hasNormals) {
        material->normalMap =
            textures_.colorInput(textures_.imageFile(params, "normalmap", ColorEncoding::Linear));
        material->normalMap.value = kNoTilt;
    }
    if (hasNormals || (heights && heights->image)) { params.approximated(kReliefShading); }
}

ColorInput PbrtMaterials::reflectance(const PbrtParams& params, std::initializer_list<std::string_view> names,
                                      float otherwise) {
    for (const std::string_view name : names) {
        if (const auto color = textures_.color(params, name, SpectrumRole::Reflectance)) {
            return textures_.colorInput(*color);
        }
    }
    return {Vec3(otherwise)};
}

float PbrtMaterials::meanNumber(const PbrtParams& params, std::string_view name, float otherwise) {
    const auto value = textures_.number(params, name);
    return value ? luminance(textures_.meanOf(*value)) : otherwise;
}

/// pbrt-v4 takes the root of a roughness for GGX's alpha unless it is told not to.
void PbrtMaterials::readRoughness(const PbrtParams& params, const std::string& prefix, float otherwise,
                                  Material* material) {
    const float exponent = params.flag("remaproughness", true) ? 0.5f : 1.0f;
    const PbrtValue both =
        textures_.number(params, prefix + "roughness").value_or(PbrtValue{Vec3(otherwise)});
    const auto u = textures_.number(params, prefix + "uroughness");
    const auto v = textures_.number(params, prefix + "vroughness");
    const auto alphaOf = [&](const PbrtValue& value) {
        NumberInput alpha = textures_.numberInput(PbrtTextures::adjusted(value, 0.0f, 1.0f, exponent));
        alpha.value = std::clamp(alpha.value, 0.0f, 1.0f);
        return alpha;
    };
    material->roughness = alphaOf(u.value_or(both));
    if (!u && !v) { return; }
    const NumberInput across = alphaOf(v.value_or(both));
    if (across != material->roughness) { material->crossRoughness = across; }
}

void PbrtMaterials::readDiffuse(const PbrtParams& params, PbrtSurface* out) {
    out->material.color = reflectance(params, {"reflectance", "Kd"}, 0.5f);
    if (meanNumber(params, "sigma", 0.0f) > 0.0f) {
        params.approximated("approximated: rough diffuse surfaces are Lambert's");
    }
}

void PbrtMaterials::readMetal(const PbrtParams& params, const std::string& prefix, float index,
                              Material* material) {
    const PbrtParam *eta = params.find(prefix + "eta"), *k = params.find(prefix + "k");
    const auto nameOf = [](const PbrtParam* param) {
        if (param == nullptr) { return std::string_view("copper"); }
        return param->type == PbrtType::Spectrum && !param->texts.empty() ? pbrtMetal(param->texts[0])
                                                                          : std::string_view();
    };
    material->metal = nameOf(eta) == nameOf(k) ? nameOf(eta) : std::string_view();
    if (const auto known = findMetal(material->metal)) {
        if (index == 1.0f) { return; }
        material->eta = {known->eta / index};
        material->k = {known->k / index};
        material->metal.clear();
        return;
    }
    const auto colorOf = [&](const std::string& name) {
        const auto color = textures_.color(params, prefix + name, SpectrumRole::Index);
        PbrtValue value = color.value_or(PbrtValue{Vec3(name == "eta" ? 0.2f : 3.9f)});
        if (index == 1.0f) { return textures_.colorInput(value); }
        if (value.image) {
            return textures_.colorInput(PbrtTextures::adjusted(std::move(value), 0.0f, 1.0f / index, 1.0f));
        }
        return ColorInput{value.value / index};
    };
    material->eta = colorOf("eta");
    material->k = colorOf("k");
}

void PbrtMaterials::readConductor(const PbrtParams& params, PbrtSurface* out) {
    Material& material = out->material;
    material.kind = MaterialKind::Conductor;
    material.color.value = Vec3(1.0f);
    readRoughness(params, "", 0.0f, &material);
    const auto color = textures_.color(params, "reflectance", SpectrumRole::Reflectance);
    if (!color) {
        readMetal(params, "", 1.0f, &material);
        return;
    }
    material.metal.clear();
    if (color->image) {
        params.approximated("approximated: metals that reflect a picture do so alike at all angles");
        material.eta.value = Vec3(1e-3f);
        material.k.value = Vec3(1e4f);
        material.color = textures_.colorInput(*color);
        return;
    }
    const Vec3 r = glm::min(color->value, Vec3(0.9999f));  // at right angles, of eta 1
    material.eta.value = Vec3(1.0f);
    material.k.value = 2.0f * glm::sqrt(r / (Vec3(1.0f) - r));
}

void PbrtMaterials::readDielectric(const PbrtParams& params, PbrtSurface* out) {
    Material& material = out->material;
    material.kind = MaterialKind::Dielectric;
    material.color = reflectance(params, {"Kt", "Kr"}, 1.0f);
    readRoughness(params, "", 0.0f, &material);
    const PbrtParam* eta = params.find(params.has("eta") ? "eta" : "index");
    if (eta == nullptr) {
        material.ior.value = 1.5f;
    } else if (eta->type == PbrtType::Spectrum && !eta->texts.empty() && !pbrtGlass(eta->texts[0]).empty()) {
        material.glass = pbrtGlass(eta->texts[0]);
    } else if (eta->type == PbrtType::Texture) {
        material.ior.value = meanNumber(params, eta->name, 1.5f);
    } else {
        const Vec3 index = pbrtColor(params, *eta, SpectrumRole::Index);
        const bool isGrey = index.x == index.y && index.y == index.z;
        material.ior.value = isGrey ? index.x : luminance(index);
        material.iorRgb = isGrey ? Vec3(0.0f) : index;
    }
    material.ior.value = std::clamp(material.ior.value, 0.01f, 100.0f);
}

void PbrtMaterials::readThinDielectric(const PbrtParams& params, PbrtSurface* out) {
    readDielectric(params, out);
    out->material.thin = true;
    out->material.roughness = {};
    out->material.crossRoughness = NumberInput{-1.0f};
}

void PbrtMaterials::readInterface(const PbrtParams&, PbrtSurface* out) { out->isThere = false; }

void PbrtMaterials::readMirror(const PbrtParams& params, PbrtSurface* out) {
    out->material.kind = MaterialKind::Mirror;
    out->material.color = reflectance(params, {"Kr"}, 0.9f);
}

}  // namespace glint
