// Structural similarity of two pictures (Wang, Bovik, Sheikh, Simoncelli 2004, "Image Quality Assessment:
// From Error Visibility to Structural Similarity", equation 13).
//
// Sees the pictures as a screen shows them: luminance, exposed, cut to [0, 1], sRGB-encoded. Knows nothing of
// non-finite pixels: callers pass finite values.
#pragma once

#include <vector>

#include "engine/scene/image.h"

namespace glint {

/// Half the width of the 11 x 11 Gaussian window, of standard deviation 1.5 pixels.
constexpr int kSsimRadius = 5;

/// One value a pixel, in [-1, 1], with K1 = 0.01, K2 = 0.03 and L = 1. Where the window passes the border, it
/// is cut there and its weights sum to 1 again. Symmetric in the pictures. Equal sizes are the caller's duty.
std::vector<float> ssimMap(const ImageF& a, const ImageF& b, double exposureStops, int threads);

}  // namespace glint
