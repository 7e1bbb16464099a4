// Going from widget to widget by the arrow keys, which Dear ImGui does: where that begins, and whether it is
// under way. Space presses, Enter types a number or a text, Esc goes back to the picture.
#pragma once

namespace glint::ui {

/// In this frame's context, once.
void allowWalking();
/// Before each frame: Enter presses what is marked, as Space does.
void letEnterPress();
/// The window that is drawn has the keyboard; its first widget is marked.
void beginWalkHere();
/// A widget is marked: arrows, Space and Enter are for it.
bool isWalking();
/// No widget is marked any more.
void endWalk();
/// The widget that was drawn last is marked, and Enter was pressed.
bool isEntered();

}  // namespace glint::ui
