#include "viewer/ui/loglog_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <imgui.h>

#include "engine/report/log_axis.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr float kMarginUnits = 6.0f;
constexpr float kReachUnits = 12.0f;           // how far beyond a curve's end the mouse still finds it
constexpr double kTargetBelowCurves = 1000.0;  // a target farther below would squeeze the curves
constexpr ImU32 kGrid = IM_COL32(255, 255, 255, 38);
constexpr ImU32 kMinorGrid = IM_COL32(255, 255, 255, 13);
constexpr ImU32 kTargetColor = IM_COL32(235, 235, 235, 150);

bool isPositive(double value) { return value > 0.0 && std::isfinite(value); }
bool isDrawn(const PlotPoint& point) { return isPositive(point.x) && isPositive(point.y); }
bool hasBand(const PlotPoint& point) {
    return isPositive(point.low) && std::isfinite(point.high) && point.high > point.low;
}

ImU32 colorOf(const Vec3& c, float alpha) { return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, alpha}); }

struct Axes {
    LogAxis x;
    LogAxis y;
    ImVec2 min;  ///< of the area inside the axes
    ImVec2 max;

    static float clamped(double share) { return static_cast<float>(std::clamp(share, -0.5, 1.5)); }
    float placeX(double share) const { return min.x + clamped(share) * (max.x - min.x); }
    float placeY(double share) const { return max.y - clamped(share) * (max.y - min.y); }
    ImVec2 place(double xValue, double yValue) const {
        return {placeX(x.share(xValue)), placeY(y.share(yValue))};
    }
};

/// Bands may reach a little beyond: they must not squeeze the curves.
bool findRanges(const LogLogPlot& plot, Axes* axes) {
    AxisExtent x;
    AxisExtent y;
    AxisExtent bands;
    for (const PlotCurve& curve : plot.curves) {
        for (const PlotPoint& point : curve.points) {
            if (!isDrawn(point)) { continue; }
            x.include(point.x);
            y.include(point.y);
            if (!hasBand(point)) { continue; }
            bands.include(point.low);
            bands.include(point.high);
        }
    }
    if (x.largest <= 0.0) { return false; }
    if (bands.largest > 0.0) {
        y.include(std::max(bands.smallest, y.smallest / 4.0));
        y.include(std::min(bands.largest, y.largest * 4.0));
    }
    if (plot.targetY && isPositive(*plot.targetY) && *plot.targetY * kTargetBelowCurves > y.smallest) {
        y.include(*plot.targetY);
    }
    axes->x = axisOver(x.smallest, x.largest);
    axes->y = axisOver(y.smallest, y.largest);
    return true;
}

/// Room for the labels of the vertical axis: plain numbers of up to six characters, or powers of ten.
float labelRoom() { return ImGui::CalcTextSize("0.0001").x; }

ImVec2 sizeOf(const LogTickText& text) {
    const ImVec2 base = ImGui::CalcTextSize(text.base.c_str());
    return {base.x + ImGui::CalcTextSize(text.exponent.c_str()).x, base.y};
}

void drawTickText(const LogTickText& text, ImVec2 corner, ImDrawList* draw) {
    const ImU32 color = ImGui::GetColorU32(theme::kTextDim);
    draw->AddText(corner, color, text.base.c_str());
    const float raised = corner.y - 0.3f * ImGui::GetFontSize();
    draw->AddText({corner.x + ImGui::CalcTextSize(text.base.c_str()).x, raised}, color,
                  text.exponent.c_str());
}

std::vector<LogTick> ticksOf(const LogAxis& axis, float length, float spacing) {
    return logTicks(axis, static_cast<double>(length), static_cast<double>(spacing));
}

void drawGrid(const Axes& axes, ImDrawList* draw) {
    const float gap = 4.0f * ui::scale();
    const auto share = [](const LogTick& tick, const LogAxis& axis) {
        return (tick.logValue() - axis.low) / axis.decades();
    };
    for (const LogTick& tick : ticksOf(axes.x, axes.max.x - axes.min.x, labelRoom())) {
        const float x = axes.placeX(share(tick, axes.x));
        draw->AddLine({x, axes.min.y}, {x, axes.max.y}, tick.digit == 1 ? kGrid : kMinorGrid);
        if (!tick.labelled) { continue; }
        const LogTickText text = tickText(tick, axes.x);
        const float width = sizeOf(text).x;
        drawTickText(text, {std::min(x - width * 0.5f, axes.max.x + gap - width), axes.max.y + gap * 0.5f},
                     draw);
    }
    for (const LogTick& tick : ticksOf(axes.y, axes.max.y - axes.min.y, 1.3f * ImGui::GetFontSize())) {
        const float y = axes.placeY(share(tick, axes.y));
        draw->AddLine({axes.min.x, y}, {axes.max.x, y}, tick.digit == 1 ? kGrid : kMinorGrid);
        if (!tick.labelled) { continue; }
        const LogTickText text = tickText(tick, axes.y);
        const ImVec2 size = sizeOf(text);
        drawTickText(text, {axes.min.x - gap - size.x, y - size.y * 0.5f}, draw);
    }
    draw->AddRect(axes.min, axes.max, kGrid);
}

void drawBand(const Axes& axes, const PlotCurve& curve, ImDrawList* draw) {
    const ImDrawListFlags flags = draw->Flags;
    draw->Flags &= ~ImDrawListFlags_AntiAliasedFill;  // quads side by side would show their seams
    const ImU32 color = colorOf(curve.color, curve.isFaint ? 0.10f : 0.22f);
    const PlotPoint* before = nullptr;
    for (const PlotPoint& point : curve.points) {
        const bool drawn = isDrawn(point) && hasBand(point);
        if (drawn && before != nullptr) {
            draw->AddQuadFilled(axes.place(before->x, before->low), axes.place(point.x, point.low),
                                axes.place(point.x, point.high), axes.place(before->x, before->high), color);
        }
        before = drawn ? &point : nullptr;
    }
    draw->Flags = flags;
}

void drawDashes(const std::vector<ImVec2>& line, ImU32 color, float thickness, ImDrawList* draw) {
    const float dash = 5.0f * ui::scale();
    float along = 0.0f;
    for (size_t i = 1; i < line.size(); ++i) {
        const ImVec2 from = line[i - 1];
        const ImVec2 way{line[i].x - from.x, line[i].y - from.y};
        const float length = std::hypot(way.x, way.y);
        // Each dash of this piece, [begin, end) along it.
        for (float at = 0.0f; at < length;) {
            const float phase = std::fmod(along + at, 2.0f * dash);
            const float end = std::min(length, at + (phase < dash ? dash : 2.0f * dash) - phase + 0.01f);
            if (phase < dash) {
                const ImVec2 begin{from.x + way.x * at / length, from.y + way.y * at / length};
                draw->AddLine(begin, {from.x + way.x * end / length, from.y + way.y * end / length}, color,
                              thickness);
            }
            at = end;
        }
        along += length;
    }
}

void drawCurve(const Axes& axes, const PlotCurve& curve, ImDrawList* draw) {
    const float scale = ui::scale();
    const ImU32 color = colorOf(curve.color, curve.isFaint ? 0.45f : 1.0f);
    std::vector<ImVec2> line;
    line.reserve(curve.points.size());
    for (const PlotPoint& point : curve.points) {
        if (isDrawn(point)) { line.push_back(axes.place(point.x, point.y)); }
    }
    const float thickness = (curve.isFaint ? 1.0f : 1.8f) * scale;
    if (curve.isDashed) {
        drawDashes(line, color, thickness, draw);
    } else {
        draw->AddPolyline(line.data(), static_cast<int>(line.size()), color, 0, thickness);
    }
    const size_t firstDot = curve.hasMarkers || line.empty() ? 0 : line.size() - 1;
    if (curve.isFaint) { return; }
    for (size_t i = firstDot; i < line.size(); ++i) {
        draw->AddCircleFilled(line[i], 2.6f * scale, color);
    }
}

void drawTarget(const Axes& axes, double target, ImDrawList* draw) {
    const float y = axes.placeY(axes.y.share(target));
    if (y < axes.min.y || y > axes.max.y) { return; }
    const float dash = 6.0f * ui::scale();
    for (float x = axes.min.x; x < axes.max.x; x += 2.0f * dash) {
        draw->AddLine({x, y}, {std::min(x + dash, axes.max.x), y}, kTargetColor, ui::scale());
    }
}

/// In the plot's last line, up to `right`.
void drawBelow(const std::string& text, ImU32 color, float right, float bottom, ImDrawList* draw) {
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    const float margin = kMarginUnits * ui::scale();
    draw->AddText({right - width, bottom - ImGui::GetFontSize() - margin * 0.5f}, color, text.c_str());
}

/// One row above the axes: a line's piece and its name for each curve, and the titles.
void drawTitles(const LogLogPlot& plot, const Axes& axes, Vec2 min, Vec2 max, ImDrawList* draw) {
    const float scale = ui::scale();
    const float line = ImGui::GetFontSize();
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
    const ImU32 dim = ImGui::GetColorU32(theme::kTextDim);
    const float margin = kMarginUnits * scale;
    draw->AddText({min.x + margin, min.y + margin}, dim, plot.yTitle.c_str());
    float right = max.x - margin;
    for (auto curve = plot.curves.rbegin(); curve != plot.curves.rend(); ++curve) {
        if (curve->isFaint || curve->points.empty()) { continue; }
        right -= ImGui::CalcTextSize(curve->name.c_str()).x;
        draw->AddText({right, min.y + margin}, text, curve->name.c_str());
        const float y = min.y + margin + line * 0.5f;
        const ImU32 color = colorOf(curve->color, 1.0f);
        draw->AddLine({right - 18.0f * scale, y}, {right - 5.0f * scale, y}, color, 2.0f * scale);
        draw->AddCircleFilled({right - 11.5f * scale, y}, 2.6f * scale, color);
        right -= 28.0f * scale;
    }
    if (plot.warning.empty()) { drawBelow(plot.xTitle, dim, axes.max.x, max.y, draw); }
}

PlotHover hoverOf(const LogLogPlot& plot, const Axes& axes) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) || mouse.x < axes.min.x ||
        mouse.x > axes.max.x || mouse.y < axes.min.y || mouse.y > axes.max.y) {
        return {};
    }
    PlotHover hover;
    for (const PlotCurve& curve : plot.curves) {
        float nearest = std::numeric_limits<float>::infinity();
        std::optional<size_t> found;
        const float reach = kReachUnits * ui::scale();
        float left = std::numeric_limits<float>::infinity();
        float right = -left;
        for (size_t i = 0; i < curve.points.size(); ++i) {
            if (!isDrawn(curve.points[i])) { continue; }
            const float x = axes.place(curve.points[i].x, curve.points[i].y).x;
            left = std::min(left, x);
            right = std::max(right, x);
            if (std::fabs(x - mouse.x) >= nearest) { continue; }
            nearest = std::fabs(x - mouse.x);
            found = i;
        }
        const bool within = mouse.x >= left - reach && mouse.x <= right + reach;
        hover.push_back(within ? found : std::nullopt);
    }
    return hover;
}

void drawHover(const LogLogPlot& plot, const PlotHover& hover, const Axes& axes, ImDrawList* draw) {
    const float scale = ui::scale();
    const float x = ImGui::GetIO().MousePos.x;
    draw->AddLine({x, axes.min.y}, {x, axes.max.y}, kGrid);
    for (size_t i = 0; i < hover.size(); ++i) {
        if (!hover[i] || plot.curves[i].isFaint) { continue; }
        const PlotPoint& point = plot.curves[i].points[*hover[i]];
        const ImVec2 at = axes.place(point.x, point.y);
        draw->AddCircleFilled(at, 4.5f * scale, colorOf(plot.curves[i].color, 1.0f));
        draw->AddCircle(at, 4.5f * scale, ImGui::GetColorU32(ImGuiCol_Text), 0, scale);
    }
}

}  // namespace

PlotHover drawLogLogPlot(const LogLogPlot& plot, Vec2 min, Vec2 max) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float scale = ui::scale();
    const float margin = kMarginUnits * scale;
    const float line = ImGui::GetFontSize();
    draw->AddRectFilled({min.x, min.y}, {max.x, max.y}, ImGui::GetColorU32(ImGuiCol_FrameBg), 3.0f * scale);
    drawBelow(plot.warning, ImGui::GetColorU32(theme::kTextWarning), max.x - 2.0f * margin, max.y, draw);
    Axes axes;
    if (!findRanges(plot, &axes)) {
        const ImVec2 size = ImGui::CalcTextSize(plot.nothing.c_str());
        draw->AddText({(min.x + max.x - size.x) * 0.5f, (min.y + max.y - size.y) * 0.5f},
                      ImGui::GetColorU32(theme::kTextDim), plot.nothing.c_str());
        return {};
    }
    axes.min = {min.x + 1.5f * margin + labelRoom(), min.y + line + 2.0f * margin};
    axes.max = {max.x - 2.0f * margin, max.y - 2.0f * line - 1.5f * margin};
    drawGrid(axes, draw);
    drawTitles(plot, axes, min, max, draw);
    draw->PushClipRect(axes.min, axes.max, true);
    for (const PlotCurve& curve : plot.curves) {
        drawBand(axes, curve, draw);
    }
    if (plot.targetY && isPositive(*plot.targetY)) { drawTarget(axes, *plot.targetY, draw); }
    for (auto curve = plot.curves.rbegin(); curve != plot.curves.rend(); ++curve) {
        drawCurve(axes, *curve, draw);
    }
    PlotHover hover = hoverOf(plot, axes);
    if (!hover.empty()) { drawHover(plot, hover, axes, draw); }
    draw->PopClipRect();
    return hover;
}

}  // namespace glint
