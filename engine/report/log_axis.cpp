// Ticks are digits times powers of ten; which of them get a label follows from the gaps between neighbours.
#include "engine/report/log_axis.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace glint {
namespace {

constexpr double kRounding = 1e-9;  ///< of an exponent: 0.001 must count as a power of ten
constexpr double kLeastDecades = 0.5;
constexpr double kLeastGap = 4.0;  ///< units between ticks without labels

const std::array<double, 4> kRoundSteps{0.0, std::log10(2.0), std::log10(5.0), 1.0};

double roundedDown(double exponent) {
    const double decade = std::floor(exponent + kRounding);
    double best = decade;
    for (const double step : kRoundSteps) {
        best = decade + step <= exponent + kRounding ? decade + step : best;
    }
    return best;
}

double roundedUp(double exponent) {
    const double decade = std::floor(exponent + kRounding);
    for (const double step : kRoundSteps) {
        if (decade + step >= exponent - kRounding) { return decade + step; }
    }
    return decade + 1.0;
}

/// Digits that get labels beside 1, given the length of a decade.
std::vector<int> labelledDigits(double decadeLength, double spacing) {
    if (decadeLength * std::log10(10.0 / 9.0) >= spacing) { return {1, 2, 3, 4, 5, 6, 7, 8, 9}; }
    if (decadeLength * std::log10(3.0 / 2.0) >= spacing) { return {1, 2, 3, 5}; }
    if (decadeLength * std::log10(2.0) >= spacing) { return {1, 2, 5}; }
    return {1};
}

/// Decades from one label to the next: 1, 2, 5, 10, ...
int decadeStride(double decadeLength, double spacing) {
    for (int power = 1; power < 1000; power *= 10) {
        for (const int step : {1, 2, 5}) {
            if (decadeLength * power * step >= spacing) { return power * step; }
        }
    }
    return 1000;
}

}  // namespace

double LogAxis::share(double value) const { return (std::log10(value) - low) / (high - low); }

double LogTick::logValue() const { return exponent + std::log10(static_cast<double>(digit)); }

LogAxis axisOver(double smallest, double largest) {
    LogAxis axis{roundedDown(std::log10(smallest)), roundedUp(std::log10(largest))};
    const double missing = kLeastDecades - axis.decades();
    if (missing > 0.0) {
        axis = {roundedDown(axis.low - 0.5 * missing), roundedUp(axis.high + 0.5 * missing)};
    }
    return axis;
}

std::vector<LogTick> logTicks(const LogAxis& axis, double length, double spacing) {
    const double decadeLength = length / axis.decades();
    const std::vector<int> labelled = labelledDigits(decadeLength, spacing);
    const int stride = decadeStride(decadeLength, spacing);
    const bool allDigits = decadeLength * std::log10(10.0 / 9.0) >= kLeastGap;
    const bool allDecades = decadeLength >= kLeastGap;
    std::vector<LogTick> ticks;
    const int last = static_cast<int>(std::floor(axis.high + kRounding));
    for (int exponent = static_cast<int>(std::floor(axis.low + kRounding)); exponent <= last; ++exponent) {
        for (int digit = 1; digit <= 9; ++digit) {
            LogTick tick{.digit = digit, .exponent = exponent};
            tick.labelled = exponent % stride == 0 && std::ranges::find(labelled, digit) != labelled.end();
            const bool drawn = tick.labelled || (digit == 1 ? allDecades : allDigits);
            const double place = tick.logValue();
            if (drawn && place >= axis.low - kRounding && place <= axis.high + kRounding) {
                ticks.push_back(tick);
            }
        }
    }
    return ticks;
}

LogTickText tickText(const LogTick& tick, const LogAxis& axis) {
    if (axis.low >= -4.0 - kRounding && axis.high <= 5.0 + kRounding) {
        const int decimals = std::max(0, -tick.exponent);
        return {.base = fmt::format("{:.{}f}", tick.digit * std::pow(10.0, tick.exponent), decimals),
                .exponent = {}};
    }
    const std::string sign = tick.exponent < 0 ? "\u2212" : "";
    return {.base = tick.digit == 1 ? "10" : fmt::format("{}\u00b710", tick.digit),
            .exponent = sign + std::to_string(std::abs(tick.exponent))};
}

}  // namespace glint
