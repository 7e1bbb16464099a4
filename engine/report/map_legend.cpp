// The strip is a Drawing at one pixel a unit; its bar goes through falseColors(), so it cannot show other
// colours than the map.
#include "engine/report/map_legend.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/report/drawing.h"
#include "engine/report/log_axis.h"

namespace glint {
namespace {

constexpr double kMargin = 10.0, kTextSize = 11.5, kExponentSize = 8.5;
constexpr double kBarTop = 22.0, kBarHeight = 12.0, kLabelBase = 47.0, kNoteBase = 58.0;
constexpr int kLinearLabels = 5;
constexpr Ink kText{34, 34, 34}, kFaint{95, 95, 95};

std::string titleOf(ErrorMapKind kind) {
    switch (kind) {
        case ErrorMapKind::RelativeSquared:
            return "Relative squared error (logarithmic)";
        case ErrorMapKind::Absolute:
            return "Absolute error, radiance (logarithmic)";
        case ErrorMapKind::Signed:
            return "Signed error, radiance: blue darker, orange brighter";
        case ErrorMapKind::Flip:
            return "FLIP, the difference a viewer sees";
    }
    return {};
}

Vec2 at(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

double valueAt(double share, const MapRange& range) {
    return range.logarithmic ? range.low * std::pow(range.high / range.low, share)
                             : range.low + share * (range.high - range.low);
}

void addBar(ErrorMapKind kind, const MapRange& range, int left, int width, Drawing* drawing) {
    ErrorMap bar{.kind = kind, .width = width, .height = 1, .values = {}};
    for (int i = 0; i < width; ++i) {
        bar.values.push_back(static_cast<float>(valueAt((i + 0.5) / width, range)));
    }
    const Image8 colors = falseColors(bar, range);
    for (int i = 0; i < width; ++i) {
        const uint8_t* rgb = &colors.rgb[3 * static_cast<size_t>(i)];
        const double x = left + i;
        drawing->shapes.emplace_back(
            Polygon{.points = {at(x, kBarTop), at(x + 1, kBarTop), at(x + 1, kBarTop + kBarHeight),
                               at(x, kBarTop + kBarHeight)},
                    .fill = {rgb[0], rgb[1], rgb[2]}});
    }
}

/// Centred on its place, but never beyond the ends of the strip.
void addLabel(const LogTickText& text, double centre, Drawing* drawing) {
    const double baseWidth = textWidth(text.base, kTextSize);
    const double width = baseWidth + textWidth(text.exponent, kExponentSize);
    const double left = std::clamp(centre - 0.5 * width, 2.0, std::max(2.0, drawing->width - 2.0 - width));
    drawing->shapes.emplace_back(
        Label{.position = at(left, kLabelBase), .text = text.base, .size = kTextSize, .ink = kText});
    if (!text.exponent.empty()) {
        drawing->shapes.emplace_back(Label{.position = at(left + baseWidth, kLabelBase - 4.0),
                                           .text = text.exponent,
                                           .size = kExponentSize,
                                           .ink = kText});
    }
}

void addLabels(const MapRange& range, double left, double width, Drawing* drawing) {
    if (range.logarithmic) {
        const LogAxis axis{std::log10(range.low), std::log10(range.high)};
        for (const LogTick& tick : logTicks(axis, width, 48.0)) {
            if (tick.labelled) {
                addLabel(tickText(tick, axis), left + (tick.logValue() - axis.low) / axis.decades() * width,
                         drawing);
            }
        }
        return;
    }
    for (int i = 0; i < kLinearLabels; ++i) {
        const double share = static_cast<double>(i) / (kLinearLabels - 1);
        addLabel({.base = fmt::format("{:.3g}", valueAt(share, range)), .exponent = {}}, left + share * width,
                 drawing);
    }
}

Image8 legendStrip(ErrorMapKind kind, const MapRange& range, int width) {
    Drawing drawing{.width = width, .height = kLegendHeight, .title = {}, .shapes = {}};
    const int left = static_cast<int>(kMargin);
    const int barWidth = width - 2 * left;
    drawing.shapes.emplace_back(Label{
        .position = at(kMargin, 16.0), .text = titleOf(kind), .size = kTextSize, .ink = kText, .bold = true});
    addBar(kind, range, left, barWidth, &drawing);
    addLabels(range, left, barWidth, &drawing);
    drawing.shapes.emplace_back(Label{.position = at(kMargin, kNoteBase),
                                      .text = "black: no error; ends: and beyond; magenta: not finite",
                                      .size = 9.0,
                                      .ink = kFaint});
    return drawingImage(drawing, 1.0);
}

void paste(const Image8& from, int top, Image8* to) {
    for (int y = 0; y < from.height; ++y) {
        const auto source = from.rgb.begin() + static_cast<std::ptrdiff_t>(3 * y) * from.width;
        std::copy_n(source, 3 * from.width,
                    to->rgb.begin() + static_cast<std::ptrdiff_t>(3 * (y + top)) * to->width);
    }
}

}  // namespace

Image8 mapWithLegend(const ErrorMap& map, const MapRange& range) {
    Image8 out{
        .width = std::max(map.width, kLegendLeastWidth), .height = map.height + kLegendHeight, .rgb = {}};
    out.rgb.assign(3 * static_cast<size_t>(out.width) * static_cast<size_t>(out.height), 255);
    paste(falseColors(map, range), 0, &out);
    paste(legendStrip(map.kind, range, out.width), map.height, &out);
    return out;
}

}  // namespace glint
