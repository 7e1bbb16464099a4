// The scene's camera made ready for rays.
#pragma once

#include "engine/base/result.h"
#include "engine/kernels/shading_view.h"
#include "engine/scene/camera.h"

namespace glint {

/// `aspect` is the picture's width over its height. Error: no view direction (position and target
/// coincide), a number that is not finite, a field of view outside (0, 180) degrees, a negative aperture, 1
/// or 2 blades, a height of view, a focal distance or a horizontal scale that is not positive.
Result<CameraData> buildCamera(const Camera& camera, float aspect);

}  // namespace glint
