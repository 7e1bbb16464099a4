#include "viewer/base/units.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace glint {

std::string withPrefix(double value, const char* unit) {
    static constexpr const char* kPrefixes[] = {"", "k", "M", "G", "T"};
    int step = 0;
    while (value >= 999.5 && step < 4) {
        value /= 1000.0;
        ++step;
    }
    const int decimals = value >= 99.95 ? 0 : value >= 9.995 ? 1 : 2;
    return fmt::format("{:.{}f} {}{}{}", value, decimals, kPrefixes[step], step > 0 ? " " : "", unit);
}

std::optional<double> parseNumber(std::string_view text) {
    const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
    while (!text.empty() && isBlank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && isBlank(text.back())) {
        text.remove_suffix(1);
    }
    // An f-number: f/11, f 11, f11.
    if (text.starts_with('f') || text.starts_with('F')) {
        text.remove_prefix(1);
        text.remove_prefix(std::min(text.find_first_not_of(" /"), text.size()));
    }
    if (text.starts_with('+')) { text.remove_prefix(1); }
    std::string digits(text);
    // One comma is a decimal comma; with a point beside it, it could as well part thousands.
    if (std::ranges::count(digits, ',') == 1 && digits.find('.') == std::string::npos) {
        std::ranges::replace(digits, ',', '.');
    }
    double value = 0.0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool isWhole = problem == std::errc() && end == digits.data() + digits.size();
    return isWhole && std::isfinite(static_cast<float>(value)) ? std::optional(value) : std::nullopt;
}

std::string duration(double seconds) {
    if (seconds < 59.95) { return fmt::format("{:.1f} s", seconds); }
    const auto whole = static_cast<uint64_t>(std::lround(seconds));
    if (whole < 3600) { return fmt::format("{}:{:02} min", whole / 60, whole % 60); }
    return fmt::format("{}:{:02}:{:02} h", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string percent(double fraction) {
    if (!std::isfinite(fraction)) { return "–"; }
    const double value = fraction * 100.0;
    const int decimals = value >= 10.0 ? 1 : value >= 0.1 ? 2 : 4;
    return fmt::format("{:.{}f} %", value, decimals);
}

std::string percentWithin(double fraction, double low, double high) {
    const double half = 50.0 * (high - low);
    const bool isKnown = std::isfinite(half) && half > 0.0;
    const int decimals = half >= 9.5 ? 0 : half >= 0.95 ? 1 : half >= 0.095 ? 2 : 4;
    return percent(fraction) + (isKnown ? fmt::format(" ± {:.{}f}", half, decimals) : "");
}

std::string grouped(uint64_t value) {
    std::string digits = std::to_string(value);
    for (size_t place = digits.size(); place > 3;) {
        place -= 3;
        digits.insert(place, " ");
    }
    return digits;
}

std::string latency(double seconds) {
    return seconds < 1.0 ? fmt::format("{:.1f} ms", seconds * 1000.0) : fmt::format("{:.2f} s", seconds);
}

std::string length(double metres) {
    if (metres < 0.9995e-3) { return fmt::format("{:.3g} µm", metres * 1e6); }
    if (metres < 0.9995) { return fmt::format("{:.3g} mm", metres * 1e3); }
    return metres < 999.5 ? fmt::format("{:.3g} m", metres) : fmt::format("{:.3g} km", metres / 1e3);
}

std::string inCapitals(std::string_view text) {
    std::string capitals(text);
    std::ranges::transform(capitals, capitals.begin(), [](unsigned char c) { return std::toupper(c); });
    return capitals;
}

std::string passCount(uint32_t passes) {
    return fmt::format("{} {}", grouped(passes), passes == 1 ? "pass" : "passes");
}

}  // namespace glint
