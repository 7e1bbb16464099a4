// The scene's materials as kernels read them: metals looked up, coats tabulated, texture indices packed.
// Called by the scene builder on every material edit.
#pragma once

#include <memory>
#include <vector>

#include "engine/base/result.h"
#include "engine/builders/texture_table.h"
#include "engine/kernels/shading_view.h"
#include "engine/scene/scene.h"

namespace glint {

struct MaterialTable {
    std::vector<MaterialData> materials;  ///< same indices as SceneDescription::materials

    size_t bytes() const { return materials.size() * sizeof(MaterialData); }
};

/// Whether the material gets a GGX lobe: its kind has one, its roughness is at least kSmoothAlpha, and a
/// dielectric is neither thin nor of the same index as its surroundings (within 0.001).
bool isRough(const Material& material);

/// All materials, used or not, so that indices stay; the textures of unused ones are left out. Colours and
/// roughness are clamped to [0, 1], emission to 0 and more. `previous` (may be null) is returned itself where
/// nothing changed, and lends its coat tables. Error, naming the material: a number that is not finite, an
/// index of refraction that is not positive, an unknown metal (naming the nearest), mixture weights that are
/// negative or all zero.
Result<std::shared_ptr<const MaterialTable>> buildMaterialTable(
    const SceneDescription& scene, const TextureTable& textures,
    const std::shared_ptr<const MaterialTable>& previous);

}  // namespace glint
