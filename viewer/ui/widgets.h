// The few widgets that the panels are made of: one row each, label left, control right, known to scripts
// by label.
//
// Thin over Dear ImGui. Every function that takes a pointer returns true when it changed the value. Labels
// must be unique within a section. A tooltip of nullptr shows none.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/math/vec.h"
#include "viewer/ui/fonts.h"
#include "viewer/ui/widget_registry.h"

namespace glint::ui {

/// Who the widgets report to during this frame; must outlive it.
void beginFrame(WidgetRegistry* registry, const Fonts* fonts, float scale);
/// ImGui units per unit of the 96-dpi design.
float scale();
const Fonts& fonts();

/// A collapsing group. Widgets that follow belong to it. Returns whether it is open.
/// `goTo`: opens it, and scrolls it to the top.
bool section(const char* label, bool openAtFirst, const char* tooltip = nullptr, bool goTo = false);
/// Widgets that follow are in no section.
void leaveSection();
/// A quiet heading inside a section.
void heading(const char* text);
void gap();

struct NumberStyle {
    const char* format = "%.3f";  ///< with unit: "%.1f mm"
    float speed = 0.01f;          ///< value per pixel dragged
    float min = 0.0f;             ///< min == max: unbounded
    float max = 0.0f;
    const char* zeroText = nullptr;  ///< shown instead of 0: "off"
    bool slider = false;             ///< a slider between min and max instead of a dragged field
    const char* tooltip = nullptr;
    const char* unit = nullptr;  ///< of what is typed, "m", where the format shows none
};
bool number(const char* label, float* value, const NumberStyle& style);
bool integer(const char* label, int* value, const NumberStyle& style);
bool vector3(const char* label, Vec3* value, const NumberStyle& style);
/// Linear colour: a swatch that shows it as the screen would, and its three linear values, which may
/// exceed 1.
bool color(const char* label, Vec3* value, float max, const char* tooltip = nullptr);
bool choice(const char* label, int* index, std::span<const std::string_view> names,
            const char* tooltip = nullptr);
/// A kind of something and what its choice is called.
template <class Kind>
struct KindLabel {
    Kind kind;
    std::string_view label;
};
/// A choice among the kinds that `labels` lists, each with its `kind` and `label`; *kind must be one of them.
template <class Kind, class Labels>
bool kindChoice(const char* label, Kind* kind, const Labels& labels, const char* tooltip = nullptr) {
    std::vector<std::string_view> names;
    names.reserve(std::size(labels));
    int index = 0;
    for (const auto& each : labels) {
        if (each.kind == *kind) { index = static_cast<int>(names.size()); }
        names.push_back(each.label);
    }
    if (!choice(label, &index, names, tooltip)) { return false; }
    *kind = std::begin(labels)[index].kind;
    return true;
}
bool toggle(const char* label, bool* value, const char* tooltip = nullptr);
/// True when Enter was pressed.
bool text(const char* label, std::string* value, const char* hint, const char* tooltip = nullptr);
/// A text that names a file: a typedPath() once it is typed.
bool file(const char* label, std::string* value, const char* hint, const char* tooltip = nullptr);
/// `width` in ImGui units; 0: its text's. `emphasis`: the group's main action.
bool button(const char* label, float width = 0.0f, const char* tooltip = nullptr, bool emphasis = false);
/// A row that only shows. Scripts can read it.
void value(const char* label, const std::string& shown, const char* tooltip = nullptr);
/// A line of a list. A colour patch in front of it unless `swatch` is null (linear).
bool selectable(const char* label, bool selected, const Vec3* swatch = nullptr);
/// Part of a texture: from one corner to the other, in shares of its sides.
struct ImagePart {
    unsigned int texture = 0;  ///< 0: there is none yet
    Vec2 min{0.0f}, max{1.0f};
};
/// A line of a list, `height` units high, with a square picture in front; a colour patch while there is none.
bool imageLine(const char* label, const ImagePart& image, const Vec3& swatch, float height);
/// Dim text that wraps.
void hint(const char* text);
/// A row of small buttons that wraps, without section. Returns the index of the one that was pressed, or -1.
int strip(const char* prefix, std::span<const std::string_view> names, std::span<const char> isLit);
/// At the mouse, now; nothing for nullptr.
void tooltip(const char* text);
/// Tells scripts of the item that was drawn last, by this name.
void itemArea(const char* label, const std::string& shown);
/// Tells scripts of an area that takes the mouse, outside of all sections.
void area(const char* label, Vec2 min, Vec2 max, const std::string& shown);

/// Width of one of `count` buttons side by side that fill the row.
float buttonWidth(int count);

}  // namespace glint::ui
