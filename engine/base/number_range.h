// A range of numbers and how messages put it.
#pragma once

#include <limits>
#include <string>
#include <string_view>

namespace glint {

/// The numbers that something takes; `expected` completes "expected …" for anything but integers.
struct NumberRange {
    double lo = -static_cast<double>(std::numeric_limits<float>::max());
    double hi = static_cast<double>(std::numeric_limits<float>::max());
    bool openLo = false;  ///< lo itself is outside
    bool openHi = false;
    std::string_view expected = "a finite number";

    constexpr bool contains(double x) const {
        return (openLo ? x > lo : x >= lo) && (openHi ? x < hi : x <= hi);
    }
    /// "a whole number from 0 to 64": what to expect of an integer.
    std::string wholeNumbers() const;
};

constexpr NumberRange kAnyNumber{};
constexpr NumberRange kPositive{.lo = 0.0, .openLo = true, .expected = "a number > 0"};
constexpr NumberRange kNotNegative{.lo = 0.0, .expected = "a number >= 0"};
constexpr NumberRange kUnitInterval{.lo = 0.0, .hi = 1.0, .expected = "a number from 0 to 1"};

}  // namespace glint
