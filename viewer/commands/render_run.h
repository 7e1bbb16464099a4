// One batch render from a session to its files: progress, checkpoints, Ctrl-C, picture, report.
#pragma once

#include <memory>

#include "viewer/base/run_files.h"
#include "viewer/commands/render_options.h"

namespace glint {

struct RenderOutcome {
    int exitCode;
    std::optional<float> exposureStops;  ///< of its PNGs; nothing: there was none
};

/// Renders `scene` as `options` say and writes everything they name, but over none of the `files` that are
/// read. Prints its own messages.
RenderOutcome runRender(std::shared_ptr<const SceneDescription> scene, const RenderCommandOptions& options,
                        const RunFiles& files, double loadSeconds);

/// Prints the path of options.pixel in options.replayPass. Returns an exit code.
int runReplay(const SceneDescription& scene, const RenderCommandOptions& options);

}  // namespace glint
