// Checks of lights without a shape, and of the environment. For scene_validation.
#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene.h"

namespace glint {

/// Error: numbers out of range, a missing texture or image, a portal that is no rectangle.
Status checkLight(const SceneDescription& scene, size_t index);
Status checkEnvironment(const SceneDescription& scene);

}  // namespace glint
