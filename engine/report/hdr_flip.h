// HDR-FLIP: what a viewer sees at the worst of all sensible exposures (Andersson, Nilsson, Shirley,
// Akenine-Moller 2021, "Visualizing Errors in Rendered High Dynamic Range Images").
//
// For bright lamps and deep shadows, where one exposure hides half of the picture. Callers pass
// finite values.
#pragma once

#include <vector>

#include "engine/scene/image.h"

namespace glint {

/// In stops, rising.
struct ExposureRange {
    double start = 0.0;  ///< shows the reference's largest luminance as 0.85
    double stop = 0.0;   ///< shows its median luminance as 0.85
    int count = 1;       ///< evenly spaced exposures from start to stop: one a stop, rounded up, at least 2
};

/// Of the reference, for filmicCurve() (tonemap.h), the paper's choice. A median of 2^-23 of the largest
/// luminance or less counts as that much, which bounds the count. A black reference: one exposure of 0 stops.
ExposureRange hdrFlipExposures(const ImageF& reference);

/// For each pixel the largest LDR-FLIP (flip.h) over the range, both pictures tone-mapped by filmicCurve()
/// per channel. In [0, 1]. Takes `count` times as long as flipMap(). Equal sizes are the caller's duty.
std::vector<float> hdrFlipMap(const ImageF& test, const ImageF& reference, double pixelsPerDegree,
                              int threads);

}  // namespace glint
