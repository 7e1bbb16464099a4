#include "viewer/base/quantity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "viewer/base/units.h"

namespace glint {
namespace {

enum class UnitKind : uint8_t { Share, Length, Angle, Time, Stops, Memory, Own };

struct Unit {
    std::string_view name;
    UnitKind kind;
    double inBase;
};

constexpr std::array<Unit, 25> kUnits{{
    {"", UnitKind::Share, 1.0},           {"%", UnitKind::Share, 0.01},
    {"nm", UnitKind::Length, 1e-9},       {"µm", UnitKind::Length, 1e-6},
    {"um", UnitKind::Length, 1e-6},       {"mm", UnitKind::Length, 1e-3},
    {"cm", UnitKind::Length, 1e-2},       {"m", UnitKind::Length, 1.0},
    {"km", UnitKind::Length, 1e3},        {"in", UnitKind::Length, 0.0254},
    {"ft", UnitKind::Length, 0.3048},     {"°", UnitKind::Angle, 1.0},
    {"deg", UnitKind::Angle, 1.0},        {"rad", UnitKind::Angle, 57.29577951308232},
    {"ms", UnitKind::Time, 1e-3},         {"s", UnitKind::Time, 1.0},
    {"min", UnitKind::Time, 60.0},        {"h", UnitKind::Time, 3600.0},
    {"stops", UnitKind::Stops, 1.0},      {"stop", UnitKind::Stops, 1.0},
    {"EV", UnitKind::Stops, 1.0},         {"KiB", UnitKind::Memory, 1.0 / 1024.0},
    {"MiB", UnitKind::Memory, 1.0},       {"GiB", UnitKind::Memory, 1024.0},
    {"TiB", UnitKind::Memory, 1048576.0},
}};

constexpr bool isBlank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && isBlank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

/// One that the table does not have is a kind of its own.
Unit unitNamed(std::string_view name) {
    const auto found = std::ranges::find(kUnits, name, &Unit::name);
    return found != kUnits.end() ? *found : Unit{name, UnitKind::Own, 1.0};
}

/// "pass" is "passes", too.
bool areAlike(std::string_view a, std::string_view b) {
    const auto [shorter, longer] = std::minmax(a, b, [](auto x, auto y) { return x.size() < y.size(); });
    return longer.starts_with(shorter) && !shorter.empty() &&
           (longer == shorter || longer.substr(shorter.size()) == "s" ||
            longer.substr(shorter.size()) == "es");
}

/// "1/3", "1 1/3" or a plain number.
std::optional<double> parseFraction(std::string_view text) {
    const size_t slash = text.find('/');
    if (text.starts_with('f') || text.starts_with('F') || slash == std::string_view::npos) {
        return parseNumber(text);
    }
    std::string_view numerator = trimmed(text.substr(0, slash));
    const size_t gap = numerator.find_last_of(" \t");
    const auto whole =
        gap == std::string_view::npos ? std::optional(0.0) : parseNumber(numerator.substr(0, gap));
    if (gap != std::string_view::npos) { numerator.remove_prefix(gap + 1); }
    const auto above = parseNumber(numerator), below = parseNumber(text.substr(slash + 1));
    if (!whole || !above || !below || *below == 0.0 || (gap != std::string_view::npos && *above < 0.0)) {
        return std::nullopt;
    }
    return text.starts_with('-') ? *whole - std::abs(*above) / *below : *whole + *above / *below;
}

Error wrongUnit(std::string_view unit, const Unit& field) {
    std::vector<std::string_view> known;
    for (const Unit& each : kUnits) {
        if (each.kind == field.kind && !each.name.empty()) { known.push_back(each.name); }
    }
    if (known.empty()) { known.push_back(field.name); }
    return {fmt::format("has the unit {}, which does not fit here; expected {} or none", unit,
                        fmt::join(known, ", ")),
            {}};
}

}  // namespace

std::string_view unitOfFormat(std::string_view format) {
    const size_t begin = format.find('%');
    const size_t end = begin == std::string_view::npos ? begin : format.find_first_of("dfge", begin);
    if (end == std::string_view::npos) { return ""; }
    const std::string_view unit = trimmed(format.substr(end + 1));
    return unit == "%%" ? unit.substr(1) : unit;
}

Result<double> parseQuantity(std::string_view text, std::string_view fieldUnit) {
    text = trimmed(text);
    const size_t digits = text.find_last_of("0123456789.,");
    const std::string_view number = digits == std::string_view::npos ? text : text.substr(0, digits + 1);
    const std::string_view unit = trimmed(text.substr(number.size()));
    const std::optional<double> value = parseFraction(number);
    if (!value) { return Error{"is no number", {}}; }
    const Unit own = unitNamed(fieldUnit), typed = unitNamed(unit);
    const bool isOwn = unit.empty() || areAlike(unit, fieldUnit);
    if (!isOwn && (typed.kind == UnitKind::Own || typed.kind != own.kind)) { return wrongUnit(unit, own); }
    const double inField = isOwn ? *value : *value * (typed.inBase / own.inBase);
    if (!std::isfinite(static_cast<float>(inField))) { return Error{"is too large", {}}; }
    return inField;
}

}  // namespace glint
