#include "viewer/base/number_format.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/printf.h>

#include "viewer/base/quantity.h"

namespace glint {
namespace {

constexpr float kRounding = 1e-5f;  // of the numbers beside it
constexpr int kDefaultDecimals = 6;
constexpr int kMostDigits = 6;
constexpr int kFewestDigits = 3;

/// "× %+.3f m" in parts: "× %+", 3, " m".
struct Parts {
    std::string_view before;
    int decimals = kDefaultDecimals;
    std::string_view after;

    std::string withDigits(int digits) const { return fmt::format("{}.{}g{}", before, digits, after); }
};

Parts partsOf(std::string_view format, size_t percent, size_t conversion) {
    Parts parts;
    const size_t point = std::min(format.find('.', percent), conversion);
    if (point < conversion) {
        parts.decimals = 0;
        for (const char digit : format.substr(point + 1, conversion - point - 1)) {
            parts.decimals = parts.decimals * 10 + (digit - '0');
        }
    }
    parts.before = format.substr(0, point);
    parts.after = format.substr(conversion + 1);
    return parts;
}

}  // namespace

std::string formatThatShows(std::string_view format, float value, float neighbours,
                            const std::function<bool(const char* text)>& fits) {
    std::string shown(format);
    const size_t percent = format.find('%');
    const size_t conversion = percent == std::string_view::npos ? percent : format.find('f', percent);
    if (conversion == std::string_view::npos) { return shown; }
    const Parts parts = partsOf(format, percent, conversion);
    const float size = std::abs(value);
    const float shownFrom = 9.95f * std::pow(10.0f, static_cast<float>(-parts.decimals));
    const bool isNothing = size <= kRounding * neighbours || unitOfFormat(format) == "°";
    if (size < shownFrom && !isNothing) { return parts.withDigits(2); }
    const auto isTooWide = [&] { return !fits(fmt::sprintf(shown, static_cast<double>(value)).c_str()); };
    for (int digits = kMostDigits; digits >= kFewestDigits && isTooWide(); --digits) {
        shown = parts.withDigits(digits);
    }
    return shown;
}

}  // namespace glint
