// The edits so far, and the way back to each of them.
#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/model/edit_history.h"
#include "viewer/model/key_map.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr size_t kRowsShown = 8;

bool drawAction(const char* label, bool isPossible, float width, const char* tooltip) {
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, isPossible ? 1.0f : 0.5f);
    const bool isClicked = ui::button(label, width, tooltip);
    ImGui::PopStyleVar();
    return isClicked && isPossible;
}

/// The newest first; what was undone is dim.
void drawStates(EditHistory* history) {
    const auto& states = history->states();
    const float row = ImGui::GetTextLineHeightWithSpacing();
    const auto rows = static_cast<float>(std::min(states.size(), kRowsShown));
    ImGui::BeginChild("##states", {0.0f, rows * row}, false, ImGuiWindowFlags_NavFlattened);
    for (size_t i = states.size(); i-- > 0;) {
        const bool isUndone = i > history->present();
        const ImVec4 color = isUndone ? theme::kTextDim : ImGui::GetStyleColorVec4(ImGuiCol_Text);
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        const std::string label = fmt::format("{}. {}", i + 1, states[i].name);
        if (ui::selectable(label.c_str(), i == history->present())) { history->ask(i); }
        ImGui::PopStyleColor();
    }
    ImGui::EndChild();
}

void draw(EditHistory* history, const KeyMap* keys) {
    const float width = ui::buttonWidth(2);
    const std::string undoes = keys->tip("A film that is held goes on where it was", KeyAction::Undo);
    if (drawAction("Undo", history->canUndo(), width, undoes.c_str())) { history->askUndo(); }
    ImGui::SameLine();
    const std::string redoes = keys->tip("What was undone last", KeyAction::Redo);
    if (drawAction("Redo", history->canRedo(), width, redoes.c_str())) { history->askRedo(); }
    drawStates(history);
}

}  // namespace

Panel historyPanel() { return {"History", false, OfParts<draw>::call, WithoutScene::Hides}; }

}  // namespace glint
