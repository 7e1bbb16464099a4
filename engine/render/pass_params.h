// A scene's options in the form that kernels take.
#pragma once

#include "engine/kernels/pass.h"
#include "engine/scene/scene.h"

namespace glint {

/// At the scene's own resolution, pass 0.
PassParams passParamsOf(const SceneDescription& scene);

}  // namespace glint
