// The report of `glint info` for people: a line or a few for each kind of thing. JSON is made
// in info_command.
#pragma once

#include "viewer/commands/scene_report.h"

namespace glint {

/// To standard output.
void printSceneReport(const SceneDescription& scene, const SceneReport& report);

}  // namespace glint
