#include "viewer/window/split_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/base/units.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr float kGrabUnits = 5.0f;  // each side of the divider
constexpr float kMarginUnits = 8.0f;
constexpr ImU32 kPlate = IM_COL32(20, 20, 20, 190);
constexpr ImU32 kWaiting = IM_COL32(110, 110, 110, 255);  // tint of a picture that is not of this scene

float dividerX(const DisplaySettings& settings, Vec2 min, Vec2 max) {
    return std::floor(min.x + (max.x - min.x) * settings.splitAt);
}

ImVec2 im(Vec2 v) { return {v.x, v.y}; }

ImTextureID textureOf(const ImageDisplay& display) {
    return reinterpret_cast<ImTextureID>(static_cast<intptr_t>(display.texture()));
}

constexpr float kPlatePadX = 6.0f;
constexpr float kPlatePadY = 3.0f;

/// Of a plate with that text, which is wrapped where it is wider than `room` (0: never).
Vec2 plateSize(const std::string& text, float room) {
    const Vec2 pad = Vec2(kPlatePadX, kPlatePadY) * ui::scale();
    const float wrap = room > 0.0f ? std::max(room - 2.0f * pad.x, 1.0f) : 0.0f;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
    return Vec2(size.x, size.y) + pad * 2.0f;
}

/// Text on a dark plate of plateSize().
void drawPlate(const std::string& text, Vec2 corner, Vec2 size) {
    const Vec2 pad = Vec2(kPlatePadX, kPlatePadY) * ui::scale();
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(im(corner), im(corner + size), kPlate, 4.0f * ui::scale());
    // Half a pixel more, so that rounding does not wrap what was measured to fit.
    draw->AddText(ImGui::GetFont(), ImGui::GetFontSize(), im(corner + pad), ImGui::GetColorU32(ImGuiCol_Text),
                  text.c_str(), nullptr, size.x - 2.0f * pad.x + 0.5f);
}

/// What the side shows, from the full text to the shortest one.
std::array<std::string, 4> sideLabels(const IntegratorInfo& integrator, const FilmSnapshot* snapshot) {
    const std::string name = integrator.displayName;
    const std::string shortName = inCapitals(integrator.alias);
    if (snapshot == nullptr) { return {fmt::format("{}   first pass…", name), name, shortName, ""}; }
    if (snapshot->previewScale > 1) { return {fmt::format("{}   preview", name), name, shortName, ""}; }
    const std::string passes = fmt::format("{}   {}", name, passCount(snapshot->passes));
    return {fmt::format("{}   {}", passes, duration(snapshot->renderSeconds)), passes, name, shortName};
}

struct Area {
    Vec2 min;
    Vec2 max;
};

/// The part of the picture that the window shows.
Area seenPart(Vec2 min, Vec2 max) {
    const ImVec2 corner = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    return {{std::max(min.x, corner.x), std::max(min.y, corner.y)},
            {std::min(max.x, corner.x + size.x), std::min(max.y, corner.y + size.y)}};
}

struct Side {
    IntegratorKind integrator;
    const ImageDisplay* display = nullptr;
    const FilmSnapshot* snapshot = nullptr;
};

/// The part of the side's picture between the shares `from` and `to` of the width.
void drawSide(const Side& side, Vec2 min, Vec2 max, float from, float to) {
    const float width = max.x - min.x;
    const Vec2 partMin(min.x + width * from, min.y);
    const Vec2 partMax(min.x + width * to, max.y);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->PushClipRect(im(partMin), im(partMax), true);
    if (side.display != nullptr && side.display->texture() != 0) {
        draw->AddImage(textureOf(*side.display), im(partMin), im(partMax), {from, 0.0f}, {to, 1.0f},
                       side.snapshot != nullptr ? IM_COL32_WHITE : kWaiting);
    } else {
        draw->AddRectFilled(im(partMin), im(partMax), kPlate);
    }
    const float margin = kMarginUnits * ui::scale();
    const bool isRight = to == 1.0f && from > 0.0f;
    const Area seen = seenPart(partMin, partMax);
    for (const std::string& label : sideLabels(integratorInfo(side.integrator), side.snapshot)) {
        const Vec2 size = plateSize(label, 0.0f);
        if (label.empty() || size.x > seen.max.x - seen.min.x - 2.0f * margin) { continue; }
        const float x = isRight ? seen.max.x - margin - size.x : seen.min.x + margin;
        drawPlate(label, {x, seen.min.y + margin}, size);
        ui::area(isRight ? "Right side" : "Left side", seen.min, seen.max, label);
        break;
    }
    draw->PopClipRect();
}

void drawSplit(const Workspace& workspace, const ImagePanes& panes, Vec2 min, Vec2 max) {
    const ComparedPair pair = workspace.comparedPair();
    Side left{pair.left};
    Side right{pair.right};
    const auto put = [&](const FilmSnapshot* snapshot, const ImagePane& pane) {
        const IntegratorKind kind =
            snapshot != nullptr ? snapshot->integrator : pane.source.shownIntegrator();
        for (Side* side : {&left, &right}) {
            const bool isFree = side->integrator == kind && side->display == nullptr;
            if (isFree) { *side = {kind, pane.display.get(), snapshot}; }
        }
    };
    put(workspace.render.snapshot().get(), panes.own);
    put(workspace.render.otherSnapshot().get(), panes.other);
    const float x = dividerX(workspace.display, min, max);
    const float share = (x - min.x) / (max.x - min.x);
    if (share > 0.0f) { drawSide(left, min, max, 0.0f, share); }
    if (share < 1.0f) { drawSide(right, min, max, share, 1.0f); }
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float half = std::max(1.0f, ui::scale());
    draw->AddRectFilled({x - 2.0f * half, min.y}, {x + 2.0f * half, max.y}, IM_COL32(0, 0, 0, 110));
    draw->AddRectFilled({x - half, min.y}, {x + half, max.y}, IM_COL32(235, 235, 235, 255));
    draw->AddCircleFilled({x, (min.y + max.y) * 0.5f}, 5.0f * half, IM_COL32(235, 235, 235, 255));
}

/// The colours from the smallest to the largest value, with both, in the lower left corner or the right one.
/// Returns its upper edge.
float drawScale(const ShownImageSource& source, Vec2 min, Vec2 max, bool onRight) {
    const HeatScale& heat = source.scale().heat;
    const bool isSigned = source.scale().isSigned;
    const float scale = ui::scale();
    const ShownImageInfo& info = infoOf(source.shownImage());
    const std::string low = info.scaleText(isSigned ? -heat.largest : heat.smallest);
    const std::string high = fmt::format("{} {}", info.scaleText(heat.largest), info.unit);
    const float line = ImGui::GetFontSize();
    const float gap = 6.0f * scale;
    const float lowWidth = ImGui::CalcTextSize(low.c_str()).x;
    const float texts = lowWidth + ImGui::CalcTextSize(high.c_str()).x + 4.0f * gap;
    const float room = max.x - min.x - 2.0f * kMarginUnits * scale - texts;
    const float bar = std::clamp(room, 24.0f * scale, 140.0f * scale);
    const float width = texts + bar;
    const float margin = kMarginUnits * scale;
    const Vec2 corner(onRight ? max.x - margin - width : min.x + margin, max.y - margin - line - 2.0f * gap);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(im(corner), im(corner + Vec2(width, line + 2.0f * gap)), kPlate, 4.0f * scale);
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
    draw->AddText(im(corner + Vec2(gap)), text, low.c_str());
    const Vec2 begin = corner + Vec2(2.0f * gap + lowWidth, gap);
    constexpr int kSteps = 28;
    for (int i = 0; i < kSteps; ++i) {
        const float share = (static_cast<float>(i) + 0.5f) / kSteps;
        const Vec3 color = isSigned ? signedColor(2.0f * share - 1.0f) : heatColor(share);
        const float step = bar / kSteps;
        const Vec2 at = begin + Vec2(step * static_cast<float>(i), 0.0f);
        draw->AddRectFilled(im(at), im(at + Vec2(step, line)),
                            ImGui::GetColorU32(ImVec4(color.x, color.y, color.z, 1.0f)));
    }
    draw->AddText(im(begin + Vec2(bar + gap, 0.0f)), text, high.c_str());
    ui::area("Scale", corner, corner + Vec2(width, line + 2.0f * gap), fmt::format("{} … {}", low, high));
    return corner.y;
}

/// One scale for both sides where they share it, else on the side that has one. Returns where it begins.
float drawScales(const Workspace& workspace, const ImagePanes& panes, const Area& seen) {
    const bool isSplit = workspace.display.split;
    const bool isOwn = !isSplit || panes.own.source.scale().isThere();
    const ShownImageSource& source = isOwn ? panes.own.source : panes.other.source;
    if (!source.scale().isThere()) { return seen.max.y; }
    const bool isOfBoth = isOwn && (!isSplit || panes.other.source.scale().isThere());
    const bool onRight = !isOfBoth && source.shownIntegrator() == workspace.comparedPair().right;
    return drawScale(source, seen.min, seen.max, onRight);
}

/// In the lower left corner of each side that does not show what is wanted.
void drawNotes(const Workspace& workspace, const Area& seen, float dividerAt, float bottom) {
    const float margin = kMarginUnits * ui::scale();
    const bool isSplit = workspace.display.split;
    const auto reference = workspace.convergence.usableReference();
    const char* widget = "Note";
    for (const auto& snapshot : {workspace.render.snapshot(), workspace.render.otherSnapshot()}) {
        if (!snapshot) { continue; }
        const bool isRight = isSplit && snapshot->integrator == workspace.comparedPair().right;
        const float left = isRight ? std::max(dividerAt, seen.min.x) : seen.min.x;
        const float right = isSplit && !isRight ? std::min(dividerAt, seen.max.x) : seen.max.x;
        const float room = right - left - 2.0f * margin;
        const std::string note = noteInstead(*snapshot, workspace.display.shown, reference.get());
        if (note.empty() || room < 4.0f * ImGui::GetFontSize()) { continue; }
        const Vec2 size = plateSize(note, room);
        const Vec2 corner(left + margin, bottom - margin - size.y);
        drawPlate(note, corner, size);
        ui::area(widget, corner, corner + size, note);
        widget = "Other note";
    }
}

}  // namespace

bool dragDivider(DisplaySettings* settings, Vec2 imageMin, Vec2 imageMax) {
    const float x = dividerX(*settings, imageMin, imageMax);
    const float grab = kGrabUnits * ui::scale();
    const Vec2 min(x - grab, imageMin.y);
    const Vec2 max(x + grab, imageMax.y);
    ImGui::SetCursorScreenPos(im(min));
    ImGui::InvisibleButton("##divider", im(max - min));
    const bool active = ImGui::IsItemActive();
    if (active || ImGui::IsItemHovered()) { ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW); }
    if (active) {
        const float share = (ImGui::GetIO().MousePos.x - imageMin.x) / (imageMax.x - imageMin.x);
        settings->splitAt = std::clamp(share, 0.0f, 1.0f);
    }
    ui::area("Divider", min, max, fmt::format("{:.3f}", settings->splitAt));
    return active;
}

void drawPanes(const Workspace& workspace, const ImagePanes& panes, Vec2 min, Vec2 max) {
    const DisplaySettings& display = workspace.display;
    if (display.split) {
        drawSplit(workspace, panes, min, max);
    } else {
        ImGui::GetWindowDrawList()->AddImage(textureOf(*panes.own.display), im(min), im(max));
    }
    const Area seen = seenPart(min, max);
    const float scaleTop = drawScales(workspace, panes, seen);
    drawNotes(workspace, seen, dividerX(display, min, max), display.split ? scaleTop : seen.max.y);
}

}  // namespace glint
