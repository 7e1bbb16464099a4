// A candidate of the careful filter: regressions in overlapping windows.
#pragma once

#include "engine/denoise/planes.h"

namespace glint {

struct RegressionSettings {
    bool isDemodulated = true;  ///< regress the radiance without the albedo
    /// weights fall by e where the guide's colours are so many standard errors apart
    float colorWidth = 1.0f;
};

/// `guide` is the picture with little noise, whose differences tell where weights end; `noise` the variance
/// of the input's luminance, smooth. Unfinished where `stop` (may be null) is raised.
Candidate regressionFilter(const Planes& planes, const std::vector<Vec3>& guide,
                           const std::vector<float>& noise, const RegressionSettings& settings, int threads,
                           const std::atomic<bool>* stop);

}  // namespace glint
