// The widgets that edit numbers: dragged fields and sliders, vectors.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/base/number_format.h"
#include "viewer/base/quantity.h"
#include "viewer/ui/typed_number.h"
#include "viewer/ui/widget_row.h"
#include "viewer/ui/widgets.h"

namespace glint::ui {
namespace {

std::string_view unitOf(const NumberStyle& style) {
    return style.unit != nullptr ? style.unit : unitOfFormat(style.format);
}

float clamped(float value, const NumberStyle& style) {
    return style.min < style.max ? std::clamp(value, style.min, style.max) : value;
}

/// What a script assigns: `count` numbers.
std::optional<std::array<double, 3>> takeNumbers(std::string_view label, int count, std::string_view unit,
                                                 bool areWhole = false) {
    const auto words = frameRegistry()->takeAssignment(label);
    if (!words) { return std::nullopt; }
    std::array<double, 3> numbers{};
    bool good = static_cast<int>(words->size()) == count;
    for (int i = 0; good && i < count; ++i) {
        const Result<double> number = parseQuantity((*words)[static_cast<size_t>(i)], unit);
        good = number && (!areWhole || *number == std::round(*number));
        numbers[static_cast<size_t>(i)] = number ? *number : 0.0;
    }
    if (good) { return numbers; }
    const char* kind = areWhole ? "whole number" : "number";
    frameRegistry()->reject(count == 1 ? fmt::format("expected a {}", kind)
                                       : fmt::format("expected {} {}s", count, kind));
    return std::nullopt;
}

bool assignNumbers(std::string_view label, float* values, int count, const NumberStyle& style) {
    const auto numbers = takeNumbers(label, count, unitOf(style));
    bool changed = false;
    for (int i = 0; numbers && i < count; ++i) {
        const float next = clamped(static_cast<float>((*numbers)[static_cast<size_t>(i)]), style);
        changed |= std::exchange(values[i], next) != next;
    }
    return changed;
}

int clampedInteger(double value, const NumberStyle& style) {
    constexpr double kMost = 2e9;  // an int holds it
    const bool isBounded = style.min < style.max;
    const double low = isBounded ? std::max(static_cast<double>(style.min), -kMost) : -kMost;
    const double high = isBounded ? std::min(static_cast<double>(style.max), kMost) : kMost;
    return static_cast<int>(std::clamp(value, low, high));
}

/// Typed numbers keep the bounds that dragged ones have. `neighbours`: the largest size of the numbers
/// beside it.
bool dragField(const char* id, float* value, const NumberStyle& style, float neighbours = 0.0f) {
    if (isTyped(id)) {
        const auto typed = typedNumber(id, unitOf(style));
        const float next = clamped(typed ? static_cast<float>(*typed) : *value, style);
        return std::exchange(*value, next) != next;
    }
    const float room = ImGui::CalcItemWidth() - ImGui::GetStyle().ItemInnerSpacing.x;
    const auto fits = [room](const char* text) { return ImGui::CalcTextSize(text).x <= room; };
    const std::string format = *value == 0.0f && style.zeroText != nullptr
                                   ? style.zeroText
                                   : formatThatShows(style.format, *value, neighbours, fits);
    ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput;
    // A drag goes by the style's decimals, or is not rounded.
    if (format != style.format) { flags |= ImGuiSliderFlags_NoRoundToFormat; }
    const float before = *value;
    const bool changed =
        style.slider ? ImGui::SliderFloat(id, value, style.min, style.max, format.c_str(), flags)
                     : ImGui::DragFloat(id, value, style.speed, style.min, style.max, format.c_str(), flags);
    // A press that begins a text has moved a slider already.
    if (offerTyping(id, before)) {
        *value = before;
        return false;
    }
    return changed;
}

bool dragInteger(const char* id, int* value, const NumberStyle& style) {
    if (isTyped(id)) {
        const int next = clampedInteger(typedNumber(id, unitOf(style), true).value_or(*value), style);
        return std::exchange(*value, next) != next;
    }
    const char* format = *value == 0 && style.zeroText != nullptr ? style.zeroText : style.format;
    const bool changed =
        ImGui::DragInt(id, value, style.speed, static_cast<int>(style.min), static_cast<int>(style.max),
                       format, ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
    static_cast<void>(offerTyping(id, *value));
    return changed;
}

}  // namespace

bool dragFields3(const char* label, Vec3* vector, const NumberStyle& style, const char* const* suffixes,
                 float width) {
    const float spacing = ImGui::GetStyle().ItemInnerSpacing.x;
    const float fieldWidth = (width - 2.0f * spacing) / 3.0f;
    bool changed = assignNumbers(label, &vector->x, 3, style);
    const float largest = std::max({std::abs(vector->x), std::abs(vector->y), std::abs(vector->z)});
    for (int i = 0; i < 3; ++i) {
        float* component = &vector->x + i;
        const std::string name = fmt::format("{}.{}", label, suffixes[i]);
        changed |= assignNumbers(name, component, 1, style);
        if (i > 0) { ImGui::SameLine(0.0f, spacing); }
        ImGui::SetNextItemWidth(fieldWidth);
        changed |= dragField(fmt::format("##{}", i).c_str(), component, style, largest);
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
    const auto assigned = takeNumbers(label, 1, unitOf(style), true);
    const int next = assigned ? clampedInteger((*assigned)[0], style) : *value;
    bool changed = std::exchange(*value, next) != next;
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
