// Repeats the path of one pixel in one pass and tells what happened, vertex by vertex: for dropped samples,
// fireflies and tests. It is no part of rendering.
#pragma once

#include <string>
#include <vector>

#include "engine/kernels/features.h"
#include "engine/kernels/path_log.h"
#include "engine/kernels/scene_view.h"

namespace glint {

struct PathReplay {
    PixelSample sample;  ///< the same bits as the pass had
    std::vector<PathEvent> events;
};

/// Pixel (x, y) must lie in the picture; params.pass says which sample. `features` are the scene's
/// (BuiltScene::features), so that the back end's kernel runs and every bit repeats.
PathReplay replayPath(const SceneView& view, FeatureMask features, const PassParams& params, int x, int y);

/// One or two lines an event, and at the end the radiance with the reason it would be dropped, naming the
/// first event whose value was not finite or negative.
std::string formatPathLog(const PathReplay& replay, const PassParams& params, int x, int y);

}  // namespace glint
