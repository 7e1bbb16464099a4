// Cameras for pictures that are played one after the other: around the target, and from view to view.
#pragma once

#include <span>

#include "engine/scene/camera.h"

namespace glint {

/// After so many turns around the target, about the axis through it along `up`. Counterclockwise seen
/// from above.
Camera turnedCamera(const Camera& camera, float turns);

/// On a smooth curve through `views`, of which there is one at least: at whole numbers of `along`, in [0,
/// size - 1], the views themselves (Catmull and Rom 1974). Number and turn of the blades are those of the
/// nearer view.
Camera cameraBetween(std::span<const Camera> views, float along);

}  // namespace glint
