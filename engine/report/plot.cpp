// Layout: title above, axis titles and labels around the frame, the legend in a column of its own on the
// right, where it can cover nothing, and notes below.
#include "engine/report/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/image_io.h"
#include "engine/report/log_axis.h"

namespace glint {
namespace {

constexpr double kTitleSize = 18.0, kTextSize = 13.0, kTickSize = 12.0, kExponentSize = 9.0, kNoteSize = 11.5;
constexpr double kMargin = 16.0;
constexpr double kLegendRow = 21.0, kLegendKey = 34.0;
constexpr double kLegendShare = 0.36;  ///< of the width, at most
constexpr size_t kMostMarkers = 40;
constexpr double kMarkerRadius = 4.0;

constexpr Ink kText{34, 34, 34}, kFaint{95, 95, 95}, kFrame{120, 120, 120}, kGrid{214, 214, 214},
    kFineGrid{238, 238, 238}, kLevel{70, 70, 70};

/// Okabe and Ito 2008, "Color Universal Design", without the yellow, which white paper swallows.
constexpr std::array<Ink, 7> kSeriesInks{Ink{0, 114, 178},   Ink{213, 94, 0},   Ink{0, 158, 115},
                                         Ink{204, 121, 167}, Ink{86, 180, 233}, Ink{230, 159, 0},
                                         Ink{0, 0, 0}};

struct SeriesStyle {
    Ink ink;
    size_t marker;
    double dash;
};

SeriesStyle styleOf(size_t series) {
    const size_t place = series % kSeriesInks.size();
    constexpr std::array<double, 4> kDashes{0.0, 6.0, 2.5, 11.0};
    return {kSeriesInks[place], place, kDashes[series / kSeriesInks.size() % kDashes.size()]};
}

Vec2 at(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

/// Corners of a marker around the origin: few for a polygon, many for a disc.
Polygon marker(size_t kind, Vec2 centre, const Ink& ink) {
    struct Form {
        int corners;
        double turn;
    };
    constexpr double kQuarter = std::numbers::pi / 2.0;
    constexpr std::array<Form, 7> kForms{Form{20, 0.0}, Form{4, kQuarter / 2.0}, Form{3, -kQuarter},
                                         Form{4, 0.0},  Form{3, kQuarter},       Form{5, -kQuarter},
                                         Form{6, 0.0}};
    const Form form = kForms[kind];
    const double radius = form.corners > 6 ? kMarkerRadius * 0.9 : kMarkerRadius * 1.15;
    Polygon polygon{.points = {}, .fill = ink, .outline = {255, 255, 255}, .outlineWidth = 0.8};
    for (int i = 0; i < form.corners; ++i) {
        const double angle = form.turn + 2.0 * std::numbers::pi * i / form.corners;
        polygon.points.push_back(centre + at(radius * std::cos(angle), radius * std::sin(angle)));
    }
    return polygon;
}

bool canShow(double value) { return std::isfinite(value) && value > 0.0; }
bool hasBand(const ChartPoint& point) { return std::isfinite(point.low) && canShow(point.high); }

/// The points that have a place on the axes, by rising x.
std::vector<ChartPoint> shownPoints(const ChartSeries& series) {
    std::vector<ChartPoint> shown;
    for (const ChartPoint& point : series.points) {
        if (canShow(point.x) && canShow(point.y)) {
            shown.push_back(point);
        }
    }
    std::ranges::stable_sort(shown, {}, &ChartPoint::x);
    return shown;
}

struct Range {
    double smallest = std::numeric_limits<double>::infinity();
    double largest = 0.0;

    void include(double value) {
        smallest = std::min(smallest, value);
        largest = std::max(largest, value);
    }
    bool empty() const { return largest == 0.0; }
};

/// The chart with its axes known; everything is drawn by member functions in the order of layOutChart().
class ChartLayout {
  public:
    explicit ChartLayout(const LogLogChart& chart);
    Drawing finish();

  private:
    void findAxes();
    void placeFrame();
    void drawTitles();
    void drawTicks();
    void drawLevels();
    void drawSeries(size_t index);
    void drawBand(const std::vector<ChartPoint>& points, const Ink& ink);
    void drawLegend();
    void drawNotes();

    std::vector<std::string> notes() const;
    std::string levelText(const ChartLevel& level) const;
    double legendWidth() const;
    double plotX(double x) const { return left_ + xAxis_.share(x) * (right_ - left_); }
    double plotY(double y) const {
        return bottom_ - std::clamp(yAxis_.share(y), 0.0, 1.0) * (bottom_ - top_);
    }
    void add(Label label) { drawing_.shapes.emplace_back(std::move(label)); }
    void line(std::vector<Vec2> points, const Ink& ink, double width, double dash = 0.0) {
        drawing_.shapes.emplace_back(Polyline{std::move(points), ink, width, dash});
    }
    double tickLabelWidth(const LogTickText& text) const {
        return textWidth(text.base, kTickSize) + textWidth(text.exponent, kExponentSize);
    }
    void drawTickLabel(const LogTickText& text, double x, double y);

    const LogLogChart& chart_;
    std::vector<std::vector<ChartPoint>> shown_;
    bool empty_ = true;
    LogAxis xAxis_, yAxis_;
    std::vector<LogTick> xTicks_, yTicks_;
    double left_ = 0.0, right_ = 0.0, top_ = 0.0, bottom_ = 0.0;
    Drawing drawing_;
};

ChartLayout::ChartLayout(const LogLogChart& chart) : chart_(chart) {
    drawing_.width = std::max(chart.width, kMinChartWidth);
    drawing_.height = std::max(chart.height, kMinChartHeight);
    drawing_.title = cleanText(chart.title);
    for (const ChartSeries& series : chart.series) {
        shown_.push_back(shownPoints(series));
    }
    findAxes();
    placeFrame();
}

void ChartLayout::findAxes() {
    Range x, y;
    for (const auto& points : shown_) {
        for (const ChartPoint& point : points) {
            x.include(point.x);
            y.include(point.y);
        }
    }
    empty_ = x.empty();
    const Range lines = y;
    for (const auto& points : shown_) {
        for (const ChartPoint& point : points) {
            if (hasBand(point)) {
                // A band that reaches to nearly zero must not flatten the lines.
                y.include(std::max(point.low, 0.1 * lines.smallest));
                y.include(point.high);
            }
        }
    }
    for (const ChartLevel& level : chart_.levels) {
        if (canShow(level.y) && level.y >= 0.01 * lines.smallest && level.y <= 10.0 * lines.largest) {
            y.include(0.8 * level.y);  // off the frame, where it could not be seen
        }
    }
    if (!empty_) {
        xAxis_ = axisOver(x.smallest, x.largest);
        yAxis_ = axisOver(y.smallest, y.largest);
    }
}

double ChartLayout::legendWidth() const {
    double widest = 0.0;
    for (const ChartSeries& series : chart_.series) {
        widest = std::max(widest, textWidth(cleanText(series.name), kTextSize));
    }
    for (const ChartLevel& level : chart_.levels) {
        widest = std::max(widest, textWidth(levelText(level), kTextSize));
    }
    const bool none = chart_.series.empty() && chart_.levels.empty();
    return none ? 0.0 : std::min(kLegendKey + widest + kMargin, kLegendShare * drawing_.width);
}

void ChartLayout::placeFrame() {
    top_ = kMargin + kTitleSize + (chart_.subtitle.empty() ? 10.0 : 30.0);
    const double legendRows = static_cast<double>(chart_.series.size() + chart_.levels.size());
    const double below = 2.0 * kMargin + 36.0 + 16.0 * static_cast<double>(notes().size());
    // A long legend adds height, up to what a picture can hold.
    const double wanted = std::min(top_ + legendRows * kLegendRow + below, 8000.0);
    drawing_.height = std::max(drawing_.height, static_cast<int>(std::ceil(wanted)));
    bottom_ = drawing_.height - below;
    right_ = drawing_.width - kMargin - legendWidth();
    left_ = kMargin + kTextSize + 14.0;
    if (empty_) {
        return;
    }
    yTicks_ = logTicks(yAxis_, bottom_ - top_, 24.0);
    double widest = 0.0;
    for (const LogTick& tick : yTicks_) {
        widest = std::max(widest, tick.labelled ? tickLabelWidth(tickText(tick, yAxis_)) : 0.0);
    }
    left_ += widest;
    xTicks_ = logTicks(xAxis_, right_ - left_, 52.0);
}

void ChartLayout::drawTitles() {
    const double width = drawing_.width - 2.0 * kMargin;
    add({.position = at(kMargin, kMargin + 0.8 * kTitleSize),
         .text = shortened(drawing_.title, kTitleSize, width, true),
         .size = kTitleSize,
         .ink = kText,
         .bold = true});
    if (!chart_.subtitle.empty()) {
        add({.position = at(kMargin, kMargin + kTitleSize + 15.0),
             .text = shortened(cleanText(chart_.subtitle), kTextSize, width),
             .size = kTextSize,
             .ink = kFaint});
    }
    add({.position = at(0.5 * (left_ + right_), bottom_ + 42.0),
         .text = shortened(cleanText(chart_.xTitle), kTextSize, right_ - left_),
         .size = kTextSize,
         .ink = kText,
         .anchor = TextAnchor::Middle});
    add({.position = at(kMargin + 0.8 * kTextSize, 0.5 * (top_ + bottom_)),
         .text = shortened(cleanText(chart_.yTitle), kTextSize, bottom_ - top_),
         .size = kTextSize,
         .ink = kText,
         .anchor = TextAnchor::Middle,
         .upwards = true});
}

void ChartLayout::drawTickLabel(const LogTickText& text, double x, double y) {
    add({.position = at(x, y), .text = text.base, .size = kTickSize, .ink = kText});
    if (!text.exponent.empty()) {
        add({.position = at(x + textWidth(text.base, kTickSize), y - 5.0),
             .text = text.exponent,
             .size = kExponentSize,
             .ink = kText});
    }
}

void ChartLayout::drawTicks() {
    for (const bool labelled : {false, true}) {  // labelled lines lie on top
        for (const LogTick& tick : xTicks_) {
            if (tick.labelled == labelled) {
                const double x = left_ + (tick.logValue() - xAxis_.low) / xAxis_.decades() * (right_ - left_);
                line({at(x, top_), at(x, bottom_)}, labelled ? kGrid : kFineGrid, 1.0);
            }
        }
        for (const LogTick& tick : yTicks_) {
            if (tick.labelled == labelled) {
                const double y =
                    bottom_ - (tick.logValue() - yAxis_.low) / yAxis_.decades() * (bottom_ - top_);
                line({at(left_, y), at(right_, y)}, labelled ? kGrid : kFineGrid, 1.0);
            }
        }
    }
    for (const LogTick& tick : xTicks_) {
        if (tick.labelled) {
            const LogTickText text = tickText(tick, xAxis_);
            const double x = left_ + (tick.logValue() - xAxis_.low) / xAxis_.decades() * (right_ - left_);
            drawTickLabel(text, x - 0.5 * tickLabelWidth(text), bottom_ + 18.0);
        }
    }
    for (const LogTick& tick : yTicks_) {
        if (tick.labelled) {
            const LogTickText text = tickText(tick, yAxis_);
            const double y = bottom_ - (tick.logValue() - yAxis_.low) / yAxis_.decades() * (bottom_ - top_);
            drawTickLabel(text, left_ - 7.0 - tickLabelWidth(text), y + 0.36 * kTickSize);
        }
    }
    const Vec2 corner = at(left_, top_);
    line({corner, at(right_, top_), at(right_, bottom_), at(left_, bottom_), corner}, kFrame, 1.0);
}

void ChartLayout::drawBand(const std::vector<ChartPoint>& points, const Ink& ink) {
    Ink faint = ink;
    faint.opacity = 0.18;
    const auto lowEnd = [&](const ChartPoint& point) { return point.low > 0.0 ? plotY(point.low) : bottom_; };
    for (size_t begin = 0; begin < points.size();) {
        size_t end = begin;
        while (end < points.size() && hasBand(points[end])) {
            ++end;
        }
        if (end - begin == 1) {
            const double x = plotX(points[begin].x);
            line({at(x, lowEnd(points[begin])), at(x, plotY(points[begin].high))}, ink, 1.5);
        } else if (end > begin) {
            Polygon band{.points = {}, .fill = faint};
            for (size_t i = begin; i < end; ++i) {
                band.points.push_back(at(plotX(points[i].x), plotY(points[i].high)));
            }
            for (size_t i = end; i-- > begin;) {
                band.points.push_back(at(plotX(points[i].x), lowEnd(points[i])));
            }
            drawing_.shapes.emplace_back(std::move(band));
        }
        begin = std::max(end, begin + 1);
    }
}

void ChartLayout::drawSeries(size_t index) {
    const SeriesStyle style = styleOf(index);
    const std::vector<ChartPoint>& points = shown_[index];
    std::vector<Vec2> path;
    for (const ChartPoint& point : points) {
        path.push_back(at(plotX(point.x), plotY(point.y)));
    }
    if (path.size() > 1) {
        line(path, style.ink, 2.0, style.dash);
    }
    const size_t stride = (path.size() + kMostMarkers - 1) / kMostMarkers;
    for (size_t i = 0; i < path.size(); i += stride) {
        drawing_.shapes.emplace_back(marker(style.marker, path[i], style.ink));
    }
}

void ChartLayout::drawLevels() {
    for (const ChartLevel& level : chart_.levels) {
        const double share = canShow(level.y) ? yAxis_.share(level.y) : -1.0;
        if (share >= 0.0 && share <= 1.0) {
            line({at(left_, plotY(level.y)), at(right_, plotY(level.y))}, kLevel, 1.4, 6.0);
        }
    }
}

std::string ChartLayout::levelText(const ChartLevel& level) const {
    const std::string text = fmt::format("{}: {:.2g}", cleanText(level.label), level.y);
    if (empty_ || !canShow(level.y)) {
        return text;
    }
    const double share = yAxis_.share(level.y);
    return text + (share < 0.0 ? " (below)" : share > 1.0 ? " (above)" : "");
}

void ChartLayout::drawLegend() {
    const double keyLeft = right_ + kMargin;
    const double room = drawing_.width - kMargin - (keyLeft + kLegendKey);
    double y = top_ + 8.0;
    const auto row = [&](const std::string& text) {
        add({.position = at(keyLeft + kLegendKey, y + 0.36 * kTextSize),
             .text = shortened(text, kTextSize, room),
             .size = kTextSize,
             .ink = kText});
        y += kLegendRow;
    };
    for (size_t i = 0; i < chart_.series.size(); ++i) {
        const SeriesStyle style = styleOf(i);
        line({at(keyLeft, y), at(keyLeft + kLegendKey - 8.0, y)}, style.ink, 2.0, style.dash);
        drawing_.shapes.emplace_back(
            marker(style.marker, at(keyLeft + 0.5 * (kLegendKey - 8.0), y), style.ink));
        row(cleanText(chart_.series[i].name));
    }
    for (const ChartLevel& level : chart_.levels) {
        line({at(keyLeft, y), at(keyLeft + kLegendKey - 8.0, y)}, kLevel, 1.4, 6.0);
        row(levelText(level));
    }
}

std::vector<std::string> ChartLayout::notes() const {
    std::vector<std::string> out;
    if (!chart_.note.empty()) {
        out.push_back(cleanText(chart_.note));
    }
    std::string missing;
    for (size_t i = 0; i < shown_.size(); ++i) {
        if (const size_t left = chart_.series[i].points.size() - shown_[i].size(); left > 0) {
            missing += fmt::format("{}{} of {}", missing.empty() ? "" : ", ", left,
                                   cleanText(chart_.series[i].name));
        }
    }
    if (!missing.empty()) {
        out.push_back("Not shown, being zero, negative or not finite: " + missing);
    }
    return out;
}

void ChartLayout::drawNotes() {
    double y = bottom_ + 64.0;
    for (const std::string& note : notes()) {
        add({.position = at(kMargin, y),
             .text = shortened(note, kNoteSize, drawing_.width - 2.0 * kMargin),
             .size = kNoteSize,
             .ink = kFaint});
        y += 16.0;
    }
}

Drawing ChartLayout::finish() {
    drawTicks();
    drawTitles();
    if (empty_) {
        add({.position = at(0.5 * (left_ + right_), 0.5 * (top_ + bottom_)),
             .text = "nothing to show",
             .size = kTextSize,
             .ink = kFaint,
             .anchor = TextAnchor::Middle});
    } else {
        for (size_t i = 0; i < shown_.size(); ++i) {
            drawBand(shown_[i], styleOf(i).ink);
        }
        drawLevels();
        for (size_t i = 0; i < shown_.size(); ++i) {
            drawSeries(i);
        }
    }
    drawLegend();
    drawNotes();
    return std::move(drawing_);
}

}  // namespace

Drawing layOutChart(const LogLogChart& chart) { return ChartLayout(chart).finish(); }

std::string chartSvg(const LogLogChart& chart) { return drawingSvg(layOutChart(chart)); }

Image8 chartPicture(const LogLogChart& chart, double scale) {
    return drawingPicture(layOutChart(chart), scale);
}

Status saveChart(const std::string& path, const LogLogChart& chart) {
    if (path.ends_with(".svg")) {
        return writeFileAtomically(path, chartSvg(chart));
    }
    if (path.ends_with(".png")) {
        return savePng(path, chartPicture(chart));
    }
    return Error{
        fmt::format("cannot save the chart as '{}': expected a name that ends in .svg or .png", path), {}};
}

}  // namespace glint
