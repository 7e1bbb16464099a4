#include "viewer/model/key_map.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/base/nearest_name.h"
#include "engine/io/atomic_file.h"

namespace glint {
namespace {

constexpr KeyActionInfo kActions[] = {
    {KeyAction::Focus, "focus", "t", "focus on what is under the mouse"},
    {KeyAction::ZoomIn, "zoom-in", "+ kp+", "larger picture, around the mouse"},
    {KeyAction::ZoomOut, "zoom-out", "- kp-", "smaller picture"},
    {KeyAction::OneToOne, "one-to-one", "1 kp1", "picture at 1:1 pixels"},
    {KeyAction::FitImage, "fit", "0 kp0", "picture at its automatic size"},
    {KeyAction::FlyForwards, "fly-forwards", "w", "fly forwards (Shift: fast)"},
    {KeyAction::FlyBack, "fly-back", "s", "fly back"},
    {KeyAction::FlyLeft, "fly-left", "a", "fly left"},
    {KeyAction::FlyRight, "fly-right", "d", "fly right"},
    {KeyAction::FlyUp, "fly-up", "e", "fly up"},
    {KeyAction::FlyDown, "fly-down", "q", "fly down"},
    {KeyAction::FrameSelection, "frame", "f", "frame the selected object"},
    {KeyAction::FrameScene, "frame-all", "shift+f", "frame the whole scene"},
    {KeyAction::Gizmo, "gizmo", "g", "gizmo: move, rotate, scale, none"},
    {KeyAction::GizmoXLess, "gizmo-x-less", "left", "gizmo: back along X, or about it (Shift: fine)"},
    {KeyAction::GizmoXMore, "gizmo-x-more", "right", "gizmo: on along X, or about it"},
    {KeyAction::GizmoYLess, "gizmo-y-less", "down", "gizmo: back along Y, or about it"},
    {KeyAction::GizmoYMore, "gizmo-y-more", "up", "gizmo: on along Y, or about it"},
    {KeyAction::GizmoZLess, "gizmo-z-less", "pagedown", "gizmo: back along Z, or about it"},
    {KeyAction::GizmoZMore, "gizmo-z-more", "pageup", "gizmo: on along Z, or about it"},
    {KeyAction::GizmoLess, "gizmo-smaller", ",", "gizmo of sizes: smaller as a whole"},
    {KeyAction::GizmoMore, "gizmo-larger", ".", "gizmo of sizes: larger as a whole"},
    {KeyAction::Hide, "hide", "h", "hide the selected object"},
    {KeyAction::ShowAll, "show-all", "alt+h", "show all objects"},
    {KeyAction::Duplicate, "duplicate", "ctrl+d", "duplicate the selected object"},
    {KeyAction::Delete, "delete", "delete", "delete the selected object"},
    {KeyAction::ResetCamera, "reset-camera", "home", "the scene file's camera"},
    {KeyAction::Pause, "pause", "space", "pause and go on"},
    {KeyAction::Restart, "restart", "r", "restart"},
    {KeyAction::Region, "region", "b", "a region that alone is rendered on"},
    {KeyAction::Spot, "spot", "v", "held: this spot first, around the mouse"},
    {KeyAction::Compare, "compare", "c", "compare two integrators"},
    {KeyAction::Keep, "keep", "k", "keep the picture, to compare it later"},
    {KeyAction::NextCompareView, "compare-view", "n", "another way to compare"},
    {KeyAction::Flip, "flip", "x", "the other one of both pictures"},
    {KeyAction::DividerLeft, "divider-left", "ctrl+left",
     "divider of both pictures to the left (Shift: fine)"},
    {KeyAction::DividerRight, "divider-right", "ctrl+right", "divider of both pictures to the right"},
    {KeyAction::Darker, "darker", "[", "exposure down by a third of a stop"},
    {KeyAction::Brighter, "brighter", "]", "exposure up by a third of a stop"},
    {KeyAction::Undo, "undo", "ctrl+z", "undo, also opening a scene"},
    {KeyAction::Redo, "redo", "ctrl+shift+z ctrl+y", "redo"},
    {KeyAction::OpenScene, "open", "ctrl+o", "look for a scene to open"},
    {KeyAction::SavePng, "save-png", "ctrl+s", "save the PNG"},
    {KeyAction::SaveScene, "save-scene", "ctrl+shift+s", "save the scene as …"},
    {KeyAction::Quit, "quit", "ctrl+q", "quit"},
    {KeyAction::Panels, "panels", "tab", "show or hide the panels"},
    {KeyAction::ColumnWider, "column-wider", "alt+left", "wider panels (Shift: fine)"},
    {KeyAction::ColumnNarrower, "column-narrower", "alt+right", "narrower panels"},
    {KeyAction::Walk, "walk", "f6", "panels by arrows, Space, Enter; Esc: back"},
    {KeyAction::Help, "help", "f1", "this list, where keys can be changed"},
};

constexpr MouseInput kMouse[] = {
    {"Left drag", "orbit around the target"},
    {"Right or middle drag", "pan (also Shift + left drag)"},
    {"Ctrl + left drag", "look around"},
    {"Wheel", "dolly: closer or farther"},
    {"Ctrl + wheel", "zoom of the picture"},
    {"Ctrl + right drag", "move the zoomed picture"},
    {"Click", "select an object and its material"},
    {"Ctrl + click", "focus on what is under the mouse"},
    {"Esc", "give up what was begun; back to the picture"},
};

constexpr std::string_view kNoKey = "none";

const KeyActionInfo& infoOf(KeyAction action) { return kActions[static_cast<size_t>(action)]; }

/// "ctrl+shift+z". The key's name may be "+".
KeyChord parseChord(std::string_view text) {
    KeyChord chord;
    const auto takes = [&text](std::string_view prefix) {
        if (!text.starts_with(prefix)) { return false; }
        text.remove_prefix(prefix.size());
        return true;
    };
    for (bool isMore = true; isMore;) {
        const bool ctrl = takes("ctrl+"), shift = takes("shift+"), alt = takes("alt+");
        chord = {chord.ctrl || ctrl, chord.shift || shift, chord.alt || alt, ""};
        isMore = ctrl || shift || alt;
    }
    chord.key = text;
    return chord;
}

std::string written(const KeyChord& chord) {
    return fmt::format("{}{}{}{}", chord.ctrl ? "ctrl+" : "", chord.shift ? "shift+" : "",
                       chord.alt ? "alt+" : "", chord.key);
}

std::string forPeople(const KeyChord& chord) {
    std::string key = chord.key;
    if (key.starts_with("kp")) { key = "keypad " + key.substr(2); }
    if (key.starts_with("page")) { key = "page " + key.substr(4); }
    key[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(key[0])));
    return fmt::format("{}{}{}{}", chord.ctrl ? "Ctrl + " : "", chord.shift ? "Shift + " : "",
                       chord.alt ? "Alt + " : "", key);
}

std::vector<KeyChord> defaultsOf(KeyAction action) {
    std::vector<KeyChord> chords;
    std::istringstream words(infoOf(action).defaults);
    for (std::string word; words >> word;) {
        chords.push_back(parseChord(word));
    }
    return chords;
}

/// A line of the preferences.
struct Choice {
    KeyAction action;
    std::vector<KeyChord> chords;
    int line;
};

std::optional<KeyAction> actionNamed(const std::string& name, std::vector<std::string_view>* names) {
    for (const KeyActionInfo& each : kActions) {
        names->emplace_back(each.name);
        if (each.name == name) { return each.action; }
    }
    return std::nullopt;
}

/// Adds to the choices. Returns what is wrong with the line; "": nothing.
std::string readLine(const std::string& line, int number, std::span<const std::string_view> keys,
                     std::vector<Choice>* choices) {
    std::istringstream words(line);
    std::string name;
    if (!(words >> name) || name.starts_with('#')) { return ""; }
    std::vector<std::string_view> names;
    const auto action = actionNamed(name, &names);
    if (!action) { return fmt::format("there is no action '{}'{}", name, didYouMean(name, names)); }
    std::vector<KeyChord> chords;
    std::string word;
    while (words >> word && word != kNoKey) {
        const KeyChord chord = parseChord(word);
        if (std::ranges::find(keys, chord.key) == keys.end()) {
            return fmt::format("there is no key '{}'{}", chord.key, didYouMean(chord.key, keys));
        }
        for (const Choice& each : *choices) {
            if (std::ranges::find(each.chords, chord) == each.chords.end()) { continue; }
            return fmt::format("{} is for '{}' already", forPeople(chord), infoOf(each.action).name);
        }
        chords.push_back(chord);
    }
    if (chords.empty() && (word != kNoKey || action == KeyAction::Help)) {
        return fmt::format("'{}' needs a key", name);
    }
    const auto isOfSame = [&](const Choice& each) { return each.action == action; };
    if (std::ranges::any_of(*choices, isOfSame)) { return fmt::format("'{}' has its keys already", name); }
    choices->push_back({*action, std::move(chords), number});
    return "";
}

}  // namespace

std::span<const KeyActionInfo> keyActions() { return kActions; }
std::span<const MouseInput> mouseInputs() { return kMouse; }

KeyMap::KeyMap() {
    for (const KeyActionInfo& info : kActions) {
        chords_.push_back(defaultsOf(info.action));
    }
}

std::optional<KeyAction> KeyMap::ownerOf(const KeyChord& chord) const {
    for (const KeyActionInfo& info : kActions) {
        if (std::ranges::find(chordsOf(info.action), chord) != chordsOf(info.action).end()) {
            return info.action;
        }
    }
    return std::nullopt;
}

bool KeyMap::means(KeyAction action, const KeyChord& pressed) const {
    if (const auto owner = ownerOf(pressed)) { return *owner == action; }
    KeyChord plain = pressed;
    plain.shift = false;
    return pressed.shift && ownerOf(plain) == action;
}

std::string KeyMap::textOf(KeyAction action) const {
    std::string text;
    for (const KeyChord& chord : chordsOf(action)) {
        text += (text.empty() ? "" : ", ") + forPeople(chord);
    }
    return text.empty() ? "–" : text;
}

std::string KeyMap::tip(const std::string& text, KeyAction action) const {
    return chordsOf(action).empty() ? text : fmt::format("{} ({})", text, textOf(action));
}

std::string KeyMap::take(KeyAction action, std::vector<KeyChord> chords) {
    std::string note;
    for (const KeyChord& chord : chords) {
        const auto owner = ownerOf(chord);
        if (!owner || *owner == action) { continue; }
        if (*owner == KeyAction::Help && chordsOf(*owner).size() == 1) {
            return fmt::format("{} opens this list: give that another key first", forPeople(chord));
        }
        std::erase(chords_[static_cast<size_t>(*owner)], chord);
        note = fmt::format("{} was for \"{}\", which has {}", forPeople(chord), infoOf(*owner).does,
                           chordsOf(*owner).empty() ? "no key now" : textOf(*owner));
    }
    chords_[static_cast<size_t>(action)] = std::move(chords);
    return note;
}

std::string KeyMap::assign(KeyAction action, const KeyChord& chord) {
    std::string note = take(action, {chord});
    save();
    return note;
}

std::string KeyMap::reset(KeyAction action) {
    std::string note = take(action, defaultsOf(action));
    save();
    return note;
}

void KeyMap::resetAll() {
    for (const KeyActionInfo& info : kActions) {
        chords_[static_cast<size_t>(info.action)] = defaultsOf(info.action);
    }
    save();
}

bool KeyMap::isChanged(KeyAction action) const { return chordsOf(action) != defaultsOf(action); }

void KeyMap::begin(const std::string& file, std::span<const std::string_view> keys) {
    file_ = file;
    std::ifstream in(file);
    std::vector<Choice> choices;
    std::string first;
    int odd = 0;
    const auto note = [&](int line, const std::string& problem) {
        if (!problem.empty() && odd++ == 0) { first = fmt::format("{}:{}: {}", file, line, problem); }
    };
    int number = 1;
    for (std::string line; std::getline(in, line); ++number) {
        note(number, readLine(line, number, keys, &choices));
    }
    for (const Choice& choice : choices) {
        chords_[static_cast<size_t>(choice.action)].clear();
    }
    for (const Choice& choice : choices) {
        note(choice.line, take(choice.action, choice.chords));
        if (!choice.chords.empty() && chordsOf(choice.action).empty()) {
            (void)take(choice.action, defaultsOf(choice.action));
        }
    }
    if (odd == 0) { return; }
    logWarning("{}{}", first, odd > 1 ? fmt::format("; {} more lines are odd, too", odd - 1) : "");
}

void KeyMap::save() const {
    if (file_.empty()) { return; }
    std::string text;
    for (const KeyActionInfo& info : kActions) {
        if (!isChanged(info.action)) { continue; }
        text += info.name;
        for (const KeyChord& chord : chordsOf(info.action)) {
            text += " " + written(chord);
        }
        text += chordsOf(info.action).empty() ? fmt::format(" {}\n", kNoKey) : "\n";
    }
    std::error_code problem;
    std::filesystem::create_directories(std::filesystem::path(file_).parent_path(), problem);
    (void)writeFileAtomically(file_, text);  // a comfort, and no reason for a message
}

}  // namespace glint
