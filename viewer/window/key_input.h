// Which actions the keyboard asks for in this frame, by the map of keys. No key means anything while a text
// is typed, or a key is chosen for an action; arrows, Space and Enter without Alt mean nothing
// else while a widget is marked.
#pragma once

#include <optional>

#include "viewer/model/key_map.h"

namespace glint {

/// Since the last frame. `repeats`: again and again while it stays down.
bool isPressed(const KeyMap& keys, KeyAction action, bool repeats = false);
/// Goes on for as long as it is down.
bool isHeld(const KeyMap& keys, KeyAction action);

/// What was pressed in this frame, with what is held; nothing for keys that no action can have: Esc, Shift,
/// Ctrl, Alt.
std::optional<KeyChord> pressedChord();
bool isDown(const KeyChord& chord);

}  // namespace glint
