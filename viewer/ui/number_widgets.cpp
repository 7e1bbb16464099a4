// The widgets that edit numbers: dragged fields and sliders, vectors.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/base/units.h"
#include "viewer/ui/typed_number.h"
#include "viewer/ui/widget_row.h"
#include "viewer/ui/widgets.h"

namespace glint::ui {
namespace {

float clamped(float value, const NumberStyle& style) {
    return style.min < style.max ? std::clamp(value, style.min, style.max) : value;
}

/// Applies a script's assignment of `count` numbers.
bool assignNumbers(std::string_view label, float* values, int count, const NumberStyle& style) {
    const auto words = frameRegistry()->takeAssignment(label);
    if (!words) { return false; }
    std::array<float, 3> parsed{};
    bool good = static_cast<int>(words->size()) == count;
    for (int i = 0; good && i < count; ++i) {
        const std::optional<float> number = parseNumber((*words)[static_cast<size_t>(i)]);
        good = number.has_value();
        parsed[static_cast<size_t>(i)] = number.value_or(0.0f);
    }
    if (!good) {
        frameRegistry()->reject(count == 1 ? "expected a number" : fmt::format("expected {} numbers", count));
        return false;
    }
    bool changed = false;
    for (int i = 0; i < count; ++i) {
        const float next = clamped(parsed[static_cast<size_t>(i)], style);
        changed |= next != values[i];
        values[i] = next;
    }
    return changed;
}

/// Typed numbers keep the bounds that dragged ones have.
bool dragField(const char* id, float* value, const NumberStyle& style) {
    if (isTyped(id)) {
        const float next = clamped(typedNumber(id).value_or(*value), style);
        return std::exchange(*value, next) != next;
    }
    const char* format = *value == 0.0f && style.zeroText != nullptr ? style.zeroText : style.format;
    constexpr ImGuiSliderFlags kFlags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput;
    const float before = *value;
    const bool changed = style.slider
                             ? ImGui::SliderFloat(id, value, style.min, style.max, format, kFlags)
                             : ImGui::DragFloat(id, value, style.speed, style.min, style.max, format, kFlags);
    // A press that begins a text has moved a slider already.
    if (offerTyping(id, before)) {
        *value = before;
        return false;
    }
    return changed;
}

bool dragInteger(const char* id, int* value, const NumberStyle& style) {
    if (isTyped(id)) {
        const float next = clamped(typedNumber(id).value_or(static_cast<float>(*value)), style);
        const auto whole = static_cast<int>(std::lround(std::clamp(next, -2e9f, 2e9f)));
        return std::exchange(*value, whole) != whole;
    }
    const char* format = *value == 0 && style.zeroText != nullptr ? style.zeroText : style.format;
    const bool changed =
        ImGui::DragInt(id, value, style.speed, static_cast<int>(style.min), static_cast<int>(style.max),
                       format, ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
    static_cast<void>(offerTyping(id, static_cast<float>(*value)));
    return changed;
}

}  // namespace

bool dragFields3(const char* label, Vec3* vector, const NumberStyle& style, const char* const* suffixes,
                 float width) {
    const float spacing = ImGui::GetStyle().ItemInnerSpacing.x;
    const float fieldWidth = (width - 2.0f * spacing) / 3.0f;
    bool changed = assignNumbers(label, &vector->x, 3, style);
    for (int i = 0; i < 3; ++i) {
        float* component = &vector->x + i;
        const std::string name = fmt::format("{}.{}", label, suffixes[i]);
        changed |= assignNumbers(name, component, 1, style);
        if (i > 0) { ImGui::SameLine(0.0f, spacing); }
        ImGui::SetNextItemWidth(fieldWidth);
        changed |= dragField(fmt::format("##{}", i).c_str(), component, style);
        record(WidgetKind::Number, name, fmt::format("{}", *component));
        tooltipForItem(style.tooltip);
    }
    return changed;
}

bool number(const char* label, float* value, const NumberStyle& style) {
    beginRow(label, style.tooltip);
    bool changed = assignNumbers(label, value, 1, style);
    changed |= dragField("##value", value, style);
    record(WidgetKind::Number, label, fmt::format("{}", *value));
    tooltipForItem(style.tooltip);
    endRow();
    return changed;
}

bool integer(const char* label, int* value, const NumberStyle& style) {
    beginRow(label, style.tooltip);
    float assigned = static_cast<float>(*value);
    bool changed = assignNumbers(label, &assigned, 1, style);
    if (changed) { *value = static_cast<int>(std::lround(assigned)); }
    changed |= dragInteger("##value", value, style);
    record(WidgetKind::Number, label, fmt::format("{}", *value));
    tooltipForItem(style.tooltip);
    endRow();
    return changed;
}

bool vector3(const char* label, Vec3* value, const NumberStyle& style) {
    static constexpr const char* kSuffixes[] = {"x", "y", "z"};
    beginRow(label, style.tooltip);
    ImGui::BeginGroup();
    const bool changed = dragFields3(label, value, style, kSuffixes, ImGui::GetContentRegionAvail().x);
    ImGui::EndGroup();
    record(WidgetKind::Vector, label, fmt::format("{} {} {}", value->x, value->y, value->z));
    endRow();
    return changed;
}

}  // namespace glint::ui
