// Takes noise out of a picture, guided by what the camera sees first and by how much each pixel scatters.
//
// Two filters over the same input: a quick one for pictures in motion, and a careful one for pictures that
// stay. Neither gives up more of the input than its estimated error allows. Plain arrays in and out: films,
// snapshots and files are render/'s.
#pragma once

#include <atomic>
#include <vector>

#include "engine/math/vec.h"

namespace glint {

/// One value a pixel in every list, row 0 at the top.
struct DenoiseInput {
    int width = 0;
    int height = 0;
    std::vector<Vec3> radiance{};   ///< linear, finite
    std::vector<float> variance{};  ///< of the pixel's mean luminance; not finite: unknown
    std::vector<Vec3> albedo{};     ///< of the first hit, as a mean over passes, likewise the next two
    std::vector<Vec3> normal{};     ///< 0: nothing hit
    std::vector<float> depth{};     ///< 0: nothing hit
};

/// Half the side of the squares of pixels that errors are stated of.
constexpr int kDenoiseErrorHalf = 5;
/// What is taken away in a square, as a root mean square, is at most that many of the input's standard errors
/// there: so, by the triangle's inequality, the picture is worse than the input by no more, whatever the
/// truth. One would leave sparks in part.
constexpr float kDenoiseMostChange = 1.25f;

/// Squares of luminances are relative to what is bright in 5 x 5 pixels, and to a tenth of the mean.
/// `error` is stated of the picture itself: the root of Stein's estimate of its mean squared error over a
/// square, to which no pixel adds that had a say in what it became, and one standard error of that estimate.
/// It holds in most squares, not in all: whatever is less than what was taken away fails where the input
/// happens to be right, and of light that no sample has found so far the variance knows nothing.
struct DenoisedImage {
    std::vector<Vec3> radiance;
    std::vector<float> error;  ///< of the luminance
};

/// Wavelets with holes whose weights follow normals, depths and luminances (Dammertz et al. 2010,
/// "Edge-Avoiding À-Trous Wavelet Transform"; weights by variance as in Schied et al. 2017,
/// "Spatiotemporal Variance-Guided Filtering", section 4.4), over the radiance without the albedo. Unknown
/// variances are taken from the neighbourhood, so that a single pass will do. The same bits for any number
/// of threads (0: all).
DenoisedImage denoiseQuickly(const DenoiseInput& input, int threads = 0);

/// The same, and first-order regressions of the radiance on the features in overlapping windows (Moon et al.
/// 2014, "Adaptive Rendering Based on Weighted Local Regression"; Bitterli et al. 2016, "Nonlinearly Weighted
/// First-Order Regression for Denoising Monte Carlo Renderings") with narrow and wide weights, with the
/// albedo as a factor and as a feature. Each pixel takes the one with the smallest error as Stein's unbiased
/// estimate has it (Stein 1981), and of the input the share that makes that error smaller still: so what has
/// converged stays as it is within its standard error. Empty where `stop` (may be null) was raised meanwhile.
/// The same bits for any number of threads (0: all).
DenoisedImage denoise(const DenoiseInput& input, int threads = 0, const std::atomic<bool>* stop = nullptr);

}  // namespace glint
