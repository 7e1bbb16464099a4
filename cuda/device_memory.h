// The one message about device memory that is not there.
#pragma once

#include <string_view>

#include "cuda/device.h"

namespace glint {

/// Error: `bytes` more than what is free and the `held` that would be given back; `what` with its verb, "The
/// scene needs". Asked before anything is taken.
Status checkFits(const Device& device, std::string_view what, size_t bytes, size_t held = 0);

}  // namespace glint
