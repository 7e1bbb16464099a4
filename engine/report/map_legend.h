// What the colours of an error map mean, written below it.
#pragma once

#include "engine/report/error_maps.h"

namespace glint {

/// Pixels that the legend adds below, and the least width it needs.
constexpr int kLegendHeight = 62;
constexpr int kLegendLeastWidth = 340;

/// The map in false colours, pixel by pixel at the top left, and below it on white paper its name, a bar of
/// its colours with their values, and what black and magenta mean. As wide as the map, or kLegendLeastWidth.
Image8 mapWithLegend(const ErrorMap& map, const MapRange& range);

}  // namespace glint
