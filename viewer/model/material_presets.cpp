#include "viewer/model/material_presets.h"

#include <utility>

#include "engine/scene/glasses.h"
#include "engine/scene/metals.h"

namespace glint {
namespace {

// GGX alphas.
constexpr float kSatin = 0.25f;
constexpr float kFrosted = 0.3f;
constexpr float kAlongGrooves = 0.12f, kAcrossGrooves = 0.4f;

struct NamedColor {
    const char* name;
    Vec3 linear;  ///< albedo, Rec.709
};

constexpr NamedColor kPlastics[] = {{"White", {0.82f, 0.82f, 0.80f}}, {"Black", {0.012f, 0.012f, 0.013f}},
                                    {"Red", {0.55f, 0.020f, 0.018f}}, {"Yellow", {0.75f, 0.46f, 0.02f}},
                                    {"Green", {0.03f, 0.28f, 0.06f}}, {"Blue", {0.015f, 0.07f, 0.46f}}};

constexpr NamedColor kPaints[] = {
    {"Wall white", {0.80f, 0.79f, 0.76f}}, {"Cream", {0.76f, 0.67f, 0.50f}},
    {"Sage", {0.34f, 0.41f, 0.30f}},       {"Terracotta", {0.46f, 0.14f, 0.065f}},
    {"Navy", {0.018f, 0.035f, 0.11f}},     {"Grey card, 18 %", {0.18f, 0.18f, 0.18f}},
    {"Charcoal", {0.035f, 0.035f, 0.038f}}};

Material ofKind(MaterialKind kind) {
    Material material;
    material.kind = kind;
    material.color.value = Vec3(1.0f);
    return material;
}

MaterialPresetGroup metals() {
    MaterialPresetGroup group{"Metals", {}};
    for (const bool isBrushed : {false, true}) {
        for (const std::string_view name : listedMetals()) {
            Material metal = ofKind(MaterialKind::Conductor);
            metal.metal = name;
            if (isBrushed) {
                metal.roughness.value = kAlongGrooves;
                metal.crossRoughness.value = kAcrossGrooves;
            }
            group.presets.push_back({std::string(name) + (isBrushed ? ", brushed" : ""), metal});
        }
    }
    return group;
}

MaterialPresetGroup glasses() {
    MaterialPresetGroup group{"Glasses", {}};
    for (const std::string_view name : glassNames()) {
        Material glass = ofKind(MaterialKind::Dielectric);
        glass.glass = name;
        glass.ior.value = findGlass(name)->ior;
        group.presets.push_back({std::string(name), glass});
    }
    Material glass = ofKind(MaterialKind::Dielectric);
    glass.roughness.value = kFrosted;
    group.presets.push_back({"Frosted", glass});
    glass.roughness.value = 0.0f;
    glass.thin = true;
    group.presets.push_back({"Window pane", glass});
    return group;
}

MaterialPresetGroup plastics() {
    MaterialPresetGroup group{"Plastics", {}};
    for (const auto& [finish, roughness] : {std::pair("glossy", 0.0f), std::pair("satin", kSatin)}) {
        for (const NamedColor& color : kPlastics) {
            Material plastic = ofKind(MaterialKind::Plastic);
            plastic.color.value = color.linear;
            plastic.roughness.value = roughness;
            group.presets.push_back({std::string(color.name) + ", " + finish, plastic});
        }
    }
    return group;
}

MaterialPresetGroup paints() {
    MaterialPresetGroup group{"Paints", {}};
    for (const NamedColor& color : kPaints) {
        Material paint = ofKind(MaterialKind::Diffuse);
        paint.color.value = color.linear;
        group.presets.push_back({color.name, paint});
    }
    return group;
}

MaterialPresetGroup layers() {
    MaterialPresetGroup group{"Layers", {}};
    for (const NamedColor& color : kPlastics) {
        Material paint = ofKind(MaterialKind::Principled);
        paint.color.value = color.linear;
        paint.metallic.value = 0.7f;
        paint.roughness.value = kSatin;
        paint.clearcoat.value = 1.0f;
        group.presets.push_back({std::string(color.name) + ", car paint", paint});
    }
    for (const NamedColor& color : kPlastics) {
        Material velvet = ofKind(MaterialKind::Principled);
        velvet.color.value = 0.4f * color.linear;
        velvet.roughness.value = 0.8f;
        velvet.specular.value = 0.2f;
        velvet.sheenColor.value = glm::sqrt(color.linear);
        velvet.sheenRoughness.value = 0.15f;
        group.presets.push_back({std::string(color.name) + ", velvet", velvet});
    }
    return group;
}

}  // namespace

std::span<const MaterialPresetGroup> materialPresets() {
    static const std::vector<MaterialPresetGroup> kGroups{metals(), glasses(), plastics(), paints(),
                                                          layers()};
    return kGroups;
}

void takeMaterial(const Material& from, Material* to) {
    std::string name = std::move(to->name);
    *to = from;
    to->name = std::move(name);
}

}  // namespace glint
