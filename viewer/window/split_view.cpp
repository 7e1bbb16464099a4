#include "viewer/window/split_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/base/units.h"
#include "viewer/ui/im_vec.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"
#include "viewer/window/image_notes.h"

namespace glint {
namespace {

constexpr float kGrabUnits = 5.0f;  // each side of the divider
constexpr ImU32 kEmpty = IM_COL32(20, 20, 20, 190);
constexpr ImU32 kWaiting = IM_COL32(110, 110, 110, 255);  // tint of a picture that is not of this scene

ImTextureID textureOf(const ImageDisplay& display) {
    return reinterpret_cast<ImTextureID>(static_cast<intptr_t>(display.texture()));
}

WindowArea wholeWindow() {
    const ImVec2 corner = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    return {{corner.x, corner.y}, {corner.x + size.x, corner.y + size.y}};
}

float middleOfWindow() { return std::floor(ImGui::GetWindowPos().x + ImGui::GetWindowSize().x * 0.5f); }

/// The part of the picture that `area` shows.
WindowArea seenPart(const PlacedImage& placed, const WindowArea& area) {
    return {glm::max(placed.min, area.min), glm::min(placed.max, area.max)};
}

/// What a side shows, from the full text to the shortest one.
using SideLabels = std::array<std::string, 4>;

struct Side {
    SideLabels labels;
    const ImageDisplay* display = nullptr;
    bool isOfScene = false;  ///< not of the scene before
};

struct Sides {
    Side left;
    Side right;
};

SideLabels labelsOf(const IntegratorInfo& integrator, const FilmSnapshot* snapshot) {
    const std::string name = integrator.displayName;
    const std::string shortName = inCapitals(integrator.alias);
    if (snapshot == nullptr) { return {fmt::format("{}   first pass…", name), name, shortName, ""}; }
    if (snapshot->previewScale > 1) { return {fmt::format("{}   preview", name), name, shortName, ""}; }
    const std::string passes = fmt::format("{}   {}", name, passCount(snapshot->passes));
    return {fmt::format("{}   {}", passes, duration(snapshot->renderSeconds)), passes, name, shortName};
}

SideLabels labelsOf(const KeptRender& kept) {
    return {fmt::format("{}   {}", kept.name(), kept.summary), kept.name(), std::to_string(kept.number), ""};
}

Sides integratorSides(const Workspace& workspace, const ImagePanes& panes) {
    const ComparedPair pair = workspace.comparedPair();
    Sides sides{{labelsOf(integratorInfo(pair.left), nullptr)},
                {labelsOf(integratorInfo(pair.right), nullptr)}};
    const auto put = [&](const FilmSnapshot* snapshot, const ImagePane& pane) {
        const IntegratorKind kind =
            snapshot != nullptr ? snapshot->integrator : pane.source.shownIntegrator();
        for (const bool isRight : {false, true}) {
            Side& side = isRight ? sides.right : sides.left;
            const bool isFree = kind == (isRight ? pair.right : pair.left) && side.display == nullptr;
            if (!isFree) { continue; }
            side = {labelsOf(integratorInfo(kind), snapshot), pane.display.get(), snapshot != nullptr};
        }
    };
    put(workspace.render.snapshot().get(), panes.own);
    put(workspace.render.otherSnapshot().get(), panes.other);
    return sides;
}

Sides sidesOf(const Workspace& workspace, const ImagePanes& panes) {
    const KeptRender* left = workspace.snapshots.find(workspace.snapshots.left);
    if (left == nullptr) { return integratorSides(workspace, panes); }
    const KeptRender* right = workspace.snapshots.find(workspace.snapshots.right);
    const FilmSnapshot* live = workspace.render.snapshot().get();
    const IntegratorKind kind = workspace.document.draft().options.integrator;
    return {{labelsOf(*left), panes.other.display.get(), true},
            {right != nullptr ? labelsOf(*right) : labelsOf(integratorInfo(kind), live),
             panes.own.display.get(), true}};
}

/// What is seen of the side's picture in `area`, with its label.
void drawSide(const Side& side, const PlacedImage& placed, const WindowArea& area, bool isRight) {
    const WindowArea seen = seenPart(placed, area);
    if (seen.min.x >= seen.max.x) { return; }
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->PushClipRect(im(seen.min), im(seen.max), true);
    if (side.display != nullptr && side.display->texture() != 0) {
        draw->AddImage(textureOf(*side.display), im(placed.min), im(placed.max), {0.0f, 0.0f}, {1.0f, 1.0f},
                       side.isOfScene ? IM_COL32_WHITE : kWaiting);
    } else {
        draw->AddRectFilled(im(seen.min), im(seen.max), kEmpty);
    }
    const float margin = noteMargin();
    for (const std::string& label : side.labels) {
        const Vec2 size = plateSize(label, 0.0f);
        if (label.empty() || size.x > seen.max.x - seen.min.x - 2.0f * margin) { continue; }
        const float x = isRight ? seen.max.x - margin - size.x : seen.min.x + margin;
        drawPlate(label, {x, seen.min.y + margin}, size);
        ui::area(isRight ? "Right side" : "Left side", seen.min, seen.max, label);
        break;
    }
    draw->PopClipRect();
}

void drawWipe(const Sides& sides, const PlacedImage& placed, float x) {
    WindowArea left = wholeWindow();
    WindowArea right = left;
    left.max.x = right.min.x = x;
    drawSide(sides.left, placed, left, false);
    drawSide(sides.right, placed, right, x > seenPart(placed, wholeWindow()).min.x);
    const auto [min, max] = seenPart(placed, wholeWindow());
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float half = std::max(1.0f, ui::scale());
    draw->AddRectFilled({x - 2.0f * half, min.y}, {x + 2.0f * half, max.y}, IM_COL32(0, 0, 0, 110));
    draw->AddRectFilled({x - half, min.y}, {x + half, max.y}, IM_COL32(235, 235, 235, 255));
    draw->AddCircleFilled({x, (min.y + max.y) * 0.5f}, 5.0f * half, IM_COL32(235, 235, 235, 255));
}

void drawSideBySide(const Sides& sides, const PlacedImage& placed) {
    WindowArea left = wholeWindow();
    WindowArea right = left;
    left.max.x = right.min.x = middleOfWindow();
    PlacedImage moved = placed;
    const float offset = middleOfWindow() - left.min.x;
    moved.min.x += offset;
    moved.max.x += offset;
    drawSide(sides.left, placed, left, false);
    drawSide(sides.right, moved, right, true);
    ImGui::GetWindowDrawList()->AddLine({right.min.x, left.min.y}, {right.min.x, left.max.y},
                                        IM_COL32(235, 235, 235, 255), ui::scale());
}

void drawDifference(const Workspace& workspace, const ImagePanes& panes, const PlacedImage& placed) {
    const WindowArea seen = seenPart(placed, wholeWindow());
    const ShownDifference::Made* made = panes.differenceOf.get();
    const bool isSigned = workspace.display.compareView == CompareView::SignedDifference;
    std::string label = "Comparing…";
    if (made != nullptr && made->of.view == workspace.display.compareView) {
        label = "Pictures of different sizes have no difference";
        if (!made->rgba.empty()) {
            ImGui::GetWindowDrawList()->AddImage(textureOf(*panes.difference), im(placed.min),
                                                 im(placed.max));
            const float largest = made->scale.heat.largest;
            drawScale(isSigned ? ScaleTexts{fmt::format("{:.2g}", -largest), fmt::format("{:.2g}", largest)}
                               : ScaleTexts{"0", "1"},
                      isSigned, seen, false);
            label =
                fmt::format("{}   mean {:.3g}", isSigned ? "Left − right, luminance" : "FLIP", made->mean);
        }
    }
    const Vec2 size = plateSize(label, 0.0f);
    drawPlate(label, seen.min + noteMargin(), size);
    ui::area("Difference", seen.min, seen.max, label);
}

void drawCompared(const Workspace& workspace, const ImagePanes& panes, const PlacedImage& placed) {
    const DisplaySettings& display = workspace.display;
    if (isDifference(display.compareView)) { return drawDifference(workspace, panes, placed); }
    const Sides sides = sidesOf(workspace, panes);
    if (display.compareView == CompareView::Wipe) {
        return drawWipe(sides, placed, dividerX(display, placed));
    }
    if (display.compareView == CompareView::SideBySide) { return drawSideBySide(sides, placed); }
    drawSide(display.flipsToRight ? sides.right : sides.left, placed, wholeWindow(), display.flipsToRight);
}

bool isOnRight(const Workspace& workspace, IntegratorKind kind, bool isOwn) {
    return workspace.snapshots.isComparing() ? isOwn : kind == workspace.comparedPair().right;
}

/// One scale for both sides where they share it, else on the side that has one. Returns where it begins.
float drawScales(const Workspace& workspace, const ImagePanes& panes, const WindowArea& seen) {
    const bool isSplit = workspace.isComparing();
    const bool isOwn = !isSplit || panes.own.source.scale().isThere();
    const ShownImageSource& source = isOwn ? panes.own.source : panes.other.source;
    if (!source.scale().isThere()) { return seen.max.y; }
    const bool isOfBoth = isOwn && (!isSplit || panes.other.source.scale().isThere());
    const HeatScale& heat = source.scale().heat;
    const bool isSigned = source.scale().isSigned;
    const ShownImageInfo& info = infoOf(source.shownImage());
    return drawScale({info.scaleText(isSigned ? -heat.largest : heat.smallest),
                      fmt::format("{} {}", info.scaleText(heat.largest), info.unit)},
                     isSigned, seen, !isOfBoth && isOnRight(workspace, source.shownIntegrator(), isOwn));
}

/// In the lower left corner of each side that does not show what is wanted.
void drawNotes(const Workspace& workspace, const WindowArea& seen, float dividerAt, float bottom) {
    const float margin = noteMargin();
    const bool isSplit = workspace.isComparing();
    const auto reference = workspace.convergence.usableReference();
    const char* widget = "Note";
    for (const bool isOwn : {true, false}) {
        const auto& snapshot = isOwn ? workspace.ownImage() : workspace.otherImage();
        if (!snapshot || (!isOwn && !isSplit)) { continue; }
        const bool isRight = isSplit && isOnRight(workspace, snapshot->integrator, isOwn);
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

bool hasDivider(const Workspace& workspace) {
    return workspace.isComparing() && workspace.display.compareView == CompareView::Wipe;
}

bool isSideBySide(const Workspace& workspace) {
    return workspace.isComparing() && workspace.display.compareView == CompareView::SideBySide;
}

bool seesRight(const Workspace& workspace, const PlacedImage& placed, float x) {
    const DisplaySettings& display = workspace.display;
    if (isSideBySide(workspace)) { return x >= middleOfWindow(); }
    return display.compareView == CompareView::Flip ? display.flipsToRight : x > dividerX(display, placed);
}

float dividerX(const DisplaySettings& settings, const PlacedImage& placed) {
    const WindowArea seen = seenPart(placed, wholeWindow());
    return std::floor(seen.min.x + (seen.max.x - seen.min.x) * settings.splitAt);
}

bool dragDivider(DisplaySettings* settings, const PlacedImage& placed) {
    const WindowArea seen = seenPart(placed, wholeWindow());
    const float x = dividerX(*settings, placed);
    const float grab = kGrabUnits * ui::scale();
    const Vec2 min(x - grab, seen.min.y);
    const Vec2 max(x + grab, seen.max.y);
    ImGui::SetCursorScreenPos(im(min));
    ImGui::InvisibleButton("##divider", im(max - min));
    const bool active = ImGui::IsItemActive();
    if (active || ImGui::IsItemHovered()) { ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW); }
    if (active) {
        const float share = (ImGui::GetIO().MousePos.x - seen.min.x) / (seen.max.x - seen.min.x);
        settings->splitAt = std::clamp(share, 0.0f, 1.0f);
    }
    ui::area("Divider", min, max, fmt::format("{:.3f}", settings->splitAt));
    return active;
}

void drawPanes(const Workspace& workspace, const ImagePanes& panes, const PlacedImage& placed) {
    if (workspace.isComparing()) {
        drawCompared(workspace, panes, placed);
        if (isSideBySide(workspace)) { drawScales(workspace, panes, wholeWindow()); }
        if (!hasDivider(workspace)) { return; }
    } else {
        ImGui::GetWindowDrawList()->AddImage(textureOf(*panes.own.display), im(placed.min), im(placed.max));
    }
    const WindowArea seen = seenPart(placed, wholeWindow());
    const float scaleTop = drawScales(workspace, panes, seen);
    drawNotes(workspace, seen, dividerX(workspace.display, placed),
              workspace.isComparing() ? scaleTop : seen.max.y);
}

}  // namespace glint
