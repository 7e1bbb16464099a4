// Renders a stability case on the CPU and takes means over blocks of the picture, with their errors.
//
// Paired measurements render two scenes from the same random numbers, so that noise cancels and only what the
// numbers do differently is left.
#pragma once

#include <functional>

#include "engine/scene/scene.h"
#include "engine/stress/stress_case.h"

namespace glint {

/// The true luminance of a pixel's mean; x to the right, y down.
using PixelTruth = std::function<double(int x, int y)>;

/// `passes` paths a pixel, compared with `truth` over blocks x blocks parts of the picture. Error: the scene
/// is refused, or the effort was stopped.
Result<StressOutcome> measurePaths(const SceneDescription& scene, uint32_t passes, const PixelTruth& truth,
                                   const StressEffort& effort, int blocks = 1);
/// The same truth everywhere.
Result<StressOutcome> measurePaths(const SceneDescription& scene, uint32_t passes, double truth,
                                   const StressEffort& effort, int blocks = 1);

/// The same against another scene with the same picture; dropped samples of either count.
Result<StressOutcome> measurePathsAgainst(const SceneDescription& extreme, const SceneDescription& benign,
                                          uint32_t passes, const StressEffort& effort, int blocks = 4);

/// `passes` photon passes, repeated with `runs` seeds whose spread gives the error: a pass's pixels share
/// photons, so that their own errors are not independent.
Result<StressOutcome> measurePhotons(const SceneDescription& scene, uint32_t passes, uint32_t runs,
                                     double truth, const StressEffort& effort);
Result<StressOutcome> measurePhotonsAgainst(const SceneDescription& extreme, const SceneDescription& benign,
                                            uint32_t passes, uint32_t runs, const StressEffort& effort,
                                            int blocks = 2);

}  // namespace glint
