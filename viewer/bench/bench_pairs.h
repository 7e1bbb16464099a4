// Two ways of doing the same, measured by turns in one run, so that a machine that slows down slows both:
// what `glint bench threads` and `glint bench variants` have in common.
//
// Ratios are taken turn by turn and reported by their median, with an interval that assumes nothing of how
// times are distributed. Knows nothing of scenes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/render/film.h"
#include "engine/render/sppm_state.h"

namespace glint {

struct PairTimes {
    std::vector<double> first;   ///< seconds, one for each turn
    std::vector<double> second;  ///< of the same turns
};

/// Calls both with the numbers 0 … turns, and throws number 0 away: it warms the caches and starts the
/// threads. Who goes first changes from turn to turn. Each call answers with its seconds.
PairTimes measureByTurns(int turns, const std::function<double(uint32_t turn)>& first,
                         const std::function<double(uint32_t turn)>& second);

struct RatioInterval {
    double median = 0.0;
    double low = 0.0;
    double high = 0.0;
    double confidence = 0.0;  ///< that the true median lies within: at least 0.95 from six turns on
};

/// Of the turns' ratios numerator / denominator. The interval's ends are two of them, chosen by the binomial
/// distribution of how many lie below the median; with fewer than six turns the outermost.
RatioInterval ratioOf(const std::vector<double>& numerators, const std::vector<double>& denominators);

/// "1.312 [1.297, 1.330]".
std::string ratioText(const RatioInterval& ratio);
/// {median, low, high, confidence}.
nlohmann::ordered_json ratioJson(const RatioInterval& ratio);

struct ImageDifference {
    size_t pixels = 0;
    size_t different = 0;  ///< pixels of which any bit of the sums differs
    double largest = 0.0;  ///< greatest difference of a channel, over the first picture's mean channel
    bool identical() const { return different == 0; }
};

/// Of two films of the same size and, where both have passes, of the photons' statistics on top.
ImageDifference compareImages(const Film& first, const Film& second, const SppmState& firstSppm = {},
                              const SppmState& secondSppm = {});

/// "identical" or "12 of 4096 pixels differ, by up to 3.1e-07 of the mean".
std::string differenceText(const ImageDifference& difference);

}  // namespace glint
