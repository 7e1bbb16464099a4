// A scene's options in the form that kernels take.
#pragma once

#include "engine/kernels/pass.h"
#include "engine/kernels/sppm_view.h"
#include "engine/scene/scene.h"

namespace glint {

/// At the scene's own resolution, pass 0.
PassParams passParamsOf(const SceneDescription& scene);

/// The same for SPPM. Photons per pass are what the memory budget allows (sppm_state.h).
SppmParams sppmParamsOf(const SceneDescription& scene);

}  // namespace glint
