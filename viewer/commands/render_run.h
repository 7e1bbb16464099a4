// One batch render from a session to its files: progress, checkpoints, Ctrl-C, picture, report.
#pragma once

#include <memory>

#include "viewer/commands/render_options.h"

namespace glint {

struct RenderOutcome {
    int exitCode;
    std::optional<float> exposureStops;  ///< of its PNGs; nothing: there was none
};

/// Renders `scene` as `options` say and writes everything they name. Prints its own messages.
RenderOutcome runRender(std::shared_ptr<const SceneDescription> scene, const RenderCommandOptions& options,
                        double loadSeconds);

/// Prints the path of options.pixel in options.replayPass. Returns an exit code.
int runReplay(const SceneDescription& scene, const RenderCommandOptions& options);

}  // namespace glint
