// How far a picture may be from the truth, from nothing but its own samples: no reference is needed.
//
// Used by the session (convergence curve, `--error`), by snapshots, EXR layers and reports. What the samples
// cannot know is not in it: light that no path has found yet. engine/README.md says how well it is
// calibrated and from which pass on.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace glint {

class Film;
struct FilmRegion;
class ImageStatistics;

/// Of the whole picture: root of the mean squared error of the pixels' luminances over the picture's mean
/// luminance. The kTrimmedShare of the pixels with the largest squared errors is left out, as relMseTrimmed
/// does in engine/report/metrics.h: a picture of a million good pixels and one firefly is a good picture, and
/// its variance is known too badly to stop by. All infinite with fewer than two passes; 0 for a picture
/// without variance.
struct ErrorEstimate {
    double relative = std::numeric_limits<double>::infinity();  ///< noise and bias together
    double low = std::numeric_limits<double>::infinity();       ///< 90 % band of `relative`
    double high = std::numeric_limits<double>::infinity();
    double bias = 0.0;  ///< the bias' share of `relative`; 0 for path tracing
};

constexpr double kTrimmedShare = 0.001;

/// `statistics` are null, or empty, where the integrator has none. The same bits for any number of threads
/// (0: all). Of the pixels of `region` alone, which must lie in the film, unless that is null.
ErrorEstimate estimateError(const Film& film, const ImageStatistics* statistics, int threads = 0,
                            const FilmRegion* region = nullptr);

/// What is known of one pixel's luminance.
struct PixelError {
    double variance = 0.0;        ///< of its mean, calibrated; infinite with fewer than two passes
    double photonVariance = 0.0;  ///< the photons' share
    /// SPPM: estimate of the photons' bias, signed; its own variance is about three times photonVariance
    double bias = 0.0;
};
PixelError pixelError(const Film& film, const ImageStatistics* statistics, size_t index);

/// Of direct light and photons together.
double pixelLuminance(const Film& film, const ImageStatistics* statistics, size_t index);

/// For each pixel, what the true luminance lies within with 90 %: picture +- bound. Variances are averaged
/// over 5 x 5 pixels first: a pixel that has missed a rare bright path does not know its own.
std::vector<float> errorBounds(const Film& film, const ImageStatistics* statistics, int threads = 0);

}  // namespace glint
