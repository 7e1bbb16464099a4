#include "viewer/window/widgets.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "engine/base/nearest_name.h"
#include "engine/math/color.h"
#include "viewer/window/theme.h"

namespace glint::ui {
namespace {

constexpr float kLabelShare = 0.35f;  // of a row's width
constexpr float kTooltipDelaySeconds = 0.5f;

WidgetRegistry* registry = nullptr;
const Fonts* frameFonts = nullptr;
float frameScale = 1.0f;

bool isCentreVisible(const ImVec2& min, const ImVec2& max) {
    const ImVec2 centre{(min.x + max.x) * 0.5f, (min.y + max.y) * 0.5f};
    return ImGui::GetCurrentWindow()->ClipRect.Contains(centre);
}

void record(WidgetKind kind, std::string_view label, std::string shown) {
    const ImVec2 min = ImGui::GetItemRectMin();
    const ImVec2 max = ImGui::GetItemRectMax();
    if (registry->wantsScroll(label)) ImGui::SetScrollHereY(0.5f);
    registry->add(kind, label, {min.x, min.y}, {max.x, max.y}, isCentreVisible(min, max), std::move(shown));
}

void showTooltip(const char* tooltip) {
    if (tooltip == nullptr) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 22.0f);
    ImGui::TextUnformatted(tooltip);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void tooltipForItem(const char* tooltip) {
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive() &&
        ImGui::GetCurrentContext()->HoveredIdTimer > kTooltipDelaySeconds) {
        showTooltip(tooltip);
    }
}

/// Draws the label and leaves the cursor where the control begins.
void beginRow(const char* label, const char* tooltip) {
    ImGui::PushID(label);
    const float start = ImGui::GetCursorPosX();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(theme::kTextDim, "%s", label);
    if (ImGui::IsItemHovered()) showTooltip(tooltip);
    ImGui::SameLine(start + std::max(width * kLabelShare, ImGui::GetFontSize() * 6.5f));
    ImGui::SetNextItemWidth(-FLT_MIN);
}

void endRow() { ImGui::PopID(); }

bool parseNumber(const std::string& word, float* value) {
    char* end = nullptr;
    const float parsed = std::strtof(word.c_str(), &end);
    if (word.empty() || *end != '\0') return false;
    *value = parsed;
    return true;
}

float clamped(float value, const NumberStyle& style) {
    return style.min < style.max ? std::clamp(value, style.min, style.max) : value;
}

/// Applies a script's assignment of `count` numbers.
bool assignNumbers(std::string_view label, float* values, int count, const NumberStyle& style) {
    const auto words = registry->takeAssignment(label);
    if (!words) return false;
    std::array<float, 3> parsed{};
    bool good = static_cast<int>(words->size()) == count;
    for (int i = 0; good && i < count; ++i)
        good = parseNumber((*words)[static_cast<size_t>(i)], &parsed[static_cast<size_t>(i)]);
    if (!good) {
        registry->reject(count == 1 ? "expected a number" : fmt::format("expected {} numbers", count));
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

bool dragField(const char* id, float* value, const NumberStyle& style) {
    const char* format = *value == 0.0f && style.zeroText != nullptr ? style.zeroText : style.format;
    if (style.slider) {
        return ImGui::SliderFloat(id, value, style.min, style.max, format, ImGuiSliderFlags_AlwaysClamp);
    }
    return ImGui::DragFloat(id, value, style.speed, style.min, style.max, format,
                            ImGuiSliderFlags_AlwaysClamp);
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
        if (i > 0) ImGui::SameLine(0.0f, spacing);
        ImGui::SetNextItemWidth(fieldWidth);
        changed |= dragField(fmt::format("##{}", i).c_str(), component, style);
        record(WidgetKind::Number, name, fmt::format("{}", *component));
        tooltipForItem(style.tooltip);
    }
    return changed;
}

Vec3 screenColor(const Vec3& linear) {
    const auto encode = [](float x) { return linearToSrgb(clampf(x, 0.0f, 1.0f)); };
    return {encode(linear.x), encode(linear.y), encode(linear.z)};
}

ImVec4 screenColor4(const Vec3& linear) {
    const Vec3 encoded = screenColor(linear);
    return {encoded.x, encoded.y, encoded.z, 1.0f};
}

bool pickColor(Vec3* value) {
    if (!ImGui::BeginPopup("picker")) return false;
    Vec3 encoded = screenColor(*value);
    const bool changed =
        ImGui::ColorPicker3("##picker", &encoded.x,
                            ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview |
                                ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_DisplayHSV);
    if (changed) *value = {srgbToLinear(encoded.x), srgbToLinear(encoded.y), srgbToLinear(encoded.z)};
    ImGui::EndPopup();
    return changed;
}

}  // namespace

void beginFrame(WidgetRegistry* frameRegistry, const Fonts* fontsOfFrame, float scaleOfFrame) {
    registry = frameRegistry;
    frameFonts = fontsOfFrame;
    frameScale = scaleOfFrame;
    registry->beginFrame();
}

float scale() { return frameScale; }
const Fonts& fonts() { return *frameFonts; }

bool section(const char* label, bool openAtFirst, const char* tooltip) {
    registry->setSection("");
    const auto words = registry->takeAssignment(label);
    if (words) ImGui::SetNextItemOpen(!words->empty() && (*words)[0] == "open", ImGuiCond_Always);
    ImGui::PushFont(frameFonts->heading);
    const bool open = ImGui::CollapsingHeader(label, openAtFirst ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    ImGui::PopFont();
    record(WidgetKind::Section, label, open ? "open" : "closed");
    tooltipForItem(tooltip);
    registry->setSection(label);
    return open;
}

void heading(const char* text) {
    ImGui::Dummy({0.0f, 2.0f * frameScale});
    ImGui::PushFont(frameFonts->heading);
    ImGui::TextColored(theme::kTextDim, "%s", text);
    ImGui::PopFont();
}

void gap() { ImGui::Dummy({0.0f, 3.0f * frameScale}); }

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
    if (changed) *value = static_cast<int>(std::lround(assigned));
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

bool choice(const char* label, int* index, std::span<const std::string_view> names, const char* tooltip) {
    beginRow(label, tooltip);
    bool changed = false;
    if (const auto words = registry->takeAssignment(label)) {
        const std::string wanted = fmt::format("{}", fmt::join(*words, " "));
        const auto found = std::find(names.begin(), names.end(), wanted);
        if (found == names.end()) {
            registry->reject(fmt::format("expected one of \"{}\"{}", fmt::join(names, "\", \""),
                                         didYouMean(wanted, names)));
        } else if (const int next = static_cast<int>(found - names.begin()); next != *index) {
            *index = next;
            changed = true;
        }
    }
    const auto nameOf = [&](int i) {
        return i >= 0 && i < static_cast<int>(names.size()) ? std::string(names[static_cast<size_t>(i)]) : "";
    };
    if (ImGui::BeginCombo("##value", nameOf(*index).c_str(), ImGuiComboFlags_HeightLarge)) {
        for (int i = 0; i < static_cast<int>(names.size()); ++i) {
            if (ImGui::Selectable(nameOf(i).c_str(), i == *index) && i != *index) {
                *index = i;
                changed = true;
            }
        }
        ImGui::EndCombo();
    }
    record(WidgetKind::Choice, label, nameOf(*index));
    tooltipForItem(tooltip);
    endRow();
    return changed;
}

bool toggle(const char* label, bool* value, const char* tooltip) {
    beginRow(label, tooltip);
    bool changed = false;
    if (const auto words = registry->takeAssignment(label)) {
        const bool on = words->size() == 1 && (*words)[0] == "on";
        if (!on && !(words->size() == 1 && (*words)[0] == "off")) {
            registry->reject("expected on or off");
        } else if (on != *value) {
            *value = on;
            changed = true;
        }
    }
    changed |= ImGui::Checkbox("##value", value);
    record(WidgetKind::Toggle, label, *value ? "on" : "off");
    tooltipForItem(tooltip);
    endRow();
    return changed;
}

bool text(const char* label, std::string* value, const char* hintText, const char* tooltip) {
    beginRow(label, tooltip);
    if (const auto words = registry->takeAssignment(label))
        *value = fmt::format("{}", fmt::join(*words, " "));
    const bool entered =
        ImGui::InputTextWithHint("##value", hintText, value, ImGuiInputTextFlags_EnterReturnsTrue);
    record(WidgetKind::Text, label, *value);
    tooltipForItem(tooltip);
    endRow();
    return entered;
}

bool button(const char* label, float width, const char* tooltip, bool emphasis) {
    if (emphasis) ImGui::PushStyleColor(ImGuiCol_Button, theme::kAccent);
    const bool pressed = ImGui::Button(label, {width, 0.0f});
    if (emphasis) ImGui::PopStyleColor();
    record(WidgetKind::Button, label, "");
    tooltipForItem(tooltip);
    return pressed;
}

void value(const char* label, const std::string& shown, const char* tooltip) {
    // Rows that only show stand closer together than those that take the mouse.
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0.0f, 0.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        ImVec2(ImGui::GetStyle().ItemSpacing.x, 3.0f * frameScale));
    beginRow(label, tooltip);
    ImGui::TextUnformatted(shown.c_str());
    record(WidgetKind::Value, label, shown);
    if (ImGui::IsItemHovered()) showTooltip(tooltip);
    endRow();
    ImGui::PopStyleVar(2);
}

bool selectable(const char* label, bool selected, const Vec3* swatch) {
    const float side = ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float indent = swatch != nullptr ? side + ImGui::GetStyle().ItemInnerSpacing.x * 1.5f : 0.0f;
    const bool pressed = ImGui::Selectable(fmt::format("##{}", label).c_str(), selected);
    record(WidgetKind::Button, label, selected ? "selected" : "");
    ImDrawList* draw = ImGui::GetWindowDrawList();
    if (swatch != nullptr) {
        const float inset = side * 0.14f;
        draw->AddRectFilled({corner.x + inset, corner.y + inset},
                            {corner.x + side - inset, corner.y + side - inset},
                            ImGui::GetColorU32(screenColor4(*swatch)), 3.0f * frameScale);
    }
    draw->AddText({corner.x + indent, corner.y}, ImGui::GetColorU32(ImGuiCol_Text), label);
    return pressed;
}

void hint(const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme::kTextDim);
    ImGui::TextWrapped("%s", text);
    ImGui::PopStyleColor();
}

void tooltip(const char* text) { showTooltip(text); }

void itemArea(const char* label, const std::string& shown) { record(WidgetKind::Area, label, shown); }

void area(const char* label, Vec2 min, Vec2 max, const std::string& shown) {
    registry->setSection("");
    registry->add(WidgetKind::Area, label, min, max, true, shown);
}

float buttonWidth(int count) {
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    return (ImGui::GetContentRegionAvail().x - spacing * static_cast<float>(count - 1)) /
           static_cast<float>(count);
}

}  // namespace glint::ui
