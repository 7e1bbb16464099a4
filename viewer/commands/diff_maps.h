// The error maps of `glint diff`: which range each one spans, and their files.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/report/error_maps.h"
#include "viewer/base/run_files.h"

namespace glint {

/// Ranges that were asked for, by ErrorMapKind; what is empty is chosen by readableRange().
using MapRanges = std::array<std::optional<MapRange>, kErrorMapKindCount>;

/// "absolute=0.001:1" or "relative-squared=1e-4:1", logarithmic, or "signed=0.5", which spans -0.5 to 0.5.
/// Error: another kind (FLIP always spans 0 to 1), or numbers that make no range.
Status addMapRange(std::string_view text, MapRanges* ranges);

struct WrittenMap {
    ErrorMapKind kind = ErrorMapKind::RelativeSquared;
    std::string file;
    MapRange range;
};

/// Makes the folder, so that a wrong name is refused before anything is computed. Error also: a map would
/// replace one of `files`.
Status prepareMapFolder(const std::string& folder, RunFiles* files);

/// FOLDER/relative-squared.png, absolute.png, signed.png and flip.png, each with a legend.
Result<std::vector<WrittenMap>> writeMaps(const std::string& folder, const MapRanges& ranges,
                                          const ImageF& test, const ImageF& reference,
                                          const MetricOptions& options);

}  // namespace glint
