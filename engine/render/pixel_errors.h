// What is known of each pixel's error, as means over a pixel and its neighbours: a pixel that has missed a
// rare path knows neither its own variance nor its brightness.
//
// It is for errors that are relative to the pixels' own brightness.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/render/error_estimate.h"
#include "engine/render/film_region.h"

namespace glint {

class PixelErrors {
  public:
    /// Of the pixels of `part`, which must lie in the film. `statistics` are null where there are none.
    PixelErrors(const Film& film, const ImageStatistics* statistics, int threads, const FilmRegion& part);

    struct Around {
        PixelError error;  ///< its bias is the root of a mean square
        double luminance = 0.0;
    };
    /// Over 3 x 3 pixels as far as they are in the part, have samples and are no sparks: pixels with a
    /// variance so many times as large as that of the 5 x 5 around them together, which tell of
    /// themselves alone. Of a pixel of the part; its own where it has no samples itself, and the error
    /// where it is a spark.
    Around around(size_t index) const;
    static constexpr double kSparkTimes = 8.0;
    /// The pixel's own; without the sign of its bias.
    PixelError error(size_t index) const;
    double luminance(size_t index) const { return values_[index].luminance; }

  private:
    struct Value {
        float variance, photonVariance, biasSquared, luminance;
    };

    bool isSpark(int x, int y) const;
    size_t indexOf(int x, int y) const {
        return static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
    }

    int width_;
    FilmRegion part_;
    std::vector<Value> values_;    ///< of the whole film; only those of the part are filled
    std::vector<uint8_t> sparks_;  ///< likewise: 1 for a spark
};

}  // namespace glint
