// How far a picture may be from the truth, from nothing but its own samples: no reference is needed.
//
// Used by the session (convergence curve, `--error`), by snapshots and by reports. What the samples cannot
// know is not in it: light that no path has found yet.
#pragma once

#include <limits>

namespace glint {

class Film;
struct SppmState;

/// Of the whole picture: root of the mean squared error of the pixels' luminances over the picture's mean
/// luminance. All infinite with fewer than two passes; 0 for a picture without variance.
struct ErrorEstimate {
    double relative = std::numeric_limits<double>::infinity();  ///< noise and bias together
    double low = std::numeric_limits<double>::infinity();       ///< 90 % band of `relative`
    double high = std::numeric_limits<double>::infinity();
    double bias = 0.0;  ///< the bias' share of `relative`; 0 for path tracing
};

/// `sppm` is null or empty for path tracing. The same bits for any number of threads (0: all).
ErrorEstimate estimateError(const Film& film, const SppmState* sppm, int threads = 0);

}  // namespace glint
