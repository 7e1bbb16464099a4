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

/// Error: anything outside the grammar, with its place; a file that is named and missing, and curves and bump
/// maps, which Glint does not draw yet, unless options.allowMissing. Paths count from the scene's folder or
/// the one above it.
Result<SceneDescription> readSceneText(TextSource source, const LoadOptions& options);

}  // namespace glint
