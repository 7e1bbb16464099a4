#include "viewer/ui/typed_number.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "viewer/base/quantity.h"
#include "viewer/ui/keyboard_walk.h"
#include "viewer/ui/theme.h"

namespace glint::ui {
namespace {

constexpr double kNoteSeconds = 4.0;

/// One field at a time has the keyboard.
struct Typing {
    ImGuiID field = 0;  // 0: none
    std::string text;
    std::string before;  // the text at the beginning: no edit
    int seenAtFrame = 0;
    bool wasActive = false;
    bool nextFieldBegins = false;  // Tab was pressed
};
Typing typing;

/// The field that was drawn last: where Shift + Tab leads.
struct Drawn {
    ImGuiID field = 0;
    double value = 0.0;
};
Drawn lastDrawn;

struct Note {
    ImGuiID field = 0;
    std::string text;
    double until = 0.0;
};
Note note;

void begin(ImGuiID field, double value) {
    typing.field = field;
    typing.text = fmt::format("{:.{}g}", value, value == std::round(value) ? 10 : 7);
    typing.before = typing.text;
    typing.seenAtFrame = ImGui::GetFrameCount();
    typing.wasActive = typing.nextFieldBegins = false;
}

/// The text's number, unless it is as it was.
std::optional<double> finish(ImGuiID field, std::string_view unit, bool isWhole) {
    typing.field = 0;
    ImGui::ClearActiveID();
    if (typing.text == typing.before) { return std::nullopt; }
    const Result<double> number = parseQuantity(typing.text, unit);
    if (number && (!isWhole || *number == std::round(*number))) { return *number; }
    note = {field,
            fmt::format("\"{}\" {}; the old value stays", typing.text,
                        number ? "is no whole number" : number.error().message),
            ImGui::GetTime() + kNoteSeconds};
    return std::nullopt;
}

void drawNote(ImGuiID field) {
    if (note.field != field || ImGui::GetTime() > note.until) { return; }
    ImGui::BeginTooltip();
    ImGui::TextColored(theme::kTextError, "%s", note.text.c_str());
    ImGui::EndTooltip();
}

}  // namespace

bool isTyped(const char* id) {
    if (typing.field == 0 || typing.field != ImGui::GetID(id)) { return false; }
    // Its section was closed meanwhile.
    if (ImGui::GetFrameCount() - typing.seenAtFrame > 1) { typing.field = 0; }
    return typing.field != 0;
}

std::optional<double> typedNumber(const char* id, std::string_view unit, bool isWhole) {
    const ImGuiID field = ImGui::GetID(id);
    const Drawn previous = std::exchange(lastDrawn, {field, 0.0});
    typing.seenAtFrame = ImGui::GetFrameCount();
    if (!typing.wasActive) { ImGui::SetKeyboardFocusHere(); }
    ImGui::InputText(id, &typing.text, ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_AllowTabInput);
    typing.wasActive = typing.wasActive || ImGui::IsItemActive();
    const bool isTab = typing.text.find('\t') != std::string::npos;
    const bool isBackTab = ImGui::GetIO().KeyShift && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab));
    if (isTab || isBackTab) {
        std::erase(typing.text, '\t');
        const std::optional<double> number = finish(field, unit, isWhole);
        typing.nextFieldBegins = isTab;
        if (!isTab && previous.field != 0) { begin(previous.field, previous.value); }
        return number;
    }
    return typing.wasActive && !ImGui::IsItemActive() ? finish(field, unit, isWhole) : std::nullopt;
}

bool offerTyping(const char* id, double value) {
    const ImGuiID field = ImGui::GetID(id);
    const bool isClicked = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) ||
                           (ImGui::GetIO().KeyCtrl && ImGui::IsMouseClicked(ImGuiMouseButton_Left));
    const bool begins = typing.nextFieldBegins || isEntered() || (ImGui::IsItemHovered() && isClicked);
    if (begins) {
        ImGui::ClearActiveID();
        begin(field, value);
    }
    lastDrawn = {field, value};
    drawNote(field);
    return begins;
}

}  // namespace glint::ui
