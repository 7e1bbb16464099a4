// FLIP: the difference that a viewer sees when two pictures alternate on a screen (Andersson, Nilsson,
// Akenine-Moller, Oskarsson, Astrom, Fairchild 2020, "FLIP: A Difference Evaluator for Alternating Images").
//
// LDR-FLIP: linear Rec.709 is exposed and cut to [0, 1] per channel, which is what a PNG with the sRGB curve
// holds, without its 8-bit steps. Callers pass finite values.
#pragma once

#include <vector>

#include "engine/scene/image.h"

namespace glint {

/// One value a pixel, in [0, 1]: 0 where no difference is seen. Symmetric in the pictures. Equal sizes are
/// the caller's duty. Beyond the border the nearest pixel continues, as in the paper's supplement.
std::vector<float> flipMap(const ImageF& a, const ImageF& b, double exposureStops, double pixelsPerDegree,
                           int threads);

}  // namespace glint
