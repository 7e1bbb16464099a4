// Sums are formed per block of rows and added in their order, so that threads change nothing.
#include "engine/report/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "engine/base/parallel.h"
#include "engine/render/picture_error.h"
#include "engine/report/finite_pixels.h"
#include "engine/report/flip.h"
#include "engine/report/hdr_flip.h"
#include "engine/report/ssim.h"

namespace glint {
namespace {

constexpr int64_t kRowsPerBlock = 16;

/// What one block of rows adds.
struct Sums {
    double squared = 0.0, relative = 0.0, absoluteRelative = 0.0, signedError = 0.0, reference = 0.0;
    uint64_t pixels = 0, testNonFinite = 0, referenceNonFinite = 0;
    double largest = -1.0;
    size_t largestAt = 0;

    void add(const Sums& other) {
        squared += other.squared;
        relative += other.relative;
        absoluteRelative += other.absoluteRelative;
        signedError += other.signedError;
        reference += other.reference;
        pixels += other.pixels;
        testNonFinite += other.testNonFinite;
        referenceNonFinite += other.referenceNonFinite;
        if (other.largest > largest) {
            largest = other.largest;
            largestAt = other.largestAt;
        }
    }
};

/// The pictures, and what is found of each pixel on the way.
struct Comparison {
    const ImageF& test;
    const ImageF& reference;
    double epsilon;
    std::vector<uint8_t> finite;        ///< in both
    double typicalLuminance;            ///< of the reference
    std::vector<double> relativeError;  ///< mean over the channels
    std::vector<double> wrongShare;     ///< of picture_error.h

    Sums sumPixels(size_t begin, size_t end);
    double wrongShareOf(size_t pixel) const;
};

double luminanceAt(const ImageF& image, size_t pixel) {
    const float* rgb = image.rgb.data() + 3 * pixel;
    return 0.2126 * static_cast<double>(rgb[0]) + 0.7152 * static_cast<double>(rgb[1]) +
           0.0722 * static_cast<double>(rgb[2]);
}

/// Mean over 3 x 3 pixels, of those that are finite; the middle one is.
double luminanceAround(const ImageF& image, size_t pixel) {
    const int width = image.width, x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
    double sum = 0.0, count = 0.0;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
            const size_t i = static_cast<size_t>(v) * static_cast<size_t>(width) + static_cast<size_t>(u);
            if (!isFinitePixel(image, i)) { continue; }
            sum += luminanceAt(image, i);
            count += 1.0;
        }
    }
    return sum / count;
}

double typicalLuminanceOf(const ImageF& test, const ImageF& reference) {
    TypicalLuminance typical;
    for (size_t i = 0; i < reference.rgb.size() / 3; ++i) {
        if (isFinitePixel(test, i) && isFinitePixel(reference, i)) { typical.add(luminanceAt(reference, i)); }
    }
    return typical.value();
}

double Comparison::wrongShareOf(size_t pixel) const {
    const double error = luminanceAt(test, pixel) - luminanceAt(reference, pixel);
    const double scale = errorScaleSquared(luminanceAround(reference, pixel), typicalLuminance);
    return error == 0.0 ? 0.0 : std::min(kWhollyWrong, error * error / scale);
}

Sums Comparison::sumPixels(size_t begin, size_t end) {
    Sums sums;
    for (size_t i = begin; i < end; ++i) {
        const bool testFinite = isFinitePixel(test, i);
        const bool referenceFinite = isFinitePixel(reference, i);
        sums.testNonFinite += testFinite ? 0 : 1;
        sums.referenceNonFinite += referenceFinite ? 0 : 1;
        finite[i] = testFinite && referenceFinite ? 1 : 0;
        if (finite[i] == 0) { continue; }
        ++sums.pixels;
        double relative = 0.0;
        for (size_t c = 3 * i; c < 3 * i + 3; ++c) {
            const double r = static_cast<double>(reference.rgb[c]);
            const double error = static_cast<double>(test.rgb[c]) - r;
            sums.squared += error * error;
            relative += error * error / (r * r + epsilon);
            sums.absoluteRelative += std::abs(error) / (std::abs(r) + epsilon);
            sums.signedError += error;
            sums.reference += r;
            if (std::abs(error) > sums.largest) {
                sums.largest = std::abs(error);
                sums.largestAt = i;
            }
        }
        relativeError[i] = relative / 3.0;
        wrongShare[i] = wrongShareOf(i);
        sums.relative += relativeError[i];
    }
    return sums;
}

Sums sumAll(Comparison* comparison, int threads) {
    const auto width = static_cast<size_t>(comparison->test.width);
    const int64_t height = comparison->test.height;
    std::vector<Sums> blocks(static_cast<size_t>((height + kRowsPerBlock - 1) / kRowsPerBlock));
    parallelChunks(height, kRowsPerBlock, threads, [&](int64_t begin, int64_t end) {
        blocks[static_cast<size_t>(begin / kRowsPerBlock)] =
            comparison->sumPixels(static_cast<size_t>(begin) * width, static_cast<size_t>(end) * width);
    });
    Sums total;
    for (const Sums& block : blocks) {
        total.add(block);
    }
    return total;
}

/// Sum of the `kept` smallest of the finite pixels' values, of which the largest may count in part. Above 0.
/// Ties at the limit count as often as they are kept.
double sumOfSmallest(const std::vector<uint8_t>& finite, const std::vector<double>& values, double kept) {
    std::vector<double> sorted;
    for (size_t i = 0; i < finite.size(); ++i) {
        if (finite[i] != 0) { sorted.push_back(values[i]); }
    }
    const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(std::ceil(kept)) - 1;
    std::nth_element(sorted.begin(), last, sorted.end());
    const double limit = *last;
    double sum = 0.0;
    uint64_t below = 0;
    for (size_t i = 0; i < finite.size(); ++i) {
        if (finite[i] != 0 && values[i] < limit) {
            sum += values[i];
            ++below;
        }
    }
    return sum + (kept - static_cast<double>(below)) * limit;
}

/// How wrong the picture is, and how many pixels are wholly so.
void addPictureError(const Comparison& comparison, ImageMetrics* metrics) {
    const double kept = (1.0 - kTrimmedShare) * static_cast<double>(metrics->comparedPixels);
    metrics->pictureError = std::sqrt(sumOfSmallest(comparison.finite, comparison.wrongShare, kept) / kept);
    metrics->whollyWrongPixels = static_cast<uint64_t>(
        std::ranges::count_if(comparison.wrongShare, [](double share) { return share >= kWhollyWrong; }));
}

/// Mean over the finite pixels of rows and columns from `border` to as far from the other side.
double meanInside(const std::vector<float>& map, const Comparison& comparison, int border) {
    double sum = 0.0;
    uint64_t count = 0;
    for (int y = border; y < comparison.test.height - border; ++y) {
        for (int x = border; x < comparison.test.width - border; ++x) {
            const size_t i =
                static_cast<size_t>(y) * static_cast<size_t>(comparison.test.width) + static_cast<size_t>(x);
            if (comparison.finite[i] != 0) {
                sum += static_cast<double>(map[i]);
                ++count;
            }
        }
    }
    return count > 0 ? sum / static_cast<double>(count) : std::numeric_limits<double>::quiet_NaN();
}

/// The mean over the windows that fit into the picture, as Wang et al.; over all of them where none fits.
double meanSsim(const ImageF& test, const ImageF& reference, const Comparison& comparison,
                const MetricOptions& options) {
    const std::vector<float> map = ssimMap(test, reference, options.exposureStops, options.threads);
    const double inside = meanInside(map, comparison, kSsimRadius);
    return std::isnan(inside) ? meanInside(map, comparison, 0) : inside;
}

void addViewerMetrics(const Comparison& comparison, const MetricOptions& options, ImageMetrics* metrics) {
    const bool allFinite = metrics->testNonFinite == 0 && metrics->referenceNonFinite == 0;
    const ImageF cleanTest = allFinite ? ImageF{} : withBlackWhere(comparison.test, comparison.finite);
    const ImageF cleanReference =
        allFinite ? ImageF{} : withBlackWhere(comparison.reference, comparison.finite);
    const ImageF& test = allFinite ? comparison.test : cleanTest;
    const ImageF& reference = allFinite ? comparison.reference : cleanReference;
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    metrics->ssim = options.ssim ? meanSsim(test, reference, comparison, options) : kNone;
    metrics->flip = metrics->hdrFlip = kNone;
    if (options.flip) {
        const std::vector<float> map =
            flipMap(test, reference, options.exposureStops, options.pixelsPerDegree, options.threads);
        metrics->flip = meanInside(map, comparison, 0);
    }
    if (options.hdrFlip) {
        const std::vector<float> map = hdrFlipMap(test, reference, options.pixelsPerDegree, options.threads);
        metrics->hdrFlip = meanInside(map, comparison, 0);
    }
}

Error problem(std::string message) { return {.message = std::move(message), .place = {}}; }

Status checkInputs(const ImageF& test, const ImageF& reference, const MetricOptions& options) {
    if (test.width <= 0 || test.height <= 0 || reference.width <= 0 || reference.height <= 0) {
        return problem("cannot compare an empty picture");
    }
    if (test.width != reference.width || test.height != reference.height) {
        return problem(fmt::format("the pictures differ in size: {}x{} pixels against the reference's {}x{}",
                                   test.width, test.height, reference.width, reference.height));
    }
    if (!(options.relativeEpsilon > 0.0) || !std::isfinite(options.relativeEpsilon)) {
        return problem(
            fmt::format("relative epsilon {}: expected a number above 0", options.relativeEpsilon));
    }
    if (!(options.trimmedShare >= 0.0 && options.trimmedShare < 1.0)) {
        return problem(
            fmt::format("trimmed share {}: expected 0 or more, and below 1", options.trimmedShare));
    }
    if (!(std::abs(options.exposureStops) <= 60.0)) {
        return problem(fmt::format("exposure {}: expected -60 to 60 stops", options.exposureStops));
    }
    if (!(options.pixelsPerDegree >= 1.0 && options.pixelsPerDegree <= 1000.0)) {
        return problem(fmt::format("{} pixels per degree: expected 1 to 1000", options.pixelsPerDegree));
    }
    return {};
}

double relativeTo(double bias, double reference) {
    if (bias == 0.0) { return 0.0; }
    return reference != 0.0 ? bias / reference : std::copysign(std::numeric_limits<double>::infinity(), bias);
}

/// Only epsilon would be left of the denominators.
void giveUpRelativeErrors(ImageMetrics* metrics) {
    for (double* error : {&metrics->relMse, &metrics->relMseTrimmed, &metrics->mape}) {
        if (*error > 0.0) { *error = std::numeric_limits<double>::infinity(); }
    }
}

}  // namespace

double ImageMetrics::relativeRmse() const { return std::sqrt(relMse); }

Result<ImageMetrics> compareImages(const ImageF& test, const ImageF& reference,
                                   const MetricOptions& options) {
    if (const Status valid = checkInputs(test, reference, options); !valid) { return valid.error(); }
    const size_t count = static_cast<size_t>(test.width) * static_cast<size_t>(test.height);
    Comparison comparison{.test = test,
                          .reference = reference,
                          .epsilon = options.relativeEpsilon,
                          .finite = std::vector<uint8_t>(count),
                          .typicalLuminance = typicalLuminanceOf(test, reference),
                          .relativeError = std::vector<double>(count),
                          .wrongShare = std::vector<double>(count)};
    const Sums sums = sumAll(&comparison, options.threads);
    if (sums.pixels == 0) {
        return problem(
            fmt::format("no pixel is finite in both pictures: {} are not in the first, {} in the reference",
                        sums.testNonFinite, sums.referenceNonFinite));
    }
    const double pixels = static_cast<double>(sums.pixels);
    const double values = 3.0 * pixels;
    ImageMetrics metrics{.mse = sums.squared / values,
                         .relMse = sums.relative / pixels,
                         .mape = sums.absoluteRelative / values,
                         .bias = sums.signedError / values,
                         .maxError = sums.largest,
                         .comparedPixels = sums.pixels,
                         .testNonFinite = sums.testNonFinite,
                         .referenceNonFinite = sums.referenceNonFinite};
    metrics.rmse = std::sqrt(metrics.mse);
    metrics.relativeBias = relativeTo(metrics.bias, sums.reference / values);
    metrics.maxErrorX = static_cast<int>(sums.largestAt % static_cast<size_t>(test.width));
    metrics.maxErrorY = static_cast<int>(sums.largestAt / static_cast<size_t>(test.width));
    metrics.trimmedPixels = static_cast<uint64_t>(options.trimmedShare * pixels);
    const auto kept = static_cast<double>(sums.pixels - metrics.trimmedPixels);
    metrics.relMseTrimmed = sumOfSmallest(comparison.finite, comparison.relativeError, kept) / kept;
    addPictureError(comparison, &metrics);
    if (sums.reference == 0.0) { giveUpRelativeErrors(&metrics); }
    addViewerMetrics(comparison, options, &metrics);
    return metrics;
}

}  // namespace glint
