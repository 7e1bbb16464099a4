// What a scene needs of the kernels, as a feature mask. Called by the scene builder when kinds, textures,
// objects, transforms, the lens or the sampler change.
#pragma once

#include "engine/kernels/features.h"
#include "engine/scene/scene.h"

namespace glint {

/// The features of everything that objects use (unused materials and meshes count for nothing), of the lens
/// and of the sampler. Without the light bits, which LightTable::features() adds. Indices that are out of
/// range are passed over.
FeatureMask scanFeatures(const SceneDescription& scene);

}  // namespace glint
