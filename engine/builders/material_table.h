// The scene's materials as kernels read them: metals and glasses looked up, coats tabulated, texture
// indices packed.
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
    std::vector<CoatRow> coats;           ///< of plastics whose coat varies with a texture

    std::vector<SpectrumStratum> spectrum;  ///< empty where nothing disperses light

    size_t bytes() const {
        return materials.size() * sizeof(MaterialData) + coats.size() * sizeof(CoatRow) +
               spectrum.size() * sizeof(SpectrumStratum);
    }
};

/// All materials, used or not, so that indices stay; the textures of unused ones are left out. Colours are
/// clamped to [0, 1], emission to 0 and more, other inputs to their limits (math/material_inputs.h).
/// `previous` (may be null) is returned itself where nothing changed, and lends its coat tables. Error,
/// naming the material: a number that is not finite or below its limit, an unknown metal or
/// glass (naming the nearest), a coat's index of refraction below 1, mixture weights that are all zero.
Result<std::shared_ptr<const MaterialTable>> buildMaterialTable(
    const SceneDescription& scene, const TextureTable& textures,
    const std::shared_ptr<const MaterialTable>& previous);

}  // namespace glint
