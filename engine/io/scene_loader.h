// Opens a scene file of any known kind. The only entry the commands and the window use.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/io/load_options.h"
#include "engine/scene/scene.h"

namespace glint {

/// Reads any kind of file that an importer (importer.h) knows, told by its extension and its first bytes.
/// Scenes without a camera get the default view. Never throws or crashes on any content. Error: one clear
/// message, with line and column where the file is text.
Result<SceneDescription> loadScene(const std::string& path, const LoadOptions& options = {});

}  // namespace glint
