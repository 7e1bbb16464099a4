#include "viewer/window/split_view.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/panels/units.h"
#include "viewer/window/theme.h"
#include "viewer/window/widgets.h"

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

/// Text on a dark plate; `anchor` is its upper left corner, or the upper right one.
void drawPlate(const std::string& text, Vec2 anchor, bool fromRight) {
    const float scale = ui::scale();
    const Vec2 pad(6.0f * scale, 3.0f * scale);
    const ImVec2 textSize = ImGui::CalcTextSize(text.c_str());
    const Vec2 size = Vec2(textSize.x, textSize.y) + pad * 2.0f;
    const Vec2 corner = fromRight ? anchor - Vec2(size.x, 0.0f) : anchor;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(im(corner), im(corner + size), kPlate, 4.0f * scale);
    draw->AddText(im(corner + pad), ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
}

std::string sideLabel(const char* name, const FilmSnapshot* snapshot) {
    if (snapshot == nullptr) return fmt::format("{}   first pass…", name);
    if (snapshot->previewScale > 1) return fmt::format("{}   preview", name);
    return fmt::format("{}   {} {}   {}", name, grouped(snapshot->passes),
                       snapshot->passes == 1 ? "pass" : "passes", duration(snapshot->renderSeconds));
}

struct Side {
    const char* name;
    const ImageDisplay* display;
    const FilmSnapshot* snapshot;
};

/// The part of the side's picture between the shares `from` and `to` of the width.
void drawSide(const Side& side, Vec2 min, Vec2 max, float from, float to) {
    const float width = max.x - min.x;
    const Vec2 partMin(min.x + width * from, min.y);
    const Vec2 partMax(min.x + width * to, max.y);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->PushClipRect(im(partMin), im(partMax), true);
    if (side.display != nullptr && side.display->texture() != 0) {
        draw->AddImage(reinterpret_cast<ImTextureID>(static_cast<intptr_t>(side.display->texture())),
                       im(partMin), im(partMax), {from, 0.0f}, {to, 1.0f},
                       side.snapshot != nullptr ? IM_COL32_WHITE : kWaiting);
    } else {
        draw->AddRectFilled(im(partMin), im(partMax), kPlate);
    }
    const float margin = kMarginUnits * ui::scale();
    const bool isRight = to == 1.0f && from > 0.0f;
    drawPlate(sideLabel(side.name, side.snapshot),
              {isRight ? partMax.x - margin : partMin.x + margin, min.y + margin}, isRight);
    draw->PopClipRect();
}

void drawSplit(const ViewerModel& model, const Pictures& pictures, Vec2 min, Vec2 max) {
    Side left{"Path tracing", nullptr, nullptr};
    Side right{"SPPM", nullptr, nullptr};
    const auto put = [&](const FilmSnapshot* snapshot, const PictureSource& source,
                         const ImageDisplay* display) {
        const IntegratorKind kind = snapshot != nullptr ? snapshot->integrator : source.shownIntegrator();
        Side& side = kind == IntegratorKind::Sppm ? right : left;
        if (side.display == nullptr) side = {side.name, display, snapshot};
    };
    put(model.snapshot().get(), *pictures.mainSource, pictures.main);
    put(model.otherSnapshot().get(), *pictures.otherSource, pictures.other);
    const float x = dividerX(model.display, min, max);
    const float share = (x - min.x) / (max.x - min.x);
    if (share > 0.0f) drawSide(left, min, max, 0.0f, share);
    if (share < 1.0f) drawSide(right, min, max, share, 1.0f);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float half = std::max(1.0f, ui::scale());
    draw->AddRectFilled({x - 2.0f * half, min.y}, {x + 2.0f * half, max.y}, IM_COL32(0, 0, 0, 110));
    draw->AddRectFilled({x - half, min.y}, {x + half, max.y}, IM_COL32(235, 235, 235, 255));
    draw->AddCircleFilled({x, (min.y + max.y) * 0.5f}, 5.0f * half, IM_COL32(235, 235, 235, 255));
}

std::string heatText(ShownPicture shown, float value) {
    if (shown == ShownPicture::Radius) return length(static_cast<double>(value));
    return fmt::format("{:.3g}", value);
}

/// The colours from the smallest to the largest value, with both.
void drawHeatScale(const PictureSource& source, Vec2 min, Vec2 max) {
    const HeatScale& heat = source.heat();
    if (!(heat.largest > 0.0f)) return;
    const float scale = ui::scale();
    const std::string low = heatText(source.shownKind(), heat.smallest);
    const std::string high = heatText(source.shownKind(), heat.largest) +
                             (source.shownKind() == ShownPicture::Radius ? " radius" : " photons");
    const float line = ImGui::GetFontSize();
    const float gap = 6.0f * scale;
    const float bar = 140.0f * scale;
    const float lowWidth = ImGui::CalcTextSize(low.c_str()).x;
    const float width = lowWidth + bar + ImGui::CalcTextSize(high.c_str()).x + 4.0f * gap;
    const Vec2 corner(min.x + kMarginUnits * scale, max.y - kMarginUnits * scale - line - 2.0f * gap);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(im(corner), im(corner + Vec2(width, line + 2.0f * gap)), kPlate, 4.0f * scale);
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
    draw->AddText(im(corner + Vec2(gap)), text, low.c_str());
    const Vec2 begin = corner + Vec2(2.0f * gap + lowWidth, gap);
    constexpr int kSteps = 28;
    for (int i = 0; i < kSteps; ++i) {
        const Vec3 color = heatColor((static_cast<float>(i) + 0.5f) / kSteps);
        const float step = bar / kSteps;
        const Vec2 at = begin + Vec2(step * static_cast<float>(i), 0.0f);
        draw->AddRectFilled(im(at), im(at + Vec2(step, line)),
                            ImGui::GetColorU32(ImVec4(color.x, color.y, color.z, 1.0f)));
    }
    draw->AddText(im(begin + Vec2(bar + gap, 0.0f)), text, high.c_str());
}

}  // namespace

bool dragDivider(DisplaySettings* settings, Vec2 pictureMin, Vec2 pictureMax) {
    const float x = dividerX(*settings, pictureMin, pictureMax);
    const float grab = kGrabUnits * ui::scale();
    const Vec2 min(x - grab, pictureMin.y);
    const Vec2 max(x + grab, pictureMax.y);
    ImGui::SetCursorScreenPos(im(min));
    ImGui::InvisibleButton("##divider", im(max - min));
    const bool active = ImGui::IsItemActive();
    if (active || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (active) {
        const float share = (ImGui::GetIO().MousePos.x - pictureMin.x) / (pictureMax.x - pictureMin.x);
        settings->splitAt = std::clamp(share, 0.0f, 1.0f);
    }
    ui::area("Divider", min, max, fmt::format("{:.3f}", settings->splitAt));
    return active;
}

void drawPictures(const ViewerModel& model, const Pictures& pictures, Vec2 min, Vec2 max) {
    if (model.display.split) {
        drawSplit(model, pictures, min, max);
    } else {
        ImGui::GetWindowDrawList()->AddImage(
            reinterpret_cast<ImTextureID>(static_cast<intptr_t>(pictures.main->texture())), im(min), im(max));
    }
    const bool mainHasScale = pictures.mainSource->heat().largest > 0.0f;
    if (mainHasScale || model.display.split)
        drawHeatScale(mainHasScale ? *pictures.mainSource : *pictures.otherSource, min, max);
}

}  // namespace glint
