// Draws a chart that chart_layout.h has laid out: title above, axis titles and labels around the frame, the
// legend in a column of its own on the right, where it can cover nothing, and notes below.
#include "engine/report/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/file_path.h"
#include "engine/io/image_io.h"
#include "engine/report/chart_layout.h"

namespace glint {
namespace {

constexpr double kNoteSize = 11.5;
constexpr size_t kMostMarkers = 40;
constexpr double kMarkerRadius = 4.0;
constexpr double kLevelWidth = 1.4, kLevelDash = 6.0;

constexpr Ink kText{34, 34, 34}, kFaint{95, 95, 95}, kFrame{120, 120, 120}, kGrid{214, 214, 214},
    kFineGrid{238, 238, 238}, kLevelInk{70, 70, 70};

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

/// Corners around the centre: few for a polygon, many for a disc.
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
    const double radius = kMarkerRadius * (form.corners > 6 ? 0.9 : 1.15);
    Polygon polygon{.points = {}, .fill = ink, .outline = {255, 255, 255}, .outlineWidth = 0.8};
    for (int i = 0; i < form.corners; ++i) {
        const double angle = form.turn + 2.0 * std::numbers::pi * i / form.corners;
        polygon.points.push_back(centre + at(radius * std::cos(angle), radius * std::sin(angle)));
    }
    return polygon;
}

class ChartArtist {
  public:
    explicit ChartArtist(const LogLogChart& chart) : chart_(chart), at_(layOut(chart)) {
        drawing_ = {.width = at_.width, .height = at_.height, .title = cleanText(chart.title), .shapes = {}};
    }
    Drawing finish();

  private:
    void drawGrid();
    void drawTickLabels();
    void drawTitles();
    void drawLevels();
    void drawSeries(size_t index);
    void drawBand(const std::vector<ChartPoint>& points, const Ink& ink);
    void drawLegend();
    void drawNotes();

    void add(Label label) {
        if (!label.text.empty()) { drawing_.shapes.emplace_back(std::move(label)); }
    }
    void line(std::vector<Vec2> points, const Ink& ink, double width, double dash = 0.0) {
        drawing_.shapes.emplace_back(Polyline{std::move(points), ink, width, dash});
    }
    void tickLabel(const LogTickText& text, double x, double y);

    const LogLogChart& chart_;
    const ChartLayout at_;
    Drawing drawing_;
};

void ChartArtist::drawGrid() {
    for (const bool labelled : {false, true}) {  // labelled lines lie on top
        const Ink& ink = labelled ? kGrid : kFineGrid;
        for (const LogTick& tick : at_.xTicks) {
            if (tick.labelled == labelled) {
                line({at(at_.tickX(tick), at_.top), at(at_.tickX(tick), at_.bottom)}, ink, 1.0);
            }
        }
        for (const LogTick& tick : at_.yTicks) {
            if (tick.labelled == labelled) {
                line({at(at_.left, at_.tickY(tick)), at(at_.right, at_.tickY(tick))}, ink, 1.0);
            }
        }
    }
    const Vec2 corner = at(at_.left, at_.top);
    line({corner, at(at_.right, at_.top), at(at_.right, at_.bottom), at(at_.left, at_.bottom), corner},
         kFrame, 1.0);
}

void ChartArtist::tickLabel(const LogTickText& text, double x, double y) {
    add({.position = at(x, y), .text = text.base, .size = kChartTickSize, .ink = kText});
    if (!text.exponent.empty()) {
        add({.position = at(x + textWidth(text.base, kChartTickSize), y - 5.0),
             .text = text.exponent,
             .size = kChartExponentSize,
             .ink = kText});
    }
}

void ChartArtist::drawTickLabels() {
    for (const LogTick& tick : at_.xTicks) {
        if (tick.labelled) {
            const LogTickText text = tickText(tick, at_.xAxis);
            tickLabel(text, at_.tickX(tick) - 0.5 * tickWidth(text), at_.bottom + 18.0);
        }
    }
    for (const LogTick& tick : at_.yTicks) {
        if (tick.labelled) {
            const LogTickText text = tickText(tick, at_.yAxis);
            tickLabel(text, at_.left - 7.0 - tickWidth(text), at_.tickY(tick) + 0.36 * kChartTickSize);
        }
    }
}

void ChartArtist::drawTitles() {
    const double width = at_.width - 2.0 * kChartMargin;
    add({.position = at(kChartMargin, kChartMargin + 0.8 * kChartTitleSize),
         .text = shortened(drawing_.title, kChartTitleSize, width, true),
         .size = kChartTitleSize,
         .ink = kText,
         .bold = true});
    add({.position = at(kChartMargin, kChartMargin + kChartTitleSize + 15.0),
         .text = shortened(cleanText(chart_.subtitle), kChartTextSize, width),
         .size = kChartTextSize,
         .ink = kFaint});
    add({.position = at(0.5 * (at_.left + at_.right), at_.bottom + 42.0),
         .text = shortened(cleanText(chart_.xTitle), kChartTextSize, at_.right - at_.left),
         .size = kChartTextSize,
         .ink = kText,
         .anchor = TextAnchor::Middle});
    add({.position = at(kChartMargin + 0.8 * kChartTextSize, 0.5 * (at_.top + at_.bottom)),
         .text = shortened(cleanText(chart_.yTitle), kChartTextSize, at_.bottom - at_.top),
         .size = kChartTextSize,
         .ink = kText,
         .anchor = TextAnchor::Middle,
         .upwards = true});
}

void ChartArtist::drawBand(const std::vector<ChartPoint>& points, const Ink& ink) {
    Ink faint = ink;
    faint.opacity = 0.18;
    const auto high = [&](const ChartPoint& point) { return at(at_.plotX(point.x), at_.plotY(point.high)); };
    const auto low = [&](const ChartPoint& point) {
        return at(at_.plotX(point.x), point.low > 0.0 ? at_.plotY(point.low) : at_.bottom);
    };
    for (size_t begin = 0; begin < points.size();) {
        size_t end = begin;
        while (end < points.size() && hasBand(points[end])) {
            ++end;
        }
        if (end - begin == 1) {
            line({low(points[begin]), high(points[begin])}, ink, 1.5);
        } else if (end > begin) {
            Polygon band{.points = {}, .fill = faint};
            band.points.reserve(2 * (end - begin));
            for (size_t i = begin; i < end; ++i) {
                band.points.push_back(high(points[i]));
            }
            for (size_t i = end; i-- > begin;) {
                band.points.push_back(low(points[i]));
            }
            drawing_.shapes.emplace_back(std::move(band));
        }
        begin = std::max(end, begin + 1);
    }
}

void ChartArtist::drawSeries(size_t index) {
    const SeriesStyle style = styleOf(index);
    std::vector<Vec2> path;
    path.reserve(at_.shown[index].size());
    for (const ChartPoint& point : at_.shown[index]) {
        path.push_back(at(at_.plotX(point.x), at_.plotY(point.y)));
    }
    if (path.size() > 1) { line(path, style.ink, 2.0, style.dash); }
    const size_t stride = (path.size() + kMostMarkers - 1) / kMostMarkers;
    for (size_t i = 0; i < path.size(); i += stride) {
        Polygon mark = marker(style.marker, path[i], style.ink);
        mark.tip = cleanText(at_.shown[index][i].tip);
        drawing_.shapes.emplace_back(std::move(mark));
    }
}

void ChartArtist::drawLevels() {
    for (const ChartLevel& level : chart_.levels) {
        if (at_.shows(level)) {
            const double y = at_.plotY(level.y);
            line({at(at_.left, y), at(at_.right, y)}, kLevelInk, kLevelWidth, kLevelDash);
        }
    }
}

void ChartArtist::drawLegend() {
    const double left = at_.right + kChartMargin;
    const double keyRight = left + kLegendKey - 8.0;
    const double room = at_.width - kChartMargin - (left + kLegendKey);
    double y = at_.top + 8.0;
    for (size_t i = 0; i < at_.legend.size(); ++i, y += kLegendRow) {
        if (i < chart_.series.size()) {
            const SeriesStyle style = styleOf(i);
            line({at(left, y), at(keyRight, y)}, style.ink, 2.0, style.dash);
            drawing_.shapes.emplace_back(marker(style.marker, at(0.5 * (left + keyRight), y), style.ink));
        } else {
            line({at(left, y), at(keyRight, y)}, kLevelInk, kLevelWidth, kLevelDash);
        }
        add({.position = at(left + kLegendKey, y + 0.36 * kChartTextSize),
             .text = shortened(at_.legend[i], kChartTextSize, room),
             .size = kChartTextSize,
             .ink = kText});
    }
}

void ChartArtist::drawNotes() {
    double y = at_.bottom + kBelowFrame;
    for (const std::string& note : at_.notes) {
        add({.position = at(kChartMargin, y),
             .text = shortened(note, kNoteSize, at_.width - 2.0 * kChartMargin),
             .size = kNoteSize,
             .ink = kFaint});
        y += kNoteRow;
    }
}

Drawing ChartArtist::finish() {
    drawGrid();
    drawTickLabels();
    drawTitles();
    for (size_t i = 0; i < at_.shown.size(); ++i) {
        drawBand(at_.shown[i], styleOf(i).ink);
    }
    drawLevels();
    for (size_t i = 0; i < at_.shown.size(); ++i) {
        drawSeries(i);
    }
    if (at_.empty) {
        add({.position = at(0.5 * (at_.left + at_.right), 0.5 * (at_.top + at_.bottom)),
             .text = "nothing to show",
             .size = kChartTextSize,
             .ink = kFaint,
             .anchor = TextAnchor::Middle});
    }
    drawLegend();
    drawNotes();
    return std::move(drawing_);
}

}  // namespace

Drawing layOutChart(const LogLogChart& chart) { return ChartArtist(chart).finish(); }

std::string chartSvg(const LogLogChart& chart) { return drawingSvg(layOutChart(chart)); }

Image8 chartImage(const LogLogChart& chart, double scale) { return drawingImage(layOutChart(chart), scale); }

Status saveChart(const std::string& path, const LogLogChart& chart) {
    if (hasExtension(path, ".svg")) { return writeFileAtomically(path, chartSvg(chart)); }
    if (hasExtension(path, ".png")) { return savePng(path, chartImage(chart)); }
    return Error{
        fmt::format("cannot save the chart as '{}': expected a name that ends in .svg or .png", path), {}};
}

}  // namespace glint
