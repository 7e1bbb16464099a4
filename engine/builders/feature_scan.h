// What a scene needs of the kernels, as a feature mask.
#pragma once

#include "engine/kernels/features.h"
#include "engine/scene/scene.h"

namespace glint {

struct MaterialTable;

/// The features of everything that objects use (unused materials and meshes count for nothing) and of the
/// lens. `materials` were made from the scene. Without the light bits, which LightTable::features() adds,
/// and the sampler's, which is no scene's (render/variant_choice.h). Indices that are out of range are
/// passed over.
FeatureMask scanFeatures(const SceneDescription& scene, const MaterialTable& materials);

}  // namespace glint
