// Writes the files that a scene holds in memory (EmbeddedFile) beside the scene that is saved: Glint JSON
// names its images and mesh files, so that a saved scene loses none.
#pragma once

#include <map>
#include <string>

#include "engine/base/result.h"
#include "engine/scene/scene.h"

namespace glint {

/// Writes the file to the folder of `scenePath` under its own name, and says under which: a file of that name
/// that holds the same bytes is used as it is, one that holds others is kept, and the new one gets a number.
/// Error: it cannot be written.
Result<std::string> writeBeside(const EmbeddedFile& file, const std::string& scenePath);

/// The scene's files in `folder` become embedded ones again; those that cannot be read stay as they are.
void embedFilesOf(const std::string& folder, SceneDescription* scene);

/// Files in memory by the paths that stand for them in a scene's text.
using EmbeddedByPath = std::map<std::string, EmbeddedFile>;

/// Each embedded file of `scene` becomes a FileSource, of a path that no file of the scene has.
EmbeddedByPath nameEmbeddedFiles(SceneDescription* scene);

/// The sources of these paths become the files again.
void restoreEmbeddedFiles(const EmbeddedByPath& files, SceneDescription* scene);

/// Each embedded file of `scene` is written so, and becomes a FileSource. Error: a file cannot be written.
Status writeEmbeddedFiles(SceneDescription* scene, const std::string& scenePath);

}  // namespace glint
