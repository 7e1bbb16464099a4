// Glint's own scene format: JSON with comments, described for people in scenes/README.md and for editors
// in scenes/glint.schema.json.
//
// Reading a saved scene gives back every field that affects the picture, bit for bit.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/io/embedded_files.h"
#include "engine/io/load_options.h"
#include "engine/io/text_source.h"
#include "engine/scene/scene.h"

namespace glint {

/// Error: anything that is not a valid scene, with its place. Relative paths count from the folder
/// of source.path; those of `embedded` stand for files in memory.
Result<SceneDescription> readSceneJson(TextSource source, const LoadOptions& options,
                                       const EmbeddedByPath& embedded = {});

/// The scene as JSON text, for a file at `path`: relative paths are rewritten to count from its folder.
/// Error: an image that is neither from a file nor generated, or a number that is not finite.
Result<std::string> writeSceneJson(const SceneDescription& scene, const std::string& path);

/// Writes the scene to `path` atomically, and beside it the image and mesh files that the scene holds in
/// memory (embedded_files.h). Error: as writeSceneJson, or a file cannot be written.
Status saveSceneJson(const SceneDescription& scene, const std::string& path);

}  // namespace glint
