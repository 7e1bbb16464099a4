#include "engine/io/clear_coat.h"

#include "engine/scene/metals.h"

namespace glint {
namespace {

/// Whether one colour cannot say what the metal reflects.
bool hasReflectanceOfTextures(const Material& metal) {
    constexpr float kWhite = 0.95f;
    return metal.eta.texture >= 0 || metal.k.texture >= 0 ||
           (metal.color.texture >= 0 && minComponent(reflectanceHeadOn(metal)) < kWhite);
}

/// A metal of the same reflectance head on.
void makePrincipled(Material* material) {
    if (material->kind == MaterialKind::Conductor) { material->color.value *= reflectanceHeadOn(*material); }
    if (material->kind == MaterialKind::Mirror) { material->roughness = {}; }
    material->kind = MaterialKind::Principled;
    material->metallic = {1.0f};
    material->ior = {1.5f};
}

}  // namespace

void coatMetal(float ior, const NumberInput& alpha, Material* metal) {
    if (metal->kind == MaterialKind::Mirror) {
        metal->metal.clear();
        metal->eta = {Vec3(1e-3f)};
        metal->k = {Vec3(1e4f)};  // reflects all but 4e-11
        metal->roughness = {};
        metal->crossRoughness = NumberInput{-1.0f};
    }
    metal->kind = MaterialKind::Coated;
    metal->ior = {ior};
    metal->clearcoatRoughness = alpha;
}

bool coatMaterial(float ior, const NumberInput& alpha, Material* material) {
    switch (material->kind) {
        case MaterialKind::Diffuse:
            material->kind = MaterialKind::Plastic;
            material->ior = {ior};
            material->roughness = alpha;
            return true;
        case MaterialKind::Conductor:
            if (hasReflectanceOfTextures(*material)) { return false; }
            [[fallthrough]];
        case MaterialKind::Mirror:
        case MaterialKind::Principled: {
            const float root = (ior - 1.0f) / (ior + 1.0f);
            if (material->kind != MaterialKind::Principled) { makePrincipled(material); }
            material->clearcoat = {minf(root * root / 0.04f, 1.0f)};
            material->clearcoatRoughness = alpha;
            return true;
        }
        case MaterialKind::Dielectric:
        case MaterialKind::Plastic:
        case MaterialKind::Mixture:
        case MaterialKind::Translucent:
        case MaterialKind::Coated:
        case MaterialKind::Phong:
        case MaterialKind::Ward:
            break;
    }
    return false;
}

}  // namespace glint
