// Projectors of foreign scenes: how they stand, and what stands for them where a format has none.
#pragma once

#include <string>

#include "engine/math/transform.h"
#include "engine/scene/scene.h"

namespace glint {

/// Places a projector whose picture has `right` to its right, the local +y upwards, and +z as its axis. A map
/// that mirrors the picture mirrors its texture. False: the map flattens it.
bool aimProjector(const Affine& toWorld, const Vec3& right, Light* light, SceneDescription* scene);

/// Half the picture's width and height, on the plane at a distance of 1.
Vec2 projectedExtent(const Light& projector);

/// A spot of the same power and mean colour, in a circle of the picture's area.
Light spotOfProjector(const SceneDescription& scene, const Light& projector);

}  // namespace glint
