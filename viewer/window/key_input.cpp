#include "viewer/window/key_input.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <imgui.h>

#include "viewer/ui/keyboard_walk.h"
#include "viewer/window/key_codes.h"

namespace glint {
namespace {

constexpr std::array<std::string_view, 4> kOfNoAction{"escape", "shift", "ctrl", "alt"};
constexpr std::array<std::string_view, 6> kOfWidgets{"space", "enter", "up", "down", "left", "right"};

KeyChord withModifiers(std::string key) {
    const ImGuiIO& io = ImGui::GetIO();
    return {io.KeyCtrl, io.KeyShift, io.KeyAlt, std::move(key)};
}

template <class IsActive>
bool isMeant(const KeyMap& keys, KeyAction action, const IsActive& isActive) {
    if (ImGui::GetIO().WantTextInput || keys.asked) { return false; }
    for (const KeyChord& chord : keys.chordsOf(action)) {
        const bool isOfWidget = !chord.alt && std::ranges::find(kOfWidgets, chord.key) != kOfWidgets.end();
        if (ui::isWalking() && isOfWidget) { continue; }
        if (isActive(*keyCode(chord.key)) && keys.means(action, withModifiers(chord.key))) { return true; }
    }
    return false;
}

}  // namespace

bool isPressed(const KeyMap& keys, KeyAction action, bool repeats) {
    return isMeant(keys, action, [repeats](int code) { return ImGui::IsKeyPressed(code, repeats); });
}

bool isHeld(const KeyMap& keys, KeyAction action) {
    return isMeant(keys, action, [](int code) { return ImGui::IsKeyDown(code); });
}

std::optional<KeyChord> pressedChord() {
    for (const std::string_view name : keyNames()) {
        const bool isOfNoAction = std::ranges::find(kOfNoAction, name) != kOfNoAction.end();
        if (!isOfNoAction && ImGui::IsKeyPressed(*keyCode(name), false)) {
            return withModifiers(std::string(name));
        }
    }
    return std::nullopt;
}

bool isDown(const KeyChord& chord) { return ImGui::IsKeyDown(*keyCode(chord.key)); }

}  // namespace glint
