// Light that a surface sends out itself.
#pragma once

#include "engine/kernels/scene_view.h"
#include "engine/kernels/surface.h"

namespace glint {

/// Radiance that leaves `surface` towards the unit direction woWorld; 0 from the back of a one-sided emitter.
template <FeatureMask kMask>
GLINT_HD inline Vec3 emittedRadiance(const SceneView& view, const SurfacePoint& surface,
                                     const Vec3& woWorld) {
    const MaterialData& material = view.materials[surface.material];
    if ((material.flags & kMaterialEmissive) == 0) { return Vec3(0.0f); }
    const bool seen = (material.flags & kMaterialEmitsBothSides) != 0 || glm::dot(woWorld, surface.ng) > 0.0f;
    return seen ? material.emission : Vec3(0.0f);
}

}  // namespace glint
