// Angles as scene files have them.
#pragma once

#include "engine/math/vec.h"

namespace glint {

/// As these files have always been read: another order of operations would change pictures by a bit.
inline float radians(float degrees) { return degrees * (kPi / 180.0f); }

}  // namespace glint
