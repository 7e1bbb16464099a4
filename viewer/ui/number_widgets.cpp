// The widgets that edit numbers: dragged fields and sliders, vectors, colours with their picker.
#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <imgui.h>

#include "engine/math/color.h"
#include "viewer/ui/widget_row.h"
#include "viewer/ui/widgets.h"

namespace glint::ui {
namespace {

bool parseNumber(const std::string& word, float* value) {
    char* end = nullptr;
    const float parsed = std::strtof(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !std::isfinite(parsed)) { return false; }
    *value = parsed;
    return true;
}

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
        good = parseNumber((*words)[static_cast<size_t>(i)], &parsed[static_cast<size_t>(i)]);
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

/// A number that is typed in and has no place in a float leaves the old one.
bool dragField(const char* id, float* value, const NumberStyle& style) {
    const char* format = *value == 0.0f && style.zeroText != nullptr ? style.zeroText : style.format;
    constexpr ImGuiSliderFlags kClamp = ImGuiSliderFlags_AlwaysClamp;
    const float before = *value;
    const bool changed = style.slider
                             ? ImGui::SliderFloat(id, value, style.min, style.max, format, kClamp)
                             : ImGui::DragFloat(id, value, style.speed, style.min, style.max, format, kClamp);
    if (std::isfinite(*value)) { return changed; }
    *value = before;
    return false;
}

/// Three dragged fields that share `width`, named label.x and so on for scripts.
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

bool pickColor(Vec3* value) {
    if (!ImGui::BeginPopup("picker")) { return false; }
    Vec3 encoded = screenColor(*value);
    const bool changed =
        ImGui::ColorPicker3("##picker", &encoded.x,
                            ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview |
                                ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_DisplayHSV);
    if (changed) { *value = {srgbToLinear(encoded.x), srgbToLinear(encoded.y), srgbToLinear(encoded.z)}; }
    ImGui::EndPopup();
    return changed;
}

}  // namespace

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
    const char* format = *value == 0 && style.zeroText != nullptr ? style.zeroText : style.format;
    changed |= ImGui::DragInt("##value", value, style.speed, static_cast<int>(style.min),
                              static_cast<int>(style.max), format, ImGuiSliderFlags_AlwaysClamp);
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

bool color(const char* label, Vec3* value, float max, const char* tooltip) {
    static constexpr const char* kSuffixes[] = {"r", "g", "b"};
    const NumberStyle style{.format = "%.3f", .speed = 0.004f, .max = max, .tooltip = tooltip};
    beginRow(label, tooltip);
    ImGui::BeginGroup();
    const float side = ImGui::GetFrameHeight();
    if (ImGui::ColorButton("##swatch", screenColor4(*value), ImGuiColorEditFlags_NoTooltip, {side, side})) {
        ImGui::OpenPopup("picker");
    }
    bool changed = pickColor(value);
    const float spacing = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SameLine(0.0f, spacing);
    changed |= dragFields3(label, value, style, kSuffixes, ImGui::GetContentRegionAvail().x);
    ImGui::EndGroup();
    record(WidgetKind::Color, label, fmt::format("{} {} {}", value->x, value->y, value->z));
    endRow();
    return changed;
}

}  // namespace glint::ui
