// A ray and where it is valid. Host and device.
#pragma once

#include "engine/math/vec.h"

namespace glint {

struct Ray {
    Vec3 origin;
    Vec3 direction;  ///< need not be of unit length; t is measured in its lengths
    /// hits at t <= tMin do not count; 0 because origins are offset (surface.h), not epsilons
    float tMin = 0.0f;
    float tMax = kInfinity;  ///< hits at t >= tMax do not count

    GLINT_HD Vec3 at(float t) const { return origin + direction * t; }
};

}  // namespace glint
