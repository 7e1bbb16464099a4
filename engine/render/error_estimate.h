// How far a picture may be from the truth, from nothing but its own samples: no reference is needed.
//
// What the samples cannot know is not in it: light that no path has found yet. engine/render/README.md says
// how well it is calibrated and from which pass on.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace glint {

class Film;
struct FilmRegion;
class ImageStatistics;

/// Of the whole picture. All infinite with fewer than two passes; 0 for a picture without variance.
struct ErrorEstimate {
    double relative = std::numeric_limits<double>::infinity();  ///< noise and bias together
    double low = std::numeric_limits<double>::infinity();       ///< 90 % band of `relative`
    double high = std::numeric_limits<double>::infinity();
    double bias = 0.0;  ///< the bias' share of `relative`; 0 for path tracing
    /// Of the pixels, the share that is wrong by its own brightness or more, the kTrimmedShare of the worst
    /// with it: sparks, and what has hardly begun to converge.
    double whollyWrong = 0.0;
};

/// The picture error (picture_error.h). `statistics` are null, or empty, where the integrator has none. The
/// same bits for any number of threads (0: all). Of the pixels of `region` alone, which must lie in the film,
/// unless that is null.
ErrorEstimate estimateError(const Film& film, const ImageStatistics* statistics, int threads = 0,
                            const FilmRegion* region = nullptr);

/// Root of the mean squared error of the pixels' luminances over the picture's mean luminance, without the
/// kTrimmedShare of the worst: what lamps dominate where there are some, and what the plans of `glint
/// converge` are about. `whollyWrong` is 0.
ErrorEstimate estimateRmseOverMean(const Film& film, const ImageStatistics* statistics, int threads = 0);

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
