// What stands for materials that no other program's files have.
#include <algorithm>
#include <cmath>

#include <glm/exponential.hpp>

#include "engine/io/clear_coat.h"
#include "engine/io/scene_export.h"
#include "engine/math/color.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

void makePlastic(Material* material) {
    constexpr float kMost = 0.81f;
    const float root = std::sqrt(std::clamp(luminance(material->specularReflectance.value), 0.0f, kMost));
    if (material->kind == MaterialKind::Phong) {
        material->roughness = {std::fmin(std::sqrt(2.0f / (material->exponent.value + 2.0f)), 1.0f)};
        material->crossRoughness = NumberInput{-1.0f};
    }
    material->kind = MaterialKind::Plastic;
    material->ior = {(1.0f + root) / (1.0f - root)};
    material->distribution = FacetDistribution::Beckmann;
}

/// What the coat absorbs is a tint.
void makePrincipled(Material* material) {
    const float ior = material->ior.value;
    const NumberInput coatRoughness = material->clearcoatRoughness;
    material->color.value *= glm::exp(-2.0f * material->coatAbsorption.value);
    material->kind = MaterialKind::Conductor;
    coatMaterial(ior, coatRoughness, material);
}

}  // namespace

void withUsualModels(SceneDescription* scene, bool hasCoatedMetals, std::vector<std::string>* warnings) {
    const std::vector<bool> used = usedMaterials(*scene);
    for (size_t i = 0; i < scene->materials.size(); ++i) {
        Material& material = scene->materials[i];
        if (material.kind == MaterialKind::Phong || material.kind == MaterialKind::Ward) {
            makePlastic(&material);
            if (used[i]) {
                warnOnce("approximated: Phong's and Ward's models are plastic of a like highlight", warnings);
            }
        } else if (material.kind == MaterialKind::Coated && !hasCoatedMetals) {
            makePrincipled(&material);
            if (used[i]) { warnOnce("approximated: coated metals are principled", warnings); }
        }
    }
}

}  // namespace glint
