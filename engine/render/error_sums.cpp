// The cut is a level of squared error: above it there are as many errors as are left out, on average.
#include "engine/render/error_sums.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/math/vec.h"

namespace glint {
namespace {

/// Of z^2 for a standard normal z: the chance to be at most t, its mean and its square's mean up to there.
/// With F_k the chi-square distribution of k degrees of freedom, these are F_1, F_3 and 3 F_5.
struct CutSquare {
    double chance = 1.0, mean = 1.0, square = 3.0;

    explicit CutSquare(double t) {
        if (!(t < 100.0)) { return; }
        const double density = std::exp(-0.5 * t);
        chance = std::erf(std::sqrt(0.5 * t));
        // Not below 0: for a tiny t both are differences of nearly equal numbers.
        mean = std::max(0.0, chance - std::sqrt(t / 1.5707963267948966) * density);
        square = std::max(0.0, 3.0 * mean - t * std::sqrt(t / 1.5707963267948966) * density);
    }
};

/// The pixels of a bin as if all were alike.
struct BinError {
    double pixels, variance, bias;

    explicit BinError(const ErrorBin& bin)
        : pixels(static_cast<double>(bin.pixels)),
          variance(bin.noise / pixels),
          bias(std::max(0.0, bin.bias / pixels)) {}

    /// Up to where z^2 may go for the squared error to stay below `cut`.
    CutSquare below(double cut) const {
        return CutSquare(variance > 0.0 ? std::max(0.0, cut - bias) / variance : cut >= bias ? 1e30 : 0.0);
    }
};

struct Cut {
    double level = 0.0;
    double pixelsAbove = 0.0;  ///< expected
};

double pixelsAbove(const ErrorSums& sums, double level) {
    auto above = static_cast<double>(sums.bins.back().pixels);
    for (size_t i = 0; i + 1 < ErrorSums::kBins; ++i) {
        if (sums.bins[i].pixels > 0) {
            const BinError error(sums.bins[i]);
            above += error.pixels * (1.0 - error.below(level).chance);
        }
    }
    return above;
}

/// The lowest level above which there are no more than `most` squared errors.
Cut cutFor(const ErrorSums& sums, double most) {
    double low = -300.0, high = 300.0;  // of its logarithm
    for (int step = 0; step < 50; ++step) {
        const double middle = 0.5 * (low + high);
        (pixelsAbove(sums, std::exp(middle)) > most ? low : high) = middle;
    }
    return {std::exp(high), pixelsAbove(sums, std::exp(high))};
}

}  // namespace

void ErrorSums::add(const PixelError& error, const PixelError& alike, double scaleSquared) {
    if (!std::isfinite(error.variance)) {
        ++bins.back().pixels;
        return;
    }
    const double unit = scaleSquared > 0.0 ? 1.0 / scaleSquared : 0.0;
    const double noise = unit * error.variance;
    const double photons = unit * error.photonVariance;
    const auto biasOf = [&](const PixelError& of) {
        return square(kHigherOrders) * unit * (square(of.bias) - 3.0 * of.photonVariance);
    };
    const double bias = biasOf(error);
    const auto squaredError = static_cast<float>(unit * alike.variance + std::max(0.0, biasOf(alike)));
    ErrorBin& bin = bins[std::bit_cast<uint32_t>(squaredError) >> 23];
    bin.noise += noise;
    bin.noiseSquared += square(noise);
    bin.photonSquared += square(photons);
    bin.bias += bias;
    bin.biasTimesPhotons += bias * photons;
    ++bin.pixels;
}

void ErrorSums::add(const ErrorSums& other) {
    for (size_t i = 0; i < kBins; ++i) {
        bins[i].noise += other.bins[i].noise;
        bins[i].noiseSquared += other.bins[i].noiseSquared;
        bins[i].photonSquared += other.bins[i].photonSquared;
        bins[i].bias += other.bins[i].bias;
        bins[i].biasTimesPhotons += other.bins[i].biasTimesPhotons;
        bins[i].pixels += other.bins[i].pixels;
    }
}

TrimmedErrors withoutWorst(const ErrorSums& sums, double worst, double cap) {
    const Cut free = cutFor(sums, worst);
    const double cut = std::min(free.level, cap);
    TrimmedErrors total;
    total.pixelsCapped = pixelsAbove(sums, cap);
    // Where the cap is the lower one, there are more than `worst` of them, and those are left out of
    // the capped.
    const double above = free.level < cap ? free.pixelsAbove : worst;
    total.capped = free.level < cap ? 0.0 : cap * std::max(0.0, total.pixelsCapped - worst);
    for (size_t i = 0; i + 1 < ErrorSums::kBins; ++i) {
        const ErrorBin& bin = sums.bins[i];
        if (bin.pixels == 0) { continue; }
        const BinError error(bin);
        const CutSquare part = error.below(cut);
        total.noise += bin.noise * part.mean;
        total.bias += bin.bias * part.chance;
        // A trimmed sum scatters like the sum of errors that are brought down to the cut (Huber 1981,
        // section 3.3).
        const double limit = error.variance > 0.0 ? std::max(0.0, cut - error.bias) / error.variance : 0.0;
        const double rest = part.chance < 1.0 ? limit * (1.0 - part.chance) : 0.0;
        const double variance = part.square + limit * rest - square(part.mean + rest);
        total.noiseVariance += bin.noiseSquared * std::max(0.0, variance);
        const double squares = bin.noiseSquared * square(part.mean);
        total.varianceSquared += squares;
        total.calibratedSquared += squares * square(error.pixels / (error.pixels + kClassPriorPixels));
        total.photonSquared += bin.photonSquared * part.chance;
        total.biasTimesPhotons += bin.biasTimesPhotons * part.chance;
    }
    // Biases do not scatter: of those at the cut, a share belongs to the largest errors.
    total.bias = std::max(0.0, total.bias - std::max(0.0, worst - above) * std::min(cut, total.bias));
    return total;
}

}  // namespace glint
