// Where the parts of a chart lie: axes, frame, legend and notes, before anything is drawn.
//
// All texts in it are clean (cleanText()).
#pragma once

#include <string>
#include <vector>

#include "engine/report/log_axis.h"
#include "engine/report/plot.h"

namespace glint {

constexpr double kChartTitleSize = 18.0;
constexpr double kChartTextSize = 13.0;
constexpr double kChartTickSize = 12.0;
constexpr double kChartExponentSize = 9.0;
constexpr double kChartMargin = 16.0;
constexpr double kLegendRow = 21.0;   ///< height
constexpr double kLegendKey = 34.0;   ///< width of the line sample and its gap
constexpr double kNoteRow = 16.0;     ///< height
constexpr double kBelowFrame = 64.0;  ///< from the frame to the first note's baseline

struct ChartLayout {
    int width = 0;
    int height = 0;
    double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;  ///< the frame

    std::vector<std::vector<ChartPoint>> shown;  ///< of each series, those that have a place, by rising x
    bool empty = true;  ///< no point at all: the axes mean nothing, and there are no ticks
    LogAxis xAxis, yAxis;
    std::vector<LogTick> xTicks, yTicks;

    std::vector<std::string> legend;  ///< the series' names, then the levels'
    std::vector<std::string> notes;

    double plotX(double x) const { return left + xAxis.share(x) * (right - left); }
    /// Kept within the frame.
    double plotY(double y) const;
    double tickX(const LogTick& tick) const;
    double tickY(const LogTick& tick) const;
    /// Whether a level has a place within the frame.
    bool shows(const ChartLevel& level) const;
};

/// True when a point has a band that can be drawn.
bool hasBand(const ChartPoint& point);

double tickWidth(const LogTickText& text);

ChartLayout layOut(const LogLogChart& chart);

}  // namespace glint
