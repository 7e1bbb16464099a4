#include "viewer/ui/keyboard_walk.h"

#include <string_view>

#include <imgui_internal.h>

namespace glint::ui {

void prepareWalk() {
    ImGuiIO& io = ImGui::GetIO();
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    const std::string_view window =
        context.NavWindow != nullptr ? context.NavWindow->RootWindow->Name : "##image";
    const bool isQuestion = window != "##panels" && window != "##image";
    // A walk that has just begun has marked no widget yet.
    if (!context.NavDisableHighlight || isQuestion || context.OpenPopupStack.Size > 0) {
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    } else {
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    }
    const int enter = io.KeyMap[ImGuiKey_Enter];
    if (isWalking() && enter >= 0 && io.KeysDown[enter]) { io.NavInputs[ImGuiNavInput_Activate] = 1.0f; }
}

void beginWalkHere() {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    ImGui::FocusWindow(window);
    ImGui::NavInitWindow(window, true);
    context.NavDisableHighlight = false;
    context.NavDisableMouseHover = true;
}

bool isWalking() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    return context.NavId != 0 && !context.NavDisableHighlight;
}

void endWalk() {
    if (ImGui::GetCurrentContext()->NavWindow == nullptr) { return; }
    ImGui::SetNavID(0, ImGuiNavLayer_Main, 0, ImRect());
    ImGui::GetCurrentContext()->NavDisableHighlight = true;
}

bool isEntered() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    return context.NavActivateInputId != 0 && context.NavActivateInputId == ImGui::GetItemID();
}

}  // namespace glint::ui
