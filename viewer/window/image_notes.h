// What is written over the picture: short texts on dark plates, and the scale of false colours.
#pragma once

#include <string>

#include "viewer/model/false_colors.h"

namespace glint {

/// A part of the window, in ImGui units.
struct WindowArea {
    Vec2 min{0.0f};
    Vec2 max{0.0f};
};

/// From the edges of the picture.
float noteMargin();
/// Of a plate with that text, which is wrapped where it is wider than `room` (0: never).
Vec2 plateSize(const std::string& text, float room);
/// Text on a dark plate of plateSize().
void drawPlate(const std::string& text, Vec2 corner, Vec2 size);

struct ScaleTexts {
    std::string low;
    std::string high;
};
/// The colours from the smallest to the largest value, with both, in the lower left corner or the right one.
/// Returns its upper edge.
float drawScale(const ScaleTexts& texts, bool isSigned, const WindowArea& area, bool onRight);

}  // namespace glint
