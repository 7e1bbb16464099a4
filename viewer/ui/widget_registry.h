// What widgets are on screen, by label: how a script finds, reads and sets them. Filled by widgets.cpp
// each frame.
//
// A widget's full name is "Section/Label"; the label alone will do while only one widget has it. Values are
// text, as a script writes them. Nothing here draws.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/math/vec.h"

namespace glint {

enum class WidgetKind { Button, Toggle, Number, Vector, Color, Choice, Text, Section, Value, Area };

struct WidgetRecord {
    std::string section;
    std::string label;
    WidgetKind kind = WidgetKind::Value;
    Vec2 min{0.0f};  ///< ImGui coordinates of what takes the mouse
    Vec2 max{0.0f};
    bool visible = false;  ///< its centre is not scrolled or clipped away
    std::string value;  ///< number: with full precision, no unit; toggle: on or off; section: open or closed

    std::string fullName() const { return section.empty() ? label : section + "/" + label; }
};

class WidgetRegistry {
  public:
    /// Forgets the frame before.
    void beginFrame();
    void setSection(std::string section) { section_ = std::move(section); }
    const std::string& section() const { return section_; }
    void add(WidgetKind kind, std::string_view label, Vec2 min, Vec2 max, bool visible, std::string value);

    /// The words a script assigns to this widget, once; the widget answers through reject() if they do
    /// not fit.
    std::optional<std::vector<std::string>> takeAssignment(std::string_view label);
    void reject(std::string reason) { rejection_ = std::move(reason); }
    /// True when this widget is to be scrolled into view.
    bool wantsScroll(std::string_view label);

    /// Of the last frame, between frames. Error: none has this name (with the nearest), or several do.
    Result<WidgetRecord> find(std::string_view name) const;
    const std::vector<WidgetRecord>& widgets() const { return widgets_; }
    void assign(const WidgetRecord& widget, std::vector<std::string> words);
    void scrollTo(const WidgetRecord& widget) { scrollTarget_ = widget.fullName(); }
    /// After a frame with an assignment: why it failed. "" when it did not.
    std::string assignmentFailure() const;

  private:
    std::string fullName(std::string_view label) const;

    std::string section_;
    std::vector<WidgetRecord> widgets_;
    std::string assignmentTarget_;
    std::vector<std::string> assignment_;
    std::string scrollTarget_;
    std::string rejection_;
};

}  // namespace glint
