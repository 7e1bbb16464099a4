// The interval: Conover 1999, "Practical Nonparametric Statistics", section 3.2 (quantiles by
// order statistics).
#include "viewer/bench/bench_pairs.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "viewer/bench/bench_statistics.h"

namespace glint {
namespace {

constexpr double kConfidence = 0.95;

/// P(X < k) for X binomial with n trials of chance one half.
double binomialBelow(size_t n, size_t k) {
    double probability = std::exp2(-static_cast<double>(n));
    double sum = 0.0;
    for (size_t i = 0; i < k; ++i) {
        sum += probability;
        probability *= static_cast<double>(n - i) / static_cast<double>(i + 1);
    }
    return sum;
}

bool samePixel(const FilmPixel& a, const FilmPixel& b) {
    return a.mean == b.mean && a.luminanceM2 == b.luminanceM2 && a.count == b.count;
}

bool samePixel(const SppmPixel& a, const SppmPixel& b) {
    return a.radiusSquared == b.radiusSquared && a.photonCount == b.photonCount &&
           std::ranges::equal(a.flux, b.flux) && a.bias == b.bias && a.passM2 == b.passM2;
}

double channelOf(const Film& film, const SppmState& sppm, size_t pixel, int channel) {
    const double photons = sppm.passes > 0 ? static_cast<double>(sppm.radianceOf(pixel)[channel]) : 0.0;
    return film.pixels()[pixel].mean[static_cast<size_t>(channel)] + photons;
}

}  // namespace

PairTimes measureByTurns(int turns, const std::function<double(uint32_t turn)>& first,
                         const std::function<double(uint32_t turn)>& second) {
    PairTimes times;
    for (uint32_t turn = 0; turn <= static_cast<uint32_t>(turns); ++turn) {
        double a = 0.0, b = 0.0;
        if (turn % 2 == 0) {
            a = first(turn);
            b = second(turn);
        } else {
            b = second(turn);
            a = first(turn);
        }
        if (turn > 0) {
            times.first.push_back(a);
            times.second.push_back(b);
        }
    }
    return times;
}

RatioInterval ratioOf(const std::vector<double>& numerators, const std::vector<double>& denominators) {
    std::vector<double> ratios;
    for (size_t i = 0; i < std::min(numerators.size(), denominators.size()); ++i) {
        ratios.push_back(numerators[i] / denominators[i]);
    }
    if (ratios.empty()) { return {}; }
    std::ranges::sort(ratios);
    const size_t n = ratios.size();
    size_t rank = 1;
    while (2 * (rank + 1) <= n && 1.0 - 2.0 * binomialBelow(n, rank + 1) >= kConfidence) {
        ++rank;
    }
    const double middle = n % 2 == 1 ? ratios[n / 2] : 0.5 * (ratios[n / 2 - 1] + ratios[n / 2]);
    return {middle, ratios[rank - 1], ratios[n - rank], 1.0 - 2.0 * binomialBelow(n, rank)};
}

std::string ratioText(const RatioInterval& r) {
    return fmt::format("{:.3f} [{:.3f}, {:.3f}]", r.median, r.low, r.high);
}

nlohmann::ordered_json ratioJson(const RatioInterval& r) {
    return {{"median", r.median}, {"low", r.low}, {"high", r.high}, {"confidence", r.confidence}};
}

ImageDifference compareImages(const Film& first, const Film& second, const SppmState& firstSppm,
                              const SppmState& secondSppm) {
    ImageDifference result;
    result.pixels = first.pixels().size();
    double sum = 0.0;
    for (size_t i = 0; i < result.pixels; ++i) {
        const bool same = samePixel(first.pixels()[i], second.pixels()[i]) &&
                          (firstSppm.passes == 0 || samePixel(firstSppm.pixels[i], secondSppm.pixels[i]));
        result.different += same ? 0 : 1;
        for (int channel = 0; channel < 3; ++channel) {
            const double a = channelOf(first, firstSppm, i, channel);
            sum += a;
            result.largest =
                std::max(result.largest, std::fabs(a - channelOf(second, secondSppm, i, channel)));
        }
    }
    if (sum > 0.0) { result.largest *= 3.0 * static_cast<double>(result.pixels) / sum; }
    return result;
}

std::string differenceText(const ImageDifference& d) {
    return d.identical() ? "identical"
                         : fmt::format("{} of {} pixels differ, by up to {:.2g} of the mean", d.different,
                                       d.pixels, d.largest);
}

}  // namespace glint
