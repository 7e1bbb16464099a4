// How commands open the scene that they are given.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/io/load_options.h"
#include "engine/scene/scene.h"

namespace glint {

class Command;

/// Adds `--allow-missing`, `--strict`, `--no-studio` and `-D`. `options` must outlive the parsing.
void addLoadOptions(const Command& command, LoadOptions* options);

/// loadScene(), with what it had to guess and decided in the log.
Result<SceneDescription> openScene(const std::string& path, const LoadOptions& options);

}  // namespace glint
