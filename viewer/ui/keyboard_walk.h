// Going from widget to widget by the arrow keys, which Dear ImGui does: where that begins, and whether it is
// under way. Space presses, Enter types a number or a text, Esc goes back to the picture.
#pragma once

namespace glint::ui {

/// Before each frame. Arrows lead on only from a marked widget or in an open list: otherwise they are the
/// picture's, whatever was clicked last. Enter presses what is marked, as Space does.
void prepareWalk();
/// The window that is drawn has the keyboard; its first widget is marked.
void beginWalkHere();
/// A widget is marked: arrows, Space and Enter are for it.
bool isWalking();
/// No widget is marked any more.
void endWalk();
/// The widget that was drawn last is marked, and Enter was pressed.
bool isEntered();

}  // namespace glint::ui
