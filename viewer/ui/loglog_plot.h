// A plot on two logarithmic axes, drawn with ImGui's draw list: curves with bands, a target line, decades, a
// legend, and what the mouse points at.
//
// Knows of curves and texts, not of renders.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/math/vec.h"

namespace glint {

/// A band from low to high where high > low. Points with x or y not positive and finite are left out.
struct PlotPoint {
    double x = 0.0;
    double y = 0.0;
    double low = 0.0;
    double high = 0.0;
};

struct PlotCurve {
    std::string name{};
    Vec3 color{1.0f};         ///< display values
    bool hasMarkers = false;  ///< dots on the points: few and measured, instead of many and estimated
    bool isFaint = false;     ///< behind the others, and not in the legend
    bool isDashed = false;
    std::vector<PlotPoint> points{};  ///< x rising
};

struct LogLogPlot {
    std::vector<PlotCurve> curves{};
    std::optional<double> targetY{};  ///< a dashed line, where it is not far below the curves
    std::string xTitle{};
    std::string yTitle{};
    std::string nothing{};  ///< shown while there is no point to draw
    std::string warning{};  ///< shown below, in place of the horizontal axis' title
};

/// For each curve the point that is nearest to the mouse along x; nothing where the curve does not reach.
using PlotHover = std::vector<std::optional<size_t>>;

/// Draws into the rectangle. Returns what the mouse is over; empty when it is elsewhere.
PlotHover drawLogLogPlot(const LogLogPlot& plot, Vec2 min, Vec2 max);

}  // namespace glint
