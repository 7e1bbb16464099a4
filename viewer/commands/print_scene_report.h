// The report of `glint info` for people: a line or a few for each kind of thing. JSON is made
// in info_command.
#pragma once

#include "engine/io/scene_choices.h"
#include "viewer/commands/scene_report.h"

namespace glint {

/// To standard output.
void printSceneReport(const SceneDescription& scene, const SceneChoices& choices, const SceneReport& report);

}  // namespace glint
