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

/// So that the present state is seen, also after many steps at once.
void scrollToPresent(size_t row, float height) {
    ImGuiStorage* storage = ImGui::GetStateStorage();
    const ImGuiID key = ImGui::GetID("present");
    const int wanted = static_cast<int>(row);
    if (storage->GetInt(key, 0) == wanted) { return; }
    storage->SetInt(key, wanted);
    const float top = static_cast<float>(row) * height;
    const float last = ImGui::GetScrollY() + static_cast<float>(kRowsShown - 1) * height;
    if (top < ImGui::GetScrollY() || top > last) {
        ImGui::SetScrollY(top - 0.5f * static_cast<float>(kRowsShown - 1) * height);
    }
}

void drawState(EditHistory* history, size_t index) {
    const bool isUndone = index > history->present();
    const ImVec4 color = isUndone ? theme::kTextDim : ImGui::GetStyleColorVec4(ImGuiCol_Text);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    const std::string label = fmt::format("{}. {}", index + 1, history->name(index));
    if (ui::selectable(label.c_str(), index == history->present())) { history->ask(index); }
    ImGui::PopStyleColor();
}

/// The newest first; what was undone is dim. Only the rows in view are made, and one on each side, for the
/// keyboard to go on to.
void drawStates(EditHistory* history) {
    const size_t count = history->size();
    const float row = ImGui::GetTextLineHeightWithSpacing();
    const auto rows = static_cast<float>(std::min(count, kRowsShown));
    ImGui::BeginChild("##states", {0.0f, rows * row}, false, ImGuiWindowFlags_NavFlattened);
    scrollToPresent(count - 1 - history->present(), row);
    const auto top = static_cast<size_t>(ImGui::GetScrollY() / row);
    const size_t first = top > 0 ? top - 1 : 0;
    const size_t last = std::min(count, top + kRowsShown + 2);
    ImGui::SetCursorPosY(static_cast<float>(first) * row);
    for (size_t i = first; i < last; ++i) {
        drawState(history, count - 1 - i);
    }
    if (last < count) { ImGui::Dummy({1.0f, static_cast<float>(count - last) * row}); }
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
