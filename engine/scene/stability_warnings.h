// What of a scene lies beyond float's reach, in words for the log: the limits that `glint stress` measures.
//
// Only warns: such scenes render, but not well.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.h"

namespace glint {

/// One sentence for each limit that the scene passes, with the number that passes it; empty for nearly every
/// scene. Visits every vertex once.
std::vector<std::string> stabilityWarnings(const SceneDescription& scene);

}  // namespace glint
