// Nearest rank: a percentile is always one of the measurements.
#include "viewer/bench/bench_statistics.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace glint {

Percentiles percentilesOf(std::vector<double> samples) {
    if (samples.empty()) { return {}; }
    std::ranges::sort(samples);
    const auto rank = [&](double share) {
        const auto index = static_cast<size_t>(std::ceil(share * static_cast<double>(samples.size())));
        return samples[std::clamp<size_t>(index, 1, samples.size()) - 1];
    };
    return {samples.size(), rank(0.5), rank(0.95), samples.back()};
}

nlohmann::ordered_json percentilesJson(const Percentiles& s) {
    return {
        {"count", s.count}, {"median_ms", s.median * 1e3}, {"p95_ms", s.p95 * 1e3}, {"max_ms", s.max * 1e3}};
}

std::string percentilesText(const Percentiles& s) {
    return fmt::format("median {:6.2f} ms, 95 % {:6.2f} ms, max {:6.2f} ms ({} samples)", s.median * 1e3,
                       s.p95 * 1e3, s.max * 1e3, s.count);
}

}  // namespace glint
