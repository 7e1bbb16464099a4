// What must hold of a description before anything is built from it. Loaders check files in their own words;
// this guards against edits and against scenes made by code.
#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene_edit.h"

namespace glint {

/// Error: an index out of range, a transform that flattens or is not finite, a number out of the range that
/// its declaration states, naming the object, material or light. Checks what `kinds` concern, and never the
/// values of single triangles and pixels: the cost stays far below a frame's.
Status validateScene(const SceneDescription& scene, EditKind kinds);

/// The largest picture either way, in pixels.
constexpr int kMaxResolution = 65536;

}  // namespace glint
