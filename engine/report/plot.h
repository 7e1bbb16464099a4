// A chart of lines on two logarithmic axes: what error against run time is read from.
//
// The model is plain data; it is laid out once (plot.cpp) as a Drawing, which becomes SVG and PNG alike.
// Knows nothing of metrics, scenes or seeds.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/report/drawing.h"
#include "engine/scene/image.h"

namespace glint {

struct ChartPoint {
    double x = 0.0;
    double y = 0.0;
    /// A band around the line, such as the range over seeds. Not drawn where either is NaN; a lower end of 0
    /// or below reaches the axis.
    double low = std::numeric_limits<double>::quiet_NaN();
    double high = std::numeric_limits<double>::quiet_NaN();
    std::string tip = {};  ///< SVG: shown while the pointer rests on the marker
};

/// Colour and marker follow from the place in the chart: seven colours that stay apart with any common colour
/// blindness (Okabe and Ito 2008), each with its own marker; later series repeat them with dashes.
struct ChartSeries {
    std::string name;
    std::vector<ChartPoint> points;  ///< in any order; drawn by rising x
};

/// A dashed horizontal line across the chart, named in the legend: the reference's own error, a target.
struct ChartLevel {
    double y = 0.0;
    std::string label;
};

/// Points whose x or y is zero, negative or not finite have no place on logarithmic axes: they are left out,
/// and a line below the chart says how many. The axes hold all others. A level far below all points is named
/// in the legend, with its value, but does not stretch the axis.
struct LogLogChart {
    std::string title;
    std::string subtitle;  ///< smaller, below the title; empty: none
    std::string xTitle;    ///< with the unit
    std::string yTitle;
    std::string note;  ///< small, below the chart, such as what the band means; empty: none
    std::vector<ChartSeries> series;
    std::vector<ChartLevel> levels;
    /// units (drawing.h), at least kMinChartWidth x kMinChartHeight; a long legend adds height
    int width = 960;
    int height = 600;
};
constexpr int kMinChartWidth = 320;
constexpr int kMinChartHeight = 240;

Drawing layOutChart(const LogLogChart& chart);

/// The same drawing as a text and as pixels. An SVG may stand inside an HTML page as it is.
std::string chartSvg(const LogLogChart& chart);
Image8 chartImage(const LogLogChart& chart, double scale = 2.0);

/// By the extension, .svg or .png (at scale 2). Saves atomically. Error: another extension, or the file
/// cannot be written.
Status saveChart(const std::string& path, const LogLogChart& chart);

}  // namespace glint
