// Sums of the pixels' squared errors, kept by size, so that the largest can be left out without sorting.
//
// What is expected of a film's errors comes in, what is expected of their
// sum without the largest ones comes out. No film and no calibration in here.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/render/error_estimate.h"

namespace glint {

/// The estimate of the bias is of second order in the radius; what edges and peaks narrower than a disc add
/// to it, measured on a Cornell box and on glass caustics at 20 x 20 pixels with discs of four pixels.
constexpr double kHigherOrders = 1.35;

/// The calibration of a class of few pixels leans on the whole picture, as if that had so many of them.
constexpr double kClassPriorPixels = 8.0;

/// Pixels of about the same squared error: a bin is a float's exponent.
struct ErrorBin {
    double noise = 0.0;  ///< sum of variances
    double noiseSquared = 0.0;
    double photonSquared = 0.0;
    double bias = 0.0;              ///< sum of squared biases, less what their own noise adds
    double biasTimesPhotons = 0.0;  ///< the same times the photons' variance
    uint64_t pixels = 0;
};

struct ErrorSums {
    static constexpr size_t kBins = 256;
    /// The last one counts pixels of which nothing is known.
    std::vector<ErrorBin> bins = std::vector<ErrorBin>(kBins);

    /// Errors are counted relative to the root of `scaleSquared`; with 0 they are none. `alike` says to which
    /// pixels this one is alike: one that has missed a rare path does not know by itself. A pixel of which
    /// nothing is known, since its samples were dropped, counts as one of the worst.
    void add(const PixelError& error, const PixelError& alike, double scaleSquared);
    void add(const ErrorSums& other);
};

/// What is expected of the squared errors without the largest ones. Which those are is not known beforehand:
/// a pixel's error is normal, so its square may be much larger than its variance, and those are left out that
/// turn out so.
struct TrimmedErrors {
    double noise = 0.0;
    double bias = 0.0;               ///< not negative
    double capped = 0.0;             ///< of the errors that are no smaller than the cap
    double pixelsCapped = 0.0;       ///< expected, the ones left out among them
    double noiseVariance = 0.0;      ///< of the sum of squares, were each error independent
    double varianceSquared = 0.0;    ///< sum of squares of the variances, as far as they are in `noise`
    double calibratedSquared = 0.0;  ///< the same, of a class's calibration as far as it is its own
    double photonSquared = 0.0;
    double biasTimesPhotons = 0.0;

    double squaredError() const { return noise + bias + capped; }
};

/// `worst` need not be whole. No squared error counts more than `cap`.
TrimmedErrors withoutWorst(const ErrorSums& sums, double worst, double cap);

}  // namespace glint
