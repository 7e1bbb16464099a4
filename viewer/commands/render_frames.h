// Numbered pictures of a camera that moves: `glint render --turntable N` and `--flight N`.
#pragma once

#include "engine/scene/scene.h"
#include "viewer/base/run_files.h"
#include "viewer/commands/render_options.h"

namespace glint {

/// How many frames there are to render instead of one picture; 0: none.
uint32_t frameCount(const RenderCommandOptions& options);

/// Error: the first frame's picture cannot be written; there are options that frames do not go with.
Status checkFrames(const RenderCommandOptions& options, const RunFiles& files);

/// Renders all of them, with the first one's exposure where none is stated, and stops when interrupted.
/// Returns an exit code.
int runFrames(const SceneDescription& scene, const RenderCommandOptions& options, double loadSeconds);

}  // namespace glint
