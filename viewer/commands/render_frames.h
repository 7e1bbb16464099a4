// Numbered pictures of a camera that moves: `glint render --turntable N` and `--flight N`.
#pragma once

#include "engine/scene/scene.h"
#include "viewer/base/run_files.h"
#include "viewer/commands/render_options.h"

namespace glint {

/// There are frames to render instead of one picture.
bool rendersFrames(const RenderCommandOptions& options);

/// Adds every frame's picture to the files that are written. Error: also options that frames do not go with.
Status checkFrames(const RenderCommandOptions& options, const RunFiles& files);

/// Renders all of them, with the first one's exposure where none is stated, and stops when interrupted.
/// Returns an exit code.
int runFrames(const SceneDescription& scene, const RenderCommandOptions& options, const RunFiles& files,
              double loadSeconds);

}  // namespace glint
