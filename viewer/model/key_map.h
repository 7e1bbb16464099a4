// What keys are for: one table of actions with their names, default keys and texts, and the keys that the
// user chose instead.
//
// The list of keys in the window, tooltips, the README's table and what keys do all come from here. Keys are
// known by their names in scripts.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

enum class KeyAction : uint8_t {
    Focus,
    ZoomIn,
    ZoomOut,
    OneToOne,
    FitImage,
    FlyForwards,
    FlyBack,
    FlyLeft,
    FlyRight,
    FlyUp,
    FlyDown,
    FrameSelection,
    FrameScene,
    Gizmo,
    GizmoXLess,
    GizmoXMore,
    GizmoYLess,
    GizmoYMore,
    GizmoZLess,
    GizmoZMore,
    GizmoLess,
    GizmoMore,
    Hide,
    ShowAll,
    Duplicate,
    Delete,
    ResetCamera,
    Pause,
    Restart,
    Region,
    Spot,
    Compare,
    Keep,
    NextCompareView,
    Flip,
    DividerLeft,
    DividerRight,
    Darker,
    Brighter,
    Undo,
    Redo,
    OpenScene,
    SavePng,
    SaveScene,
    Quit,
    Panels,
    ColumnWider,
    ColumnNarrower,
    Walk,
    Help,
};

struct KeyActionInfo {
    KeyAction action;
    const char* name;      ///< in the preferences
    const char* defaults;  ///< chords, apart by blanks
    const char* does;      ///< for people
};
/// In the order of KeyAction.
std::span<const KeyActionInfo> keyActions();

struct MouseInput {
    const char* input;
    const char* does;
};
/// What the mouse does in the picture, and Esc, which stay as they are.
std::span<const MouseInput> mouseInputs();

/// A key with those that are held down with it.
struct KeyChord {
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
    std::string key;

    bool operator==(const KeyChord&) const = default;
};

class KeyMap {
  public:
    KeyMap();

    /// Reads the chords that the user chose from `file`, and keeps them there from now on; where it cannot be
    /// written, they last as long as the session. `keys`: the names that there are. One warning in the log
    /// says what in the file is not understood; the rest counts.
    void begin(const std::string& file, std::span<const std::string_view> keys);

    const std::vector<KeyChord>& chordsOf(KeyAction action) const {
        return chords_[static_cast<size_t>(action)];
    }
    /// `pressed` means this action: one of its chords, also with Shift where that is not another one's.
    bool means(KeyAction action, const KeyChord& pressed) const;

    /// "Ctrl + Shift + Z, Ctrl + Y"; "–" without any.
    std::string textOf(KeyAction action) const;
    /// A tooltip with its keys: "Begins again (R)".
    std::string tip(const std::string& text, KeyAction action) const;

    /// Gives the action this chord alone, and takes it from whose it was. Returns what people have to know,
    /// "" where that is nothing. The last key of the list of keys cannot be taken.
    std::string assign(KeyAction action, const KeyChord& chord);
    /// The keys that it has at first, by assign()'s rules.
    std::string reset(KeyAction action);
    void resetAll();
    bool isChanged(KeyAction action) const;

    /// The action whose new key is awaited; until it is there, no key means anything.
    std::optional<KeyAction> asked;

  private:
    std::optional<KeyAction> ownerOf(const KeyChord& chord) const;
    std::string take(KeyAction action, std::vector<KeyChord> chords);
    void save() const;

    std::string file_;
    std::vector<std::vector<KeyChord>> chords_;  ///< by action
};

}  // namespace glint
