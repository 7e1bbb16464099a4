// False colours for numbers: from dark blue through green and yellow to white, or both ways from black.
//
// The window colours SPPM's radii and photon counts with it, error_maps.h errors. One ramp for all, so that
// "brighter is more" holds everywhere.
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

/// Display values in [0, 1]. `share` in [0, 1] along the scale; brighter means more: CIE lightness
/// rises throughout.
Vec3 heatColor(float share);
/// By the value's place between the logarithms of the scale's ends. Black for values that are not positive. A
/// scale of one value: its middle.
Vec3 heatColor(float value, const HeatScale& scale);

/// Display values in [0, 1] for `share` in [-1, 1]: blue below, black at 0, orange above, told apart with any
/// common colour blindness. Brighter means farther from 0.
Vec3 signedColor(float share);

}  // namespace glint
