#include "viewer/commands/diff_maps.h"

#include <charconv>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/io/image_io.h"
#include "engine/report/map_legend.h"

namespace glint {
namespace {

constexpr std::array<std::string_view, 3> kRangedMaps{"relative-squared", "absolute", "signed"};

std::string mapFile(const std::string& folder, ErrorMapKind kind) {
    return (std::filesystem::path(folder) / fmt::format("{}.png", errorMapName(kind))).string();
}

bool readNumber(std::string_view text, double* value) {
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), *value);
    return problem == std::errc() && end == text.data() + text.size() && std::isfinite(*value);
}

std::optional<MapRange> rangeOf(ErrorMapKind kind, std::string_view text) {
    if (kind == ErrorMapKind::Signed) {
        double limit = 0.0;
        const bool valid = readNumber(text, &limit) && limit > 0.0;
        return valid ? std::optional(MapRange{.low = -limit, .high = limit, .logarithmic = false})
                     : std::nullopt;
    }
    const size_t colon = text.find(':');
    MapRange range{.logarithmic = true};
    const bool valid = colon != std::string_view::npos && readNumber(text.substr(0, colon), &range.low) &&
                       readNumber(text.substr(colon + 1), &range.high) && range.low > 0.0 &&
                       range.high > range.low;
    return valid ? std::optional(range) : std::nullopt;
}

}  // namespace

Status addMapRange(std::string_view text, MapRanges* ranges) {
    const std::string_view name = text.substr(0, text.find('='));
    for (int i = 0; i < kErrorMapKindCount; ++i) {
        const auto kind = static_cast<ErrorMapKind>(i);
        if (name != errorMapName(kind) || kind == ErrorMapKind::Flip) { continue; }
        std::optional<MapRange>& range = (*ranges)[static_cast<size_t>(i)];
        range = rangeOf(kind, text.size() > name.size() ? text.substr(name.size() + 1) : std::string_view());
        return range ? Status()
                     : Error{fmt::format("'{}' is no range; expected {}", text,
                                         kind == ErrorMapKind::Signed
                                             ? "signed=LIMIT above 0"
                                             : fmt::format("{}=LOW:HIGH with 0 < LOW < HIGH", name)),
                             {}};
    }
    return Error{fmt::format("'{}': there is no map '{}' with a range{}; expected one of {}", text, name,
                             didYouMean(name, kRangedMaps), fmt::join(kRangedMaps, ", ")),
                 {}};
}

Status prepareMapFolder(const std::string& folder, RunFiles* files) {
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);
    if (problem) {
        return Error{fmt::format("--maps {}: cannot make that folder: {}", folder, problem.message()), {}};
    }
    for (int i = 0; i < kErrorMapKindCount; ++i) {
        Status free = files->writes(mapFile(folder, static_cast<ErrorMapKind>(i)));
        if (!free) { return free; }
    }
    return {};
}

Result<std::vector<WrittenMap>> writeMaps(const std::string& folder, const MapRanges& ranges,
                                          const ImageF& test, const ImageF& reference,
                                          const MetricOptions& options) {
    std::vector<WrittenMap> written;
    for (int i = 0; i < kErrorMapKindCount; ++i) {
        const auto kind = static_cast<ErrorMapKind>(i);
        const Result<ErrorMap> map = errorMap(kind, test, reference, options);
        if (!map) { return map.error(); }
        const std::optional<MapRange>& wanted = ranges[static_cast<size_t>(i)];
        written.push_back({kind, mapFile(folder, kind), wanted ? *wanted : readableRange(*map)});
        if (const Status saved = savePng(written.back().file, mapWithLegend(*map, written.back().range));
            !saved) {
            return saved.error();
        }
    }
    return written;
}

}  // namespace glint
