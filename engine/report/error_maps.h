// Where a picture differs from its reference: one number a pixel, and its false colours.
//
// The numbers are those whose means metrics.h reports. Nothing here saves files; the legend
// is map_legend.h's.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/report/metrics.h"
#include "engine/scene/image.h"

namespace glint {

/// With t, r and epsilon as in ImageMetrics, and means over the 3 channels:
enum class ErrorMapKind : uint8_t {
    RelativeSquared,  ///< mean of (t - r)^2 / (r^2 + epsilon)
    Absolute,         ///< mean of |t - r|, in radiance
    Signed,           ///< mean of t - r, in radiance
    Flip,             ///< LDR-FLIP in [0, 1] at the options' exposure
};
constexpr int kErrorMapKindCount = 4;

/// "relative-squared", "absolute", "signed", "flip".
std::string_view errorMapName(ErrorMapKind kind);

struct ErrorMap {
    ErrorMapKind kind = ErrorMapKind::RelativeSquared;
    int width = 0;
    int height = 0;
    std::vector<float> values;  ///< NaN where a picture is not finite; row 0 at the top
};

/// Error: as compareImages().
Result<ErrorMap> errorMap(ErrorMapKind kind, const ImageF& test, const ImageF& reference,
                          const MetricOptions& options = {});

/// What the colours span. Give several maps one range to compare them.
struct MapRange {
    double low = 0.0;
    double high = 1.0;
    bool logarithmic = false;  ///< by the logarithm's place between low and high, both above 0
};

/// A readable range that holds all but the largest 0.1 % of the pixels (1 % for Signed): four decades below a
/// power of ten for RelativeSquared and Absolute, -v ... v with v of 1, 2 or 5 times a power of ten for
/// Signed, 0 ... 1 for Flip.
MapRange readableRange(const ErrorMap& map);

/// heat_map.h's ramp, and signedColor() for Signed. No error at all is black in both, what lies outside the
/// range takes the colour of its end, and what is not finite is magenta.
Image8 falseColors(const ErrorMap& map, const MapRange& range);

}  // namespace glint
