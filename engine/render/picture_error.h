// The one figure that says how wrong a picture is: the status line's, `--error`'s, and that of `glint diff`
// and `glint converge`.
//
// A pixel whose luminance is e off the truth is wrong by the share
//     min(1, e^2 / (l^2 + (kDarkShare t)^2))
// with l the mean luminance of the truth over the 3 x 3 pixels around it, as far as there are some, and t its
// typical luminance. The picture error is the root of the mean of these shares without the
// kTrimmedShare of the pixels with the largest ones. So a lamp counts by its own brightness and not by that
// of the walls, a pixel cannot be more wrong than wholly, and the figure lies in [0, 1]: 0.02 is 2 %, and a
// black picture is about 1. engine/report/README.md tells why.
//
// error_estimate.h estimates it from the samples alone, engine/report/metrics.h measures it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace glint {

constexpr double kTrimmedShare = 0.001;
/// What is darker than this share of the typical luminance is as good as black.
constexpr double kDarkShare = 0.1;
/// The largest squared error of a pixel, relative to its scale.
constexpr double kWhollyWrong = 1.0;

/// The square of the mean root of the luminances: close to their mean where they are alike, and hardly moved
/// by a sun in a few pixels, where a mean would call all the rest dark, or by a dark background, where a
/// median would be 0.
class TypicalLuminance {
  public:
    /// Negative ones count as 0.
    void add(double luminance) {
        roots_ += std::sqrt(std::max(0.0, luminance));
        ++count_;
    }
    void add(const TypicalLuminance& other) {
        roots_ += other.roots_;
        count_ += other.count_;
    }
    /// 0 without pixels.
    double value() const {
        const double mean = count_ > 0 ? roots_ / static_cast<double>(count_) : 0.0;
        return mean * mean;
    }

  private:
    double roots_ = 0.0;
    uint64_t count_ = 0;
};

/// What a pixel's squared error is relative to. 0 in a black picture alone.
inline double errorScaleSquared(double luminanceAround, double typicalLuminance) {
    const double dark = kDarkShare * typicalLuminance;
    return luminanceAround * luminanceAround + dark * dark;
}

}  // namespace glint
