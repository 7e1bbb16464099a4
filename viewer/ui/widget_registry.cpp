#include "viewer/ui/widget_registry.h"

#include <utility>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"

namespace glint {

std::string WidgetRegistry::fullName(std::string_view label) const {
    return section_.empty() ? std::string(label) : fmt::format("{}/{}", section_, label);
}

void WidgetRegistry::beginFrame() {
    widgets_.clear();
    section_.clear();
}

void WidgetRegistry::add(WidgetKind kind, std::string_view label, Vec2 min, Vec2 max, bool visible,
                         std::string value) {
    widgets_.push_back({section_, std::string(label), kind, min, max, visible, std::move(value)});
}

std::optional<std::vector<std::string>> WidgetRegistry::takeAssignment(std::string_view label) {
    if (assignmentTarget_.empty() || assignmentTarget_ != fullName(label)) { return std::nullopt; }
    assignmentTarget_.clear();
    return std::exchange(assignment_, {});
}

bool WidgetRegistry::wantsScroll(std::string_view label) {
    if (scrollTarget_.empty() || scrollTarget_ != fullName(label)) { return false; }
    scrollTarget_.clear();
    return true;
}

Result<WidgetRecord> WidgetRegistry::find(std::string_view name) const {
    const WidgetRecord* found = nullptr;
    std::vector<std::string> names;
    for (const WidgetRecord& widget : widgets_) {
        names.push_back(widget.fullName());
        names.push_back(widget.label);
        if (widget.fullName() == name) { return widget; }
        if (widget.label != name) { continue; }
        if (found != nullptr) {
            return Error{fmt::format("several widgets are called \"{}\"; write \"{}\" or \"{}\"", name,
                                     found->fullName(), widget.fullName()),
                         {}};
        }
        found = &widget;
    }
    if (found != nullptr) { return *found; }
    const std::vector<std::string_view> views(names.begin(), names.end());
    return Error{
        fmt::format("no widget on screen is called \"{}\"{}; widgets of a closed section are not on screen",
                    name, didYouMean(name, views)),
        {}};
}

void WidgetRegistry::assign(const WidgetRecord& widget, std::vector<std::string> words) {
    assignmentTarget_ = widget.fullName();
    assignment_ = std::move(words);
    rejection_.clear();
}

std::string WidgetRegistry::assignmentFailure() const {
    if (!assignmentTarget_.empty()) {
        return fmt::format("\"{}\" is no longer on screen", assignmentTarget_);
    }
    return rejection_;
}

}  // namespace glint
