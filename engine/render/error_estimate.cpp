// Sums over the pixels in chunks of fixed size, joined in order, so that no bit depends on the threads.
#include "engine/render/error_estimate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/base/parallel.h"
#include "engine/math/color.h"
#include "engine/math/inverse_erf.h"
#include "engine/render/error_sums.h"
#include "engine/render/film.h"
#include "engine/render/image_statistics.h"
#include "engine/render/picture_error.h"
#include "engine/render/pixel_errors.h"

namespace glint {
namespace {

constexpr int64_t kPixelsPerSum = 65536;
/// Standard deviation of the logarithm of the mean squared error from what is assumed of stratification (how
/// it goes on between powers of two), for one doubling of passes and so much less for many; the same before
/// there is a calibration; and of a picture that is all bias, whose estimate misses what edges cut off.
constexpr double kModelSpread = 0.6;
constexpr double kUncalibratedSpread = 1.2;
constexpr double kBiasSpread = 0.5;
/// The same of what is not known of the truth's brightness where errors are relative to it: measured over
/// boxes, glass, environments and caustics (tests/stat/error_estimate_test.cpp).
constexpr double kScaleSpread = 0.25;

/// Sums over the pixels of a part of the film: `add(&sums, index)` for each.
template <class Sums, class Add>
Sums sumPixels(const Film& film, int threads, const FilmRegion& part, Add add) {
    const auto pixels = static_cast<int64_t>(film.pixels().size());
    std::vector<Sums> partial(static_cast<size_t>((pixels + kPixelsPerSum - 1) / kPixelsPerSum));
    parallelChunks(pixels, kPixelsPerSum, threads, [&](int64_t begin, int64_t end) {
        Sums& sums = partial[static_cast<size_t>(begin / kPixelsPerSum)];
        for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
            if (part.contains(static_cast<int>(i) % film.width(), static_cast<int>(i) / film.width())) {
                add(&sums, i);
            }
        }
    });
    for (size_t i = 1; i < partial.size(); ++i) {
        partial[0].add(partial[i]);
    }
    return std::move(partial[0]);
}

/// Standard deviation of the logarithm of the mean squared error about its estimate: of the error itself, of
/// the variances that were measured, and of the bias.
double logSpread(const Film& film, const TrimmedErrors& total, double scaleSpread) {
    const NoiseCalibration& calibration = film.calibration();
    const bool isCalibrated = calibration.passes >= 4;
    const double passes = film.passes();
    const double ofVariances = 2.0 * total.varianceSquared / (passes - 1.0);
    const double ofCalibration = isCalibrated ? 2.0 * total.calibratedSquared : 0.0;
    // b^2 of a normal b with variance 3v: 2 (3v)^2 + 4 B^2 3v, and 4 B^2 v of the product of error and bias.
    const double ofBias = 18.0 * total.photonSquared + 16.0 * std::max(0.0, total.biasTimesPhotons);
    const double sampling = calibration.correlatedPixels *
                            (total.noiseVariance + ofVariances + ofCalibration + ofBias) /
                            square(total.squaredError());
    const double model = isCalibrated ? kModelSpread / std::log2(passes) : kUncalibratedSpread;
    const double biasModel = kBiasSpread * total.bias / total.squaredError();
    return std::sqrt(sampling + square(model) + square(biasModel) + square(scaleSpread));
}

struct Luminances {
    double sum = 0.0;
    void add(const Luminances& other) { sum += other.sum; }
};

FilmRegion wholeOf(const Film& film) { return {0, 0, film.width(), film.height()}; }

bool isTooEarly(const Film& film, const ImageStatistics* statistics) {
    return film.passes() < 2 || film.pixels().empty() || (statistics && statistics->passCount() < 2);
}

ErrorEstimate estimateOf(const Film& film, const TrimmedErrors& total, double pixels, double scaleSpread) {
    if (!(total.squaredError() > 0.0)) { return {.relative = 0.0, .low = 0.0, .high = 0.0}; }
    ErrorEstimate estimate;
    estimate.relative = std::sqrt(total.squaredError() / pixels);
    estimate.bias = std::sqrt(total.bias / pixels);
    const double half = 0.5 * kNormal95 * logSpread(film, total, scaleSpread);
    estimate.low = estimate.relative * std::exp(-half);
    estimate.high = estimate.relative * std::exp(half);
    return estimate;
}

/// What a normal error with mean `bias` and standard deviation `sigma` stays within with 90 %: solved by
/// Newton's method on P(x) = Phi((x - bias) / sigma) - Phi((-x - bias) / sigma).
double boundOf(double bias, double sigma) {
    if (!(sigma > 0.0)) { return bias; }
    const double b = bias / sigma;
    const auto phi = [](double z) { return 0.5 * std::erfc(-z * 0.70710678118654752); };
    const auto density = [](double z) { return 0.3989422804014327 * std::exp(-0.5 * z * z); };
    double x = b + kNormal95;  // Beyond the root, where P is concave: Newton comes down without overshooting.
    for (int step = 0; step < 4; ++step) {
        const double excess = phi(x - b) - phi(-x - b) - 0.9;
        x -= excess / (density(x - b) + density(-x - b));
    }
    return x * sigma;
}

/// Means over squares of pixels, cut off at the picture's edge.
std::vector<float> blurred(const std::vector<float>& values, int width, int height, int threads) {
    constexpr int kHalf = 2;
    std::vector<float> out(values.size());
    parallelChunks(height, 16, threads, [&](int64_t begin, int64_t end) {
        for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
            for (int x = 0; x < width; ++x) {
                double sum = 0.0;
                int count = 0;
                for (int v = std::max(0, y - kHalf); v <= std::min(height - 1, y + kHalf); ++v) {
                    for (int u = std::max(0, x - kHalf); u <= std::min(width - 1, x + kHalf); ++u) {
                        sum += static_cast<double>(values[static_cast<size_t>(v) * width + u]);
                        ++count;
                    }
                }
                out[static_cast<size_t>(y) * width + x] = static_cast<float>(sum / count);
            }
        }
    });
    return out;
}

}  // namespace

ErrorEstimate estimateError(const Film& film, const ImageStatistics* statistics, int threads,
                            const FilmRegion* region) {
    statistics = statistics && statistics->passCount() > 0 ? statistics : nullptr;
    if (isTooEarly(film, statistics)) { return {}; }
    const FilmRegion part = region != nullptr ? *region : wholeOf(film);
    const PixelErrors errors(film, statistics, threads, part);
    const auto typical = sumPixels<TypicalLuminance>(
        film, threads, part, [&](TypicalLuminance* sums, size_t i) { sums->add(errors.luminance(i)); });
    const double typicalLuminance = typical.value();
    const auto sums = sumPixels<ErrorSums>(film, threads, part, [&](ErrorSums* out, size_t i) {
        const PixelErrors::Around around = errors.around(i);
        out->add(errors.error(i), around.error, errorScaleSquared(around.luminance, typicalLuminance));
    });
    const auto pixels = static_cast<double>(part.pixels());
    const TrimmedErrors total = withoutWorst(sums, kTrimmedShare * pixels, kWhollyWrong);
    ErrorEstimate estimate = estimateOf(film, total, (1.0 - kTrimmedShare) * pixels, kScaleSpread);
    estimate.whollyWrong = total.pixelsCapped / pixels;
    estimate.high = std::min(estimate.high, kWhollyWrong);
    return estimate;
}

ErrorEstimate estimateRmseOverMean(const Film& film, const ImageStatistics* statistics, int threads) {
    statistics = statistics && statistics->passCount() > 0 ? statistics : nullptr;
    if (isTooEarly(film, statistics)) { return {}; }
    const FilmRegion part = wholeOf(film);
    const auto pixels = static_cast<double>(part.pixels());
    const double mean = sumPixels<Luminances>(film, threads, part,
                                              [&](Luminances* sums, size_t i) {
                                                  sums->sum += pixelLuminance(film, statistics, i);
                                              })
                            .sum /
                        pixels;
    const auto sums = sumPixels<ErrorSums>(film, threads, part, [&](ErrorSums* out, size_t i) {
        const PixelError error = pixelError(film, statistics, i);
        out->add(error, error, square(mean));
    });
    constexpr double kNoCap = std::numeric_limits<double>::infinity();
    return estimateOf(film, withoutWorst(sums, kTrimmedShare * pixels, kNoCap),
                      (1.0 - kTrimmedShare) * pixels, 0.0);
}

PixelError pixelError(const Film& film, const ImageStatistics* statistics, size_t index) {
    PixelError error;
    const FilmPixel& pixel = film.pixels()[index];
    if (pixel.count > 1) {
        const double n = pixel.count;
        error.variance = std::max(0.0, pixel.luminanceM2) / ((n - 1.0) * n);
    } else if (!statistics) {
        error.variance = std::numeric_limits<double>::infinity();
    }
    if (statistics) {
        error.photonVariance = square(statistics->standardErrorOf(index));
        error.variance += error.photonVariance;
        error.bias = statistics->biasOf(index);
    }
    const uint32_t samples = statistics ? film.passes() : pixel.count;
    error.variance *= film.calibration().factorOf(error.variance * samples);
    return error;
}

std::vector<float> errorBounds(const Film& film, const ImageStatistics* statistics, int threads) {
    statistics = statistics && statistics->passCount() > 0 ? statistics : nullptr;
    const size_t pixels = film.pixels().size();
    std::vector<float> variance(pixels), photonVariance(statistics ? pixels : 0),
        biasSquared(statistics ? pixels : 0);
    for (size_t i = 0; i < pixels; ++i) {
        const PixelError error = pixelError(film, statistics, i);
        variance[i] = static_cast<float>(error.variance);
        if (statistics) {
            photonVariance[i] = static_cast<float>(error.photonVariance);
            biasSquared[i] = static_cast<float>(square(error.bias) - 3.0 * error.photonVariance);
        }
    }
    const auto smooth = [&](const std::vector<float>& values) {
        return values.empty() ? values : blurred(values, film.width(), film.height(), threads);
    };
    const std::vector<float> variances = smooth(variance);
    const std::vector<float> photonVariances = smooth(photonVariance);
    const std::vector<float> biasesSquared = smooth(biasSquared);
    std::vector<float> bounds(pixels);
    for (size_t i = 0; i < pixels; ++i) {
        double bias = 0.0;
        double total = static_cast<double>(variances[i]);
        if (statistics) {
            // The bias' estimate is noisy: it counts as far as the neighbourhood's biases stand out of that
            // noise (the mean and variance of a normal prior's posterior).
            const double prior = std::max(0.0, static_cast<double>(biasesSquared[i]));
            const double noise = 3.0 * static_cast<double>(photonVariances[i]);
            const double trust = prior > 0.0 ? prior / (prior + noise) : 0.0;
            const double own = trust * std::abs(statistics->biasOf(i));
            bias = kHigherOrders * std::max(own, std::sqrt(prior));
            total += trust * noise;
        }
        bounds[i] = static_cast<float>(std::isfinite(total) ? boundOf(bias, std::sqrt(total)) : total);
    }
    return bounds;
}

double pixelLuminance(const Film& film, const ImageStatistics* statistics, size_t index) {
    const std::array<double, 3>& mean = film.pixels()[index].mean;
    double sum = 0.2126 * mean[0] + 0.7152 * mean[1] + 0.0722 * mean[2];
    if (statistics) { sum += static_cast<double>(luminance(statistics->radianceOf(index))); }
    return sum;
}

}  // namespace glint
