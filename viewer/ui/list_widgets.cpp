// Lines of lists: with a colour patch or a picture in front.
#include <cstdint>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/ui/widget_row.h"
#include "viewer/ui/widgets.h"

namespace glint::ui {

bool selectable(const char* label, bool selected, const Vec3* swatch) {
    const float side = ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float indent = swatch != nullptr ? side + ImGui::GetStyle().ItemInnerSpacing.x * 1.5f : 0.0f;
    const bool pressed = ImGui::Selectable(fmt::format("##{}", label).c_str(), selected);
    record(WidgetKind::Button, label, selected ? "selected" : "");
    ImDrawList* draw = ImGui::GetWindowDrawList();
    if (swatch != nullptr) {
        const float inset = side * 0.14f;
        draw->AddRectFilled({corner.x + inset, corner.y + inset},
                            {corner.x + side - inset, corner.y + side - inset},
                            ImGui::GetColorU32(screenColor4(*swatch)), 3.0f * scale());
    }
    draw->AddText({corner.x + indent, corner.y}, ImGui::GetColorU32(ImGuiCol_Text), label);
    return pressed;
}

bool imageLine(const char* label, const ImagePart& image, const Vec3& swatch, float height) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float side = height * scale(), inset = scale();
    const bool pressed = ImGui::Selectable(fmt::format("##{}", label).c_str(), false, 0, {0.0f, side});
    record(WidgetKind::Button, label, image.texture != 0 ? "pictured" : "");
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const ImVec2 min{corner.x + inset, corner.y + inset};
    const ImVec2 max{corner.x + side - inset, corner.y + side - inset};
    if (image.texture != 0) {
        draw->AddImage(reinterpret_cast<ImTextureID>(static_cast<intptr_t>(image.texture)), min, max,
                       {image.min.x, image.min.y}, {image.max.x, image.max.y});
    } else {
        draw->AddRectFilled(min, max, ImGui::GetColorU32(screenColor4(swatch)), 3.0f * scale());
    }
    draw->AddText({max.x + ImGui::GetStyle().ItemInnerSpacing.x * 1.5f,
                   corner.y + 0.5f * (side - ImGui::GetFontSize())},
                  ImGui::GetColorU32(ImGuiCol_Text), label);
    return pressed;
}

}  // namespace glint::ui
