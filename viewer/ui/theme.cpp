#include "viewer/ui/theme.h"

#include <imgui.h>

namespace glint {
namespace theme {

const ImVec4 kTextDim{0.62f, 0.62f, 0.62f, 1.0f};
const ImVec4 kTextError{0.95f, 0.55f, 0.48f, 1.0f};
const ImVec4 kTextWarning{0.90f, 0.76f, 0.45f, 1.0f};
const ImVec4 kAccent{0.40f, 0.40f, 0.40f, 1.0f};
const ImVec4 kPanelBackground{0.165f, 0.165f, 0.165f, 1.0f};
const ImVec4 kImageBackground{0.115f, 0.115f, 0.115f, 1.0f};

}  // namespace theme

namespace {

ImVec4 grey(float level, float alpha = 1.0f) { return {level, level, level, alpha}; }

void setColors(ImGuiStyle* style) {
    ImVec4* colors = style->Colors;
    colors[ImGuiCol_Text] = grey(0.90f);
    colors[ImGuiCol_TextDisabled] = grey(0.50f);
    colors[ImGuiCol_WindowBg] = theme::kPanelBackground;
    colors[ImGuiCol_ChildBg] = grey(0.13f);
    colors[ImGuiCol_PopupBg] = grey(0.13f, 0.98f);
    colors[ImGuiCol_Border] = grey(0.28f);
    colors[ImGuiCol_BorderShadow] = grey(0.0f, 0.0f);
    colors[ImGuiCol_FrameBg] = grey(0.105f);
    colors[ImGuiCol_FrameBgHovered] = grey(0.135f);
    colors[ImGuiCol_FrameBgActive] = grey(0.085f);
    colors[ImGuiCol_ScrollbarBg] = grey(0.165f, 0.0f);
    colors[ImGuiCol_ScrollbarGrab] = grey(0.30f);
    colors[ImGuiCol_ScrollbarGrabHovered] = grey(0.38f);
    colors[ImGuiCol_ScrollbarGrabActive] = grey(0.46f);
    colors[ImGuiCol_CheckMark] = grey(0.88f);
    colors[ImGuiCol_SliderGrab] = grey(0.36f);
    colors[ImGuiCol_SliderGrabActive] = grey(0.48f);
    colors[ImGuiCol_Button] = grey(0.255f);
    colors[ImGuiCol_ButtonHovered] = grey(0.32f);
    colors[ImGuiCol_ButtonActive] = grey(0.21f);
    colors[ImGuiCol_Header] = grey(0.215f);
    colors[ImGuiCol_HeaderHovered] = grey(0.26f);
    colors[ImGuiCol_HeaderActive] = grey(0.235f);
    colors[ImGuiCol_Separator] = grey(0.26f);
    colors[ImGuiCol_SeparatorHovered] = grey(0.40f);
    colors[ImGuiCol_SeparatorActive] = grey(0.50f);
    colors[ImGuiCol_PlotHistogram] = grey(0.48f);
    colors[ImGuiCol_TextSelectedBg] = grey(0.38f);
    colors[ImGuiCol_NavHighlight] = grey(0.88f);
}

}  // namespace

void applyTheme(float scale) {
    ImGuiStyle style;
    setColors(&style);
    style.WindowPadding = {12.0f, 10.0f};
    style.FramePadding = {8.0f, 4.0f};
    style.ItemSpacing = {8.0f, 5.0f};
    style.ItemInnerSpacing = {5.0f, 4.0f};
    style.IndentSpacing = 14.0f;
    style.ScrollbarSize = 11.0f;
    style.GrabMinSize = 10.0f;
    style.WindowBorderSize = 0.0f;
    style.ChildBorderSize = 0.0f;
    style.PopupBorderSize = 1.0f;
    style.WindowRounding = 0.0f;
    style.ChildRounding = 4.0f;
    style.FrameRounding = 4.0f;
    style.PopupRounding = 5.0f;
    style.ScrollbarRounding = 6.0f;
    style.GrabRounding = 3.0f;
    style.WindowTitleAlign = {0.0f, 0.5f};
    style.ScaleAllSizes(scale);
    style.PopupBorderSize = 1.0f;
    ImGui::GetStyle() = style;
}

}  // namespace glint
