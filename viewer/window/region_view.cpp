#include "viewer/window/region_view.h"

#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/ui/widgets.h"
#include "viewer/window/key_input.h"

namespace glint {
namespace {

constexpr int kLeastSide = 2;  // pixels: less is a click

constexpr ImU32 kRegionColor = IM_COL32(255, 200, 80, 255);
constexpr ImU32 kAreaColor = IM_COL32(120, 200, 255, 255);

void drawFrame(const char* name, const FilmRegion& region, const PlacedImage& placed, ImU32 color) {
    const Vec2 min = placed.min + Vec2(region.x0, region.y0) * placed.unitsPerPixel;
    const Vec2 max = placed.min + Vec2(region.x1, region.y1) * placed.unitsPerPixel;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float line = ui::scale();
    draw->AddRect({min.x - line, min.y - line}, {max.x + line, max.y + line}, IM_COL32(0, 0, 0, 160), 0.0f, 0,
                  3.0f * line);
    draw->AddRect({min.x - line, min.y - line}, {max.x + line, max.y + line}, color, 0.0f, 0, line);
    ui::area(name, min, max, fmt::format("{} {} {} {}", region.x0, region.y0, region.x1, region.y1));
}

}  // namespace

bool RegionView::handle(Workspace* workspace, const PlacedImage& placed, const std::optional<Vec2i>& hovered,
                        bool held) {
    const ImGuiIO& io = ImGui::GetIO();
    RegionTool& tool = workspace->region;
    const bool isSpot = hovered && isHeld(workspace->keys, KeyAction::Spot);
    tool.spot.reset();
    if (isSpot) { tool.spot = spotAround(*hovered, workspace->document.draft().resolution.height); }
    Inspector& inspector = workspace->inspector;
    if (!tool.picks && !inspector.picksArea) {
        began_.reset();
        return false;
    }
    if (hovered) { ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNWSE); }
    if (held && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        if (!began_) { began_ = pixelAt(placed, {io.MouseClickedPos[0].x, io.MouseClickedPos[0].y}); }
        at_ = pixelAt(placed, {io.MousePos.x, io.MousePos.y});
    } else if (const auto began = std::exchange(began_, std::nullopt)) {
        at_ = pixelAt(placed, {io.MousePos.x, io.MousePos.y});
        const Resolution& size = workspace->document.draft().resolution;
        const auto region = clipped(regionBetween(*began, at_), size.width, size.height);
        const bool isLarge =
            region && region->x1 - region->x0 >= kLeastSide && region->y1 - region->y0 >= kLeastSide;
        if (isLarge && inspector.picksArea) {
            inspector.area = region;
            inspector.statisticsOf.reset();
        } else if (isLarge) {
            tool.drawn = region;
        }
        tool.picks = inspector.picksArea = false;
    }
    return true;
}

void RegionView::draw(const Workspace& workspace, const PlacedImage& placed) const {
    const RegionTool& tool = workspace.region;
    const Resolution& size = workspace.document.draft().resolution;
    if (workspace.inspector.area) {
        drawFrame("Measured area", *workspace.inspector.area, placed, kAreaColor);
    }
    const auto wanted = began_ ? std::optional(regionBetween(*began_, at_)) : tool.wanted();
    const auto region = wanted ? clipped(*wanted, size.width, size.height) : std::nullopt;
    if (!region) { return; }
    drawFrame("Region", *region, placed, kRegionColor);
}

}  // namespace glint
