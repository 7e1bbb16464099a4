// One logarithmic axis: what it spans, and where its ticks are.
//
// Works on decimal exponents throughout, so that no range of doubles overflows.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace glint {

/// From 10^low to 10^high; low < high.
struct LogAxis {
    double low = 0.0;
    double high = 1.0;

    double decades() const { return high - low; }
    /// 0 at the low end, 1 at the high one. `value` above 0.
    double share(double value) const;
};

/// What an axis must hold; nothing yet: from infinity to 0.
struct AxisExtent {
    double smallest = std::numeric_limits<double>::infinity();
    double largest = 0.0;

    void include(double value) {
        smallest = std::min(smallest, value);
        largest = std::max(largest, value);
    }
};

/// Rounded outwards to 1, 2 or 5 times a power of ten, half a decade at least. Both values finite and
/// above 0.
LogAxis axisOver(double smallest, double largest);

struct LogTick {
    int digit = 1;  ///< 1 ... 9
    int exponent = 0;
    bool labelled = false;

    double logValue() const;
};

/// Ticks within the axis, by rising value. Labelled are decades (every n-th where they are narrow), with 2
/// and 5, then 3, then all digits where there is room for labels `spacing` units apart on an axis `length`
/// units long. The others are there while they can be told apart.
std::vector<LogTick> logTicks(const LogAxis& axis, double length, double spacing);

/// "0.05", or "5\u00b710" with the exponent "\u22122" apart, to be raised.
struct LogTickText {
    std::string base;
    std::string exponent;  ///< empty for plain numbers
};
/// Plain numbers when the whole axis lies within 0.0001 and 100000, powers otherwise.
LogTickText tickText(const LogTick& tick, const LogAxis& axis);

}  // namespace glint
