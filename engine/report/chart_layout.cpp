// Axes follow from the data; the frame takes the room that titles, tick labels, legend and notes leave.
#include "engine/report/chart_layout.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace glint {
namespace {

constexpr double kLegendShare = 0.36;  ///< of the chart's width, at most
constexpr double kMostHeight = 8000.0;
constexpr double kXLabelSpacing = 52.0, kYLabelSpacing = 24.0;

bool canShow(double value) { return std::isfinite(value) && value > 0.0; }

std::vector<ChartPoint> shownPoints(const ChartSeries& series) {
    std::vector<ChartPoint> shown;
    for (const ChartPoint& point : series.points) {
        if (canShow(point.x) && canShow(point.y)) { shown.push_back(point); }
    }
    std::ranges::stable_sort(shown, {}, &ChartPoint::x);
    return shown;
}

/// What the y axis must hold, given the range of the lines themselves.
AxisExtent heightOf(const ChartLayout& layout, const LogLogChart& chart, const AxisExtent& lines) {
    AxisExtent y = lines;
    for (const auto& points : layout.shown) {
        for (const ChartPoint& point : points) {
            if (hasBand(point)) {
                // A band that reaches to nearly zero must not flatten the lines.
                y.include(std::max(point.low, 0.1 * lines.smallest));
                y.include(point.high);
            }
        }
    }
    for (const ChartLevel& level : chart.levels) {
        if (canShow(level.y) && level.y >= 0.01 * lines.smallest && level.y <= 10.0 * lines.largest) {
            y.include(0.8 * level.y);  // off the frame, where it could not be seen
            y.include(level.y);
        }
    }
    return y;
}

void findAxes(const LogLogChart& chart, ChartLayout* layout) {
    AxisExtent x, y;
    for (const auto& points : layout->shown) {
        for (const ChartPoint& point : points) {
            x.include(point.x);
            y.include(point.y);
        }
    }
    layout->empty = x.largest == 0.0;
    if (!layout->empty) {
        const AxisExtent height = heightOf(*layout, chart, y);
        layout->xAxis = axisOver(x.smallest, x.largest);
        layout->yAxis = axisOver(height.smallest, height.largest);
    }
}

std::string levelText(const ChartLayout& layout, const ChartLevel& level) {
    std::string text = fmt::format("{}: {:.2g}", cleanText(level.label), level.y);
    if (layout.empty || !canShow(level.y) || layout.shows(level)) { return text; }
    return text + (layout.yAxis.share(level.y) < 0.0 ? " (below)" : " (above)");
}

std::vector<std::string> legendTexts(const ChartLayout& layout, const LogLogChart& chart) {
    std::vector<std::string> texts;
    for (const ChartSeries& series : chart.series) {
        texts.push_back(cleanText(series.name));
    }
    for (const ChartLevel& level : chart.levels) {
        texts.push_back(levelText(layout, level));
    }
    return texts;
}

double legendWidth(const ChartLayout& layout) {
    double widest = 0.0;
    for (const std::string& text : layout.legend) {
        widest = std::max(widest, textWidth(text, kChartTextSize));
    }
    return layout.legend.empty() ? 0.0
                                 : std::min(kLegendKey + widest + kChartMargin, kLegendShare * layout.width);
}

std::vector<std::string> notesOf(const ChartLayout& layout, const LogLogChart& chart) {
    std::vector<std::string> notes;
    if (!chart.note.empty()) { notes.push_back(cleanText(chart.note)); }
    std::string missing;
    for (size_t i = 0; i < chart.series.size(); ++i) {
        if (const size_t left = chart.series[i].points.size() - layout.shown[i].size(); left > 0) {
            missing += fmt::format("{}{} of {}", missing.empty() ? "" : ", ", left, layout.legend[i]);
        }
    }
    if (!missing.empty()) { notes.push_back("Not shown, being zero, negative or not finite: " + missing); }
    return notes;
}

void placeFrame(const LogLogChart& chart, ChartLayout* layout) {
    layout->top = kChartMargin + kChartTitleSize + (chart.subtitle.empty() ? 10.0 : 30.0);
    const double below =
        kBelowFrame + kChartMargin - 12.0 + kNoteRow * static_cast<double>(layout->notes.size());
    const double legendHeight = kLegendRow * static_cast<double>(layout->legend.size());
    const double wanted = std::min(layout->top + legendHeight + below, kMostHeight);
    layout->height = std::max(layout->height, static_cast<int>(std::ceil(wanted)));
    layout->bottom = layout->height - below;
    layout->right = layout->width - kChartMargin - legendWidth(*layout);
    layout->left = kChartMargin + kChartTextSize + 14.0;
    if (layout->empty) { return; }
    layout->yTicks = logTicks(layout->yAxis, layout->bottom - layout->top, kYLabelSpacing);
    double widest = 0.0;
    for (const LogTick& tick : layout->yTicks) {
        widest = std::max(widest, tick.labelled ? tickWidth(tickText(tick, layout->yAxis)) : 0.0);
    }
    layout->left += widest;
    layout->xTicks = logTicks(layout->xAxis, layout->right - layout->left, kXLabelSpacing);
}

}  // namespace

double ChartLayout::plotY(double y) const {
    return bottom - std::clamp(yAxis.share(y), 0.0, 1.0) * (bottom - top);
}

double ChartLayout::tickX(const LogTick& tick) const {
    return left + (tick.logValue() - xAxis.low) / xAxis.decades() * (right - left);
}

double ChartLayout::tickY(const LogTick& tick) const {
    return bottom - (tick.logValue() - yAxis.low) / yAxis.decades() * (bottom - top);
}

bool ChartLayout::shows(const ChartLevel& level) const {
    if (empty || !canShow(level.y)) { return false; }
    const double share = yAxis.share(level.y);
    return share >= 0.0 && share <= 1.0;
}

bool hasBand(const ChartPoint& point) { return std::isfinite(point.low) && canShow(point.high); }

double tickWidth(const LogTickText& text) {
    return textWidth(text.base, kChartTickSize) + textWidth(text.exponent, kChartExponentSize);
}

ChartLayout layOut(const LogLogChart& chart) {
    ChartLayout layout;
    layout.width = std::max(chart.width, kMinChartWidth);
    layout.height = std::max(chart.height, kMinChartHeight);
    for (const ChartSeries& series : chart.series) {
        layout.shown.push_back(shownPoints(series));
    }
    findAxes(chart, &layout);
    layout.legend = legendTexts(layout, chart);
    layout.notes = notesOf(layout, chart);
    placeFrame(chart, &layout);
    return layout;
}

}  // namespace glint
