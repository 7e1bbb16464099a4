// One pass of path tracing without a session: for measurements.
#pragma once

#include <atomic>
#include <vector>

#include "engine/render/backend.h"

namespace glint {

/// As Integrator::renderPass().
Result<bool> renderPathPass(Backend& backend, const PassParams& params, const std::atomic<bool>& stop,
                            std::vector<PixelSample>* samples);

}  // namespace glint
