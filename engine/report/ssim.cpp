// Local means, variances and covariance by Gaussian windows, in double: variances of flat regions are
// differences of nearly equal numbers.
#include "engine/report/ssim.h"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel.h"
#include "engine/report/plane_filter.h"

namespace glint {
namespace {

constexpr double kDeviation = 1.5;
constexpr double kC1 = 0.01 * 0.01;
constexpr double kC2 = 0.03 * 0.03;
constexpr int64_t kRowsPerChunk = 8;

double encodedSrgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

std::vector<double> shownLuminance(const ImageF& image, double exposureStops, int threads) {
    std::vector<double> shown(static_cast<size_t>(image.width) * static_cast<size_t>(image.height));
    const double exposure = std::exp2(exposureStops);
    parallelChunks(static_cast<int64_t>(shown.size()), 4096, threads, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            const float* rgb = image.rgb.data() + 3 * i;
            const double luminance = 0.2126 * static_cast<double>(rgb[0]) +
                                     0.7152 * static_cast<double>(rgb[1]) +
                                     0.0722 * static_cast<double>(rgb[2]);
            shown[static_cast<size_t>(i)] = encodedSrgb(std::clamp(exposure * luminance, 0.0, 1.0));
        }
    });
    return shown;
}

/// Weighted sums over a window.
struct Moments {
    double weight = 0.0, a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;

    void add(double w, const Moments& m) {
        weight += w * m.weight;
        a += w * m.a;
        b += w * m.b;
        aa += w * m.aa;
        bb += w * m.bb;
        ab += w * m.ab;
    }
};

double similarity(const Moments& m) {
    const double meanA = m.a / m.weight;
    const double meanB = m.b / m.weight;
    const double varianceA = std::max(0.0, m.aa / m.weight - meanA * meanA);
    const double varianceB = std::max(0.0, m.bb / m.weight - meanB * meanB);
    const double covariance = m.ab / m.weight - meanA * meanB;
    return (2.0 * meanA * meanB + kC1) * (2.0 * covariance + kC2) /
           ((meanA * meanA + meanB * meanB + kC1) * (varianceA + varianceB + kC2));
}

/// Sums of the taps that lie within [0, count), of at(index).
template <class At>
Moments windowSum(const std::vector<double>& weights, int centre, int count, const At& at) {
    Moments sum;
    for (int tap = 0; tap <= 2 * kSsimRadius; ++tap) {
        const int i = centre + tap - kSsimRadius;
        if (i >= 0 && i < count) { sum.add(weights[static_cast<size_t>(tap)], at(i)); }
    }
    return sum;
}

}  // namespace

std::vector<float> ssimMap(const ImageF& a, const ImageF& b, double exposureStops, int threads) {
    const std::vector<double> shownA = shownLuminance(a, exposureStops, threads);
    const std::vector<double> shownB = shownLuminance(b, exposureStops, threads);
    const std::vector<double> weights = gaussianWeights(kDeviation, kSsimRadius);
    const auto width = static_cast<size_t>(a.width);
    std::vector<float> map(shownA.size());
    parallelChunks(a.height, kRowsPerChunk, threads, [&](int64_t begin, int64_t end) {
        std::vector<Moments> columns(width);
        for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
            for (size_t x = 0; x < width; ++x) {
                columns[x] = windowSum(weights, y, a.height, [&](int row) {
                    const size_t i = static_cast<size_t>(row) * width + x;
                    const double va = shownA[i];
                    const double vb = shownB[i];
                    return Moments{1.0, va, vb, va * va, vb * vb, va * vb};
                });
            }
            for (int x = 0; x < a.width; ++x) {
                const Moments window = windowSum(
                    weights, x, a.width, [&](int column) { return columns[static_cast<size_t>(column)]; });
                map[static_cast<size_t>(y) * width + static_cast<size_t>(x)] =
                    static_cast<float>(similarity(window));
            }
        }
    });
    return map;
}

}  // namespace glint
