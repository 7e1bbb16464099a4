// How far a picture is from its reference, as numbers.
//
// All metrics work on linear Rec.709 values; those that model a viewer (ssim, flip) see them at a stated
// exposure. Maps for the eye are error_maps.h's; nothing here reads files or tone-maps for display.
#pragma once

#include <cstdint>

#include "engine/base/result.h"
#include "engine/scene/image.h"

namespace glint {

/// Pixels per degree of visual angle for a screen of 3840 pixels and 0.7 m width at 0.7 m distance, the
/// default of Andersson et al. 2020.
constexpr double kDefaultPixelsPerDegree = 67.020643276582255;

struct MetricOptions {
    /// Added to the denominators of relMse (beside the squared reference) and mape (beside the reference), so
    /// that dark pixels don't rule them. 0.01 as in Rousselle et al. 2011, "Adaptive Sampling and
    /// Reconstruction using Greedy Error Minimization". Above 0.
    double relativeEpsilon = 0.01;
    /// Share of the pixels, those with the largest relative squared error, that relMseTrimmed leaves out.
    /// [0, 1).
    double trimmedShare = 0.001;
    /// Pictures are multiplied by 2^exposureStops before ssim and flip look at them. Within [-60, 60].
    double exposureStops = 0.0;
    double pixelsPerDegree = kDefaultPixelsPerDegree;  ///< for flip; [1, 1000]
    bool ssim = true;                                  ///< false leaves it out: its value is then NaN
    bool flip = true;      ///< the same for flip, which takes longer than all others together
    bool hdrFlip = false;  ///< the same for hdrFlip, which takes several times as long as flip
    int threads = 0;       ///< 0: all; no result depends on it
};

/// With t the test picture, r the reference, and the mean over all compared pixels and their 3
/// channels alike (relMse, relMseTrimmed and mape are infinite where the mean of r is 0 and they are not):
struct ImageMetrics {
    double mse = 0.0;            ///< mean of (t - r)^2, in squared radiance
    double rmse = 0.0;           ///< square root of mse, in radiance
    double relMse = 0.0;         ///< mean of (t - r)^2 / (r^2 + relativeEpsilon)
    double relMseTrimmed = 0.0;  ///< the same without floor(trimmedShare * compared pixels) worst pixels
    double mape = 0.0;           ///< mean of |t - r| / (|r| + relativeEpsilon); 0.1 is 10 %
    double bias = 0.0;           ///< mean of t - r, in radiance: noise averages out of it
    /// bias / mean of r; 0 where both are 0, infinite where only the mean of r is
    double relativeBias = 0.0;
    /// engine/render/picture_error.h, in [0, 1], 0.02 for 2 %: the figure that a render estimates of itself
    double pictureError = 0.0;
    double maxError = 0.0;  ///< largest |t - r| of any channel
    double ssim = 1.0;      ///< structural similarity in [-1, 1], 1 for equal pictures (ssim.h)
    double flip = 0.0;      ///< mean LDR-FLIP in [0, 1], 0 for equal pictures (flip.h)
    /// mean HDR-FLIP in [0, 1], 0 for equal pictures (hdr_flip.h); looks at exposures of its own
    double hdrFlip = 0.0;

    uint64_t comparedPixels = 0;      ///< finite in both pictures; only they enter the figures above
    uint64_t trimmedPixels = 0;       ///< left out of relMseTrimmed
    uint64_t whollyWrongPixels = 0;   ///< off by their own brightness or more, see pictureError
    uint64_t testNonFinite = 0;       ///< pixels with an infinite or NaN channel
    uint64_t referenceNonFinite = 0;  ///< the same of the reference
    int maxErrorX = 0;                ///< where maxError is first met, from the top left
    int maxErrorY = 0;

    /// The usual "relative error": square root of relMse, 0.05 for 5 %.
    double relativeRmse() const;
};

/// Not a symmetric function: the reference is the second one. Sums are double, formed in a fixed order.
/// Pixels that are not finite in either picture are counted and left out; ssim and flip see them black in
/// both and leave them out of their mean. Error: sizes differ or are empty, options out of range, no pixel is
/// finite in both.
Result<ImageMetrics> compareImages(const ImageF& test, const ImageF& reference,
                                   const MetricOptions& options = {});

}  // namespace glint
