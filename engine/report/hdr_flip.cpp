// A loop over exposures around flipMap(), whose own exposure stays at 0: the tone-mapped values are what a
// screen shows.
#include "engine/report/hdr_flip.h"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel.h"
#include "engine/report/flip.h"

namespace glint {
namespace {

constexpr int64_t kValuesPerChunk = 16384;
constexpr double kShownAs = 0.85;
constexpr double kLeastMedian = 0x1p-23;

/// filmicCurve() in double (Narkowicz 2015, input scaled by 0.6): (a x^2 + b x) / (c x^2 + d x + e).
constexpr double kA = 0.36 * 2.51, kB = 0.6 * 0.03, kC = 0.36 * 2.43, kD = 0.6 * 0.59, kE = 0.14;

double filmic(double x) {
    return x > 0.0 ? std::clamp((kA * x * x + kB * x) / (kC * x * x + kD * x + kE), 0.0, 1.0) : 0.0;
}

/// The x that the curve takes to y: the positive root of (a - y c) x^2 + (b - y d) x - y e.
double filmicInverse(double y) {
    const double a = kA - y * kC;
    const double b = kB - y * kD;
    return (-b + std::sqrt(b * b + 4.0 * a * y * kE)) / (2.0 * a);
}

/// Exposed and tone-mapped. Huge values saturate before they can overflow.
ImageF shownAt(const ImageF& image, double exposureStops, int threads) {
    constexpr double kSaturated = 1e6;
    ImageF shown{.width = image.width, .height = image.height, .rgb = std::vector<float>(image.rgb.size())};
    const double exposure = std::exp2(exposureStops);
    parallelChunks(
        static_cast<int64_t>(image.rgb.size()), kValuesPerChunk, threads, [&](int64_t begin, int64_t end) {
            for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
                const double value = std::min(exposure * static_cast<double>(image.rgb[i]), kSaturated);
                shown.rgb[i] = static_cast<float>(filmic(value));
            }
        });
    return shown;
}

/// Of an even count: the mean of the two in the middle.
double medianOf(std::vector<double>* values) {
    const size_t half = values->size() / 2;
    const auto upper = values->begin() + static_cast<std::ptrdiff_t>(half);
    std::ranges::nth_element(*values, upper);
    return values->size() % 2 == 1 ? *upper : 0.5 * (*upper + *std::max_element(values->begin(), upper));
}

}  // namespace

ExposureRange hdrFlipExposures(const ImageF& reference) {
    std::vector<double> luminances(reference.rgb.size() / 3);
    for (size_t i = 0; i < luminances.size(); ++i) {
        luminances[i] = 0.2126 * static_cast<double>(reference.rgb[3 * i]) +
                        0.7152 * static_cast<double>(reference.rgb[3 * i + 1]) +
                        0.0722 * static_cast<double>(reference.rgb[3 * i + 2]);
    }
    const double largest = luminances.empty() ? 0.0 : *std::ranges::max_element(luminances);
    if (!(largest > 0.0)) { return {}; }
    const double median = std::max(medianOf(&luminances), kLeastMedian * largest);
    const double shown = filmicInverse(kShownAs);
    ExposureRange range{.start = std::log2(shown / largest), .stop = std::log2(shown / median), .count = 2};
    range.count = std::max(2, static_cast<int>(std::ceil(range.stop - range.start)));
    return range;
}

std::vector<float> hdrFlipMap(const ImageF& test, const ImageF& reference, double pixelsPerDegree,
                              int threads) {
    const ExposureRange range = hdrFlipExposures(reference);
    std::vector<float> worst(reference.rgb.size() / 3, 0.0f);
    for (int i = 0; i < range.count; ++i) {
        const double share = range.count > 1 ? static_cast<double>(i) / (range.count - 1) : 0.0;
        const double stops = range.start + share * (range.stop - range.start);
        const std::vector<float> map = flipMap(
            shownAt(test, stops, threads), shownAt(reference, stops, threads), 0.0, pixelsPerDegree, threads);
        std::ranges::transform(worst, map, worst.begin(), [](float a, float b) { return std::max(a, b); });
    }
    return worst;
}

}  // namespace glint
