// A mesh file opened as a scene: its objects with their own materials, a camera that frames them, and light.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/io/load_options.h"
#include "engine/scene/scene.h"

namespace glint {

/// Images that cannot be read are warnings. Error: as the file's reader.
Result<SceneDescription> loadMeshScene(const std::string& path, const LoadOptions& options);

}  // namespace glint
