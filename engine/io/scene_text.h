// The text format of MIT's course 6.837 with the path-tracing additions of later coursework: blocks
// in braces.
//
// Read only. What is read and left out is described in scenes/README.md.
#pragma once

#include "engine/base/result.h"
#include "engine/io/load_options.h"
#include "engine/io/text_source.h"
#include "engine/scene/scene.h"

namespace glint {

/// Files that are missing are left out with a warning. Error: anything outside the grammar, with its place;
/// no object is left, since its mesh is missing, unless options.allowMissing. Paths count from the scene's
/// folder or the one above it.
Result<SceneDescription> readSceneText(TextSource source, const LoadOptions& options);

}  // namespace glint
