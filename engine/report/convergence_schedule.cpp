#include "engine/report/convergence_schedule.h"

#include <algorithm>
#include <cmath>

namespace glint {

std::optional<double> SecondsSchedule::next(double firstPass, double now) const {
    if (now >= seconds_) { return std::nullopt; }
    double next = seconds_;
    // `now` has overshot its stop by up to a pass: the next one is the first beyond it.
    for (int i = 1; i < points_ - 1; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(points_ - 1);
        const double stop = firstPass * std::pow(seconds_ / firstPass, share);
        if (stop > now) {
            next = std::min(next, stop);
            break;
        }
    }
    const auto extra = std::ranges::upper_bound(extra_, now);
    return extra == extra_.end() ? next : std::min(next, *extra);
}

std::vector<uint32_t> spacedPasses(uint32_t passes, int points, const std::vector<double>& extra) {
    std::vector<uint32_t> counts{1};
    for (int i = 1; i < points; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(points - 1);
        const auto count = static_cast<uint32_t>(std::lround(std::pow(static_cast<double>(passes), share)));
        if (count > counts.back()) { counts.push_back(std::min(count, passes)); }
    }
    for (const double moment : extra) {
        counts.push_back(std::clamp(static_cast<uint32_t>(std::lround(moment)), 1u, passes));
    }
    std::ranges::sort(counts);
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    return counts;
}

std::vector<double> decadesOf(double whole, int count) {
    std::vector<double> moments;
    for (int i = 1; i <= count; ++i) {
        moments.push_back(whole * std::pow(10.0, i - count));
    }
    return moments;
}

}  // namespace glint
