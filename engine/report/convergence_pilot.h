// How precise a reference has to be: the smallest error that a convergence run will report, foretold by
// renders of its variants.
//
// What comes out is a plan: whether the reference was precise enough is measured
// afterwards (ConvergenceSummary::floorRatio).
#pragma once

#include "engine/report/convergence_run.h"

namespace glint {

/// Renders each variant once to the plan's end, or for `mostSeconds` of rendering; its error is then taken to
/// go on falling as it did in the second half of that, but neither slower than time^-0.5 nor faster than 1 /
/// time. Errors are lower ends of the estimate's 90 % band, less a quarter: a reference that is too precise
/// costs less than one that is not precise enough. 0: not known (interrupted, nothing rendered).
double predictSmallestError(const ConvergencePlan& plan, const SceneDescription& scene, double mostSeconds,
                            const ConvergenceHost& host);

}  // namespace glint
