#include "engine/report/convergence_schedule.h"

#include <algorithm>
#include <cmath>

namespace glint {

std::optional<double> SecondsSchedule::next(double firstPass, double now) const {
    if (now >= seconds_) {
        return std::nullopt;
    }
    // `now` has overshot its stop by up to a pass: the next one is the first beyond it.
    for (int i = 1; i < points_ - 1; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(points_ - 1);
        const double stop = firstPass * std::pow(seconds_ / firstPass, share);
        if (stop > now) {
            return stop;
        }
    }
    return seconds_;
}

std::vector<uint32_t> spacedPasses(uint32_t passes, int points) {
    std::vector<uint32_t> counts{1};
    for (int i = 1; i < points; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(points - 1);
        const auto count = static_cast<uint32_t>(std::lround(std::pow(static_cast<double>(passes), share)));
        if (count > counts.back()) {
            counts.push_back(std::min(count, passes));
        }
    }
    return counts;
}

}  // namespace glint
