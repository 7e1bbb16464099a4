// What every row of the panels is made of: the label, the tooltip, and the note for scripts. For the files
// that implement widgets.h, and nobody else.
#pragma once

#include <string>
#include <string_view>

#include <imgui.h>

#include "engine/math/vec.h"
#include "viewer/ui/widget_registry.h"

namespace glint::ui {

struct NumberStyle;

/// Of the frame that is being drawn.
WidgetRegistry* frameRegistry();
/// Draws the label and leaves the cursor where the control begins; an endRow() has to follow.
void beginRow(const char* label, const char* tooltip);
void endRow();
/// Tells scripts of the item that was drawn last, and scrolls to it if they asked for that.
void record(WidgetKind kind, std::string_view label, std::string shown);
void tooltipForItem(const char* tooltip);
/// Three dragged fields that share `width`, named label.x and so on for scripts.
bool dragFields3(const char* label, Vec3* vector, const NumberStyle& style, const char* const* suffixes,
                 float width);
/// Linear to display colours, clipped.
Vec3 screenColor(const Vec3& linear);
ImVec4 screenColor4(const Vec3& linear);

}  // namespace glint::ui
