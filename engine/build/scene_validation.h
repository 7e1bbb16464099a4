// What must hold of a description before anything is built from it. Loaders check files in their own words;
// this guards against edits and against scenes made by code.
#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene.h"

namespace glint {

/// Error: an index out of range, a transform that flattens or is not finite, a number out of the range that
/// its declaration states, naming the object, material or light. Checks everything but the triangles' and
/// pixels' values.
Status validateScene(const SceneDescription& scene);

/// The largest picture either way, in pixels.
constexpr int kMaxResolution = 65536;

}  // namespace glint
