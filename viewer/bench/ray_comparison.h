// Where Glint and Embree answer differently: is it rounding, and of which kind?
#pragma once

#include <optional>

#include "engine/kernels/scene_view.h"
#include "viewer/bench/bench_rays.h"
#include "viewer/bench/embree_oracle.h"

namespace glint {

/// Nothing when the two agree: the same triangle at the same distance within rounding, or both missed. `view`
/// holds one mesh under the identity. Answers of occlusion rays (anyHit) have primitive kNone for "free".
/// Every difference is checked in double precision against the triangles concerned.
std::optional<RayDisagreement> compareHits(const SceneView& view, const EmbreeOracle& embree, const Ray& ray,
                                           bool anyHit, const Hit& glintHit, const Hit& embreeHit);

}  // namespace glint
