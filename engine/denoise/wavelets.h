// The quick filter's candidate, which also guides the careful one's weights.
#pragma once

#include "engine/denoise/planes.h"

namespace glint {

Candidate waveletFilter(const Planes& planes, int threads);

}  // namespace glint
