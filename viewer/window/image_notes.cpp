#include "viewer/window/image_notes.h"

#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/ui/im_vec.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr float kMarginUnits = 8.0f;
constexpr float kPlatePadX = 6.0f;
constexpr float kPlatePadY = 3.0f;
constexpr ImU32 kPlate = IM_COL32(20, 20, 20, 190);

}  // namespace

float noteMargin() { return kMarginUnits * ui::scale(); }

Vec2 plateSize(const std::string& text, float room) {
    const Vec2 pad = Vec2(kPlatePadX, kPlatePadY) * ui::scale();
    const float wrap = room > 0.0f ? std::max(room - 2.0f * pad.x, 1.0f) : 0.0f;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
    return Vec2(size.x, size.y) + pad * 2.0f;
}

void drawPlate(const std::string& text, Vec2 corner, Vec2 size) {
    const Vec2 pad = Vec2(kPlatePadX, kPlatePadY) * ui::scale();
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(im(corner), im(corner + size), kPlate, 4.0f * ui::scale());
    // Half a pixel more, so that rounding does not wrap what was measured to fit.
    draw->AddText(ImGui::GetFont(), ImGui::GetFontSize(), im(corner + pad), ImGui::GetColorU32(ImGuiCol_Text),
                  text.c_str(), nullptr, size.x - 2.0f * pad.x + 0.5f);
}

float drawScale(const ScaleTexts& texts, bool isSigned, const WindowArea& area, bool onRight) {
    const float scale = ui::scale();
    const float line = ImGui::GetFontSize();
    const float gap = 6.0f * scale;
    const float lowWidth = ImGui::CalcTextSize(texts.low.c_str()).x;
    const float taken = lowWidth + ImGui::CalcTextSize(texts.high.c_str()).x + 4.0f * gap;
    const float margin = noteMargin();
    const float room = area.max.x - area.min.x - 2.0f * margin - taken;
    const float bar = std::clamp(room, 24.0f * scale, 140.0f * scale);
    const float width = taken + bar;
    const Vec2 corner(onRight ? area.max.x - margin - width : area.min.x + margin,
                      area.max.y - margin - line - 2.0f * gap);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(im(corner), im(corner + Vec2(width, line + 2.0f * gap)), kPlate, 4.0f * scale);
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
    draw->AddText(im(corner + Vec2(gap)), text, texts.low.c_str());
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
    draw->AddText(im(begin + Vec2(bar + gap, 0.0f)), text, texts.high.c_str());
    ui::area("Scale", corner, corner + Vec2(width, line + 2.0f * gap),
             fmt::format("{} … {}", texts.low, texts.high));
    return corner.y;
}

}  // namespace glint
