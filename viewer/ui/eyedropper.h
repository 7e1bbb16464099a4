// A colour of the picture for a colour field: the field asks, and the next click on the picture answers.
#pragma once

#include <optional>

#include <imgui.h>

#include "engine/math/vec.h"

namespace glint::ui {

/// That field gets the colour; another one that was waiting does not any more.
void waitForColor(ImGuiID field);
/// Some field waits.
bool waitsForColor();
/// No field waits any more.
void stopWaitingForColor();
/// The linear colour for the field that waits.
void giveColor(const Vec3& linear);
/// What was given to this field since it waited; once.
std::optional<Vec3> takeGivenColor(ImGuiID field);

}  // namespace glint::ui
