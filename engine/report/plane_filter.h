// Separable convolution of single-channel pictures, the inner loop of SSIM and FLIP.
//
// Rows are spread over threads; every output sums its taps in the same order, so the result does not depend
// on them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace glint {

/// What a thread takes at once of a plane of pixels.
constexpr int64_t kPixelsPerChunk = 8192;

/// width * height values, row 0 at the top.
struct Plane {
    int width = 0;
    int height = 0;
    std::vector<float> values;
};

/// out(x, y) = sum over j, i of column[j] row[i] in(x + i - radius, y + j - radius): a correlation, so an odd
/// kernel responds to a rising edge with its own sign. Both kernels have odd lengths. Outside the plane the
/// nearest pixel counts.
Plane filterSeparable(const Plane& in, std::span<const double> row, std::span<const double> column,
                      int threads);

/// exp(-x^2 / (2 deviation^2)) at x = -radius ... radius, summing to 1.
std::vector<double> gaussianWeights(double deviation, int radius);

}  // namespace glint
