#include "viewer/window/key_help.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"
#include "viewer/window/key_input.h"

namespace glint {
namespace {

constexpr float kColumnUnits = 480.0f;
constexpr float kKeysUnits = 180.0f;

/// Keys and what they do, side by side.
void drawTexts(const ImVec2& corner, const std::string& keys, const char* does, const ImVec4& color) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddText(corner, ImGui::GetColorU32(color), keys.c_str());
    draw->AddText({corner.x + kKeysUnits * ui::scale(), corner.y}, ImGui::GetColorU32(ImGuiCol_Text), does);
}

}  // namespace

void KeyHelp::close(KeyMap* keys) {
    if (!keys->asked) { isShown_ = false; }
    keys->asked.reset();
    typed_.reset();
    note_.clear();
}

/// Once the key is up again, so that it does nothing else.
void KeyHelp::takeKey(KeyMap* keys) {
    if (!keys->asked) { return; }
    if (const auto chord = pressedChord()) { typed_ = chord; }
    if (!typed_ || isDown(*typed_)) { return; }
    note_ = keys->assign(*keys->asked, *typed_);
    keys->asked.reset();
    typed_.reset();
}

void KeyHelp::drawKeyRow(KeyMap* keys, const KeyActionInfo& info) {
    const bool isAsked = keys->asked == info.action;
    ImGui::PushID(info.name);
    const float width = (kColumnUnits - 14.0f) * ui::scale();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable("##key", isAsked, 0, {width, ImGui::GetTextLineHeight()})) {
        keys->asked = info.action;
        typed_.reset();
        note_.clear();
    }
    const std::string text = isAsked ? "press a key…" : keys->textOf(info.action);
    ui::itemArea(fmt::format("Key of {}", info.name).c_str(), text);
    const bool isMarked = isAsked || keys->isChanged(info.action);
    drawTexts(corner, text, info.does, isMarked ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : theme::kTextDim);
    ImGui::PopID();
}

/// The mouse first; in two columns where there is room.
void KeyHelp::drawRows(KeyMap* keys) {
    const auto mouse = mouseInputs();
    const auto actions = keyActions();
    const size_t count = mouse.size() + actions.size();
    const bool isWide = ImGui::GetContentRegionAvail().x > 1.8f * kColumnUnits * ui::scale();
    const size_t half = isWide ? (count + 1) / 2 : count;
    ImGui::Columns(isWide ? 2 : 1, "##columns", false);
    for (size_t i = 0; i < count; ++i) {
        if (i == half) { ImGui::NextColumn(); }
        if (i >= mouse.size()) {
            drawKeyRow(keys, actions[i - mouse.size()]);
            continue;
        }
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        ImGui::Dummy({1.0f, ImGui::GetTextLineHeight()});
        drawTexts(corner, mouse[i].input, mouse[i].does, theme::kTextDim);
    }
    ImGui::Columns(1);
}

void KeyHelp::drawButtons(KeyMap* keys) {
    const float width = 150.0f * ui::scale();
    if (keys->asked) {
        if (ui::button("Its first key", width, "The key that it has without any change")) {
            note_ = keys->reset(*keys->asked);
            keys->asked.reset();
        }
    } else if (ui::button("All first keys", width, "Undoes every change of a key")) {
        keys->resetAll();
        note_.clear();
    }
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    const std::string text = keys->asked     ? "Press the new key; Esc keeps the old one."
                             : note_.empty() ? "Click on a line to give it another key."
                                             : note_ + ".";
    ImGui::TextColored(note_.empty() ? theme::kTextDim : theme::kTextError, "%s", text.c_str());
    ui::itemArea("Key note", text);
}

void KeyHelp::draw(KeyMap* keys) {
    takeKey(keys);
    if (!isShown_) {
        keys->asked.reset();
        return;
    }
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float scale = ui::scale();
    const float width = std::min((2.0f * kColumnUnits + 44.0f) * scale, size.x - 20.0f * scale);
    ImGui::SetNextWindowPos({size.x * 0.5f, size.y * 0.5f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, size.y - 20.0f * scale});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(22.0f * scale, 14.0f * scale));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8.0f * scale);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.13f, 0.13f, 0.13f, 0.97f));
    ImGui::Begin("##help", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    ui::leaveSection();
    ImGui::PushFont(ui::fonts().heading);
    ImGui::TextUnformatted("Mouse and keyboard");
    ImGui::PopFont();
    drawButtons(keys);
    ImGui::Dummy({0.0f, 2.0f * scale});
    drawRows(keys);
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

}  // namespace glint
