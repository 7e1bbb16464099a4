// Numbers as people read them, with units: for panels and the status line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace glint {

/// 3 significant digits and k, M, G: "1.02 M", "384", "0.52". `unit` follows: "1.02 M rays/s".
std::string withPrefix(double value, const char* unit);
/// "8.4 s", "2:05 min", "1:12:40 h".
std::string duration(double seconds);
/// "1.25 %"; "–" when it is not known yet.
std::string percent(double fraction);
/// "2.60 % ± 0.31": half of the band from `low` to `high` beside it, where that is known.
std::string percentWithin(double fraction, double low, double high);
/// "1 234 567".
std::string grouped(uint64_t value);
/// "3.2 ms", "1.40 s".
std::string latency(double seconds);

/// 0.0123 → "12.3 mm".
std::string length(double metres);

/// What people type for a number: "2.8", "2,8" (a decimal comma), "f/2.8", "1e-3", with blanks around it.
/// Nothing for other texts and for what has no place in a float.
std::optional<double> parseNumber(std::string_view text);

/// "pt" → "PT". Letters of ASCII only.
std::string inCapitals(std::string_view text);
/// "1 pass", "12 345 passes".
std::string passCount(uint32_t passes);

}  // namespace glint
