// What an edit is called, for the list of edits.
#pragma once

#include <string>

#include "engine/scene/scene.h"

namespace glint {

/// What the edit changed, in a few words: "Camera: position", "Material glass: roughness", "Light added".
std::string editName(const SceneDescription& before, const SceneDescription& after);

}  // namespace glint
