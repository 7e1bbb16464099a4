// Pixels that a few rare samples made far too bright, as the filters are to see them.
#pragma once

#include <vector>

#include "engine/denoise/denoise.h"

namespace glint {

struct CalmImage {
    /// No spark is brighter, in any channel, than the third of the pixels around it.
    std::vector<Vec3> radiance;
    std::vector<char> isSpark;
};

/// A spark has a channel of several times the third largest of the 24 pixels around, and so much luminance
/// above it as its own standard error explains, as one bright sample does. `variance`: of each pixel's
/// luminance, finite.
CalmImage withoutSparks(const DenoiseInput& input, const std::vector<float>& variance, int threads);

}  // namespace glint
