// A number that is typed into a dragged field: the field becomes a text until Enter, Tab, a click elsewhere
// or Escape.
#pragma once

#include <optional>
#include <string_view>

#include <imgui.h>

namespace glint::ui {

/// Whether the field with this label is being typed in; typedNumber() then stands in its place.
bool isTyped(const char* id);

/// Draws the text. Returns the number once it is there, in `unit` (quantity.h); nothing before, and where the
/// text is none: then a note says so for a while, and the field shows its old value. Tab goes on to the next
/// field, Shift + Tab to the one before. `isWhole`: a fraction is no number here.
std::optional<double> typedNumber(const char* id, std::string_view unit, bool isWhole = false);

/// To be called after the dragged field was drawn: a double click, Ctrl + click or Tab begins the text, and
/// makes it true. `value`: of before the field was drawn.
bool offerTyping(const char* id, double value);

}  // namespace glint::ui
