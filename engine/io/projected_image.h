// Lights with pictures in foreign scenes: how they stand, and what stands for them where a format has none.
#pragma once

#include <string_view>

#include "engine/math/transform.h"
#include "engine/scene/scene.h"

namespace glint {

/// Places a light whose picture has `right` to its right, the local +y upwards, and +z as its axis. A map
/// that mirrors the picture mirrors its texture. False: the map flattens it.
bool aimProjector(const Affine& toWorld, const Vec3& right, Light* light, SceneDescription* scene);

/// Half the picture's width and height, on the plane at a distance of 1.
Vec2 projectedExtent(const Light& projector);

/// Width over height; 1 for what has no pixels.
float aspectOf(const SceneImage& image);

/// A spot of the same power and mean colour as a projector, in a circle of its picture's area; a point of the
/// same power and mean colour as a goniometric light.
Light withoutImage(const SceneDescription& scene, const Light& light);
/// What withoutImage() does, for exporters to say.
std::string_view lostImage(LightKind kind);

}  // namespace glint
