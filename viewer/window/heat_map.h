// False colours for positive numbers that span decades: SPPM's radii and photon counts. Logarithmic, from
// dark blue through green and yellow to white.
#pragma once

#include <vector>

#include "engine/math/vec.h"

namespace glint {

/// Smallest and largest positive finite value; {0, 0} when there is none.
struct HeatScale {
    float smallest = 0.0f;
    float largest = 0.0f;
};
HeatScale heatScale(const std::vector<float>& values);

/// Display values in [0, 1]. `share` in [0, 1] along the scale; brighter means more.
Vec3 heatColor(float share);
/// Black for values that are not positive. A scale of one value: its middle.
Vec3 heatColor(float value, const HeatScale& scale);

}  // namespace glint
