// Colours: three linear numbers, and a picker that keeps what is brighter than a screen apart from the shade.
#include <algorithm>
#include <cctype>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "engine/math/color.h"
#include "viewer/ui/eyedropper.h"
#include "viewer/ui/widget_row.h"
#include "viewer/ui/widgets.h"

namespace glint::ui {
namespace {

constexpr float kPickerUnits = 330.0f;

/// Of the picker that is open, of which there is one at most. The colour is strength * shade, and no channel
/// of the shade exceeds 1.
struct OpenPicker {
    ImGuiID field = 0;  ///< 0: none is open
    Vec3 before{0.0f};  ///< what Esc gives back
    Vec3 made{0.0f};    ///< the colour as the picker left it: another one came from elsewhere
    Vec3 shade{1.0f};
    float strength = 1.0f;
    std::string hex;
};
OpenPicker picker;

/// What a screen can show keeps its darkness in the shade, as painters mix it.
void takeColor(const Vec3& value) {
    picker.made = value;
    picker.strength = std::max(1.0f, maxComponent(value));
    picker.shade = value / picker.strength;
}

/// "#ff8000" as a linear colour.
std::optional<Vec3> parseHex(const std::string& text) {
    const std::string digits = text.starts_with('#') ? text.substr(1) : text;
    const bool isHex = digits.size() == 6 &&
                       std::ranges::all_of(digits, [](unsigned char c) { return std::isxdigit(c) != 0; });
    if (!isHex) { return std::nullopt; }
    const auto bits = std::strtoul(digits.c_str(), nullptr, 16);
    const auto channel = [bits](int shift) {
        return srgbToLinear(static_cast<float>(bits >> shift & 0xffu) / 255.0f);
    };
    return Vec3(channel(16), channel(8), channel(0));
}

std::string hexOf(const Vec3& shade) {
    const Vec3 encoded = screenColor(shade);
    const auto byte = [](float x) { return std::lround(x * 255.0f); };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(encoded.x), byte(encoded.y), byte(encoded.z));
}

bool drawShade() {
    Vec3 encoded = screenColor(picker.shade);
    ImGui::SetNextItemWidth(-FLT_MIN);
    const bool isMoved =
        ImGui::ColorPicker3("##picker", &encoded.x,
                            ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview |
                                ImGuiColorEditFlags_DisplayHSV);
    if (isMoved) {
        picker.shade = {srgbToLinear(encoded.x), srgbToLinear(encoded.y), srgbToLinear(encoded.z)};
    }
    return isMoved;
}

bool drawHex(const char* label) {
    text(fmt::format("{} hex", label).c_str(), &picker.hex, "#rrggbb",
         "The shade as the screen shows it (sRGB); the strength stays");
    const bool isTyping = ImGui::IsItemActive();
    const auto typed = parseHex(picker.hex);
    const bool isNew = typed && hexOf(*typed) != hexOf(picker.shade);
    if (isNew) { picker.shade = *typed; }
    if (!isTyping) { picker.hex = hexOf(picker.shade); }
    return isNew;
}

/// Esc gives back what was there; a click elsewhere keeps what was made.
bool drawPicker(const char* label, Vec3* value, float max, ImGuiID field) {
    ImGui::SetNextWindowSize({kPickerUnits * scale(), 0.0f});
    const bool isEscaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
    const bool wasOpen = picker.field == field;
    if (!ImGui::BeginPopup("picker")) {
        if (!wasOpen) { return false; }
        // Esc has closed it before this frame began.
        picker.field = 0;
        if (isEscaped) { *value = picker.before; }
        return isEscaped;
    }
    picker.field = field;
    if (ImGui::IsWindowAppearing()) { picker.before = *value; }
    if (ImGui::IsWindowAppearing() || *value != picker.made) {
        takeColor(*value);
        picker.hex = hexOf(picker.shade);
    }
    bool isChanged = drawShade();
    if (isChanged) { picker.hex = hexOf(picker.shade); }
    isChanged |= drawHex(label);
    isChanged |= number(fmt::format("{} strength", label).c_str(), &picker.strength,
                        {.format = "%.3f",
                         .speed = std::max(picker.strength * 0.01f, 0.001f),
                         .max = max,
                         .tooltip = "Multiplies the shade. What is above 1 stays while the shade changes"});
    if (isChanged) { *value = picker.made = picker.strength * picker.shade; }
    if (button("Pick from the picture", buttonWidth(1),
               "The next click on the picture takes its colour; Esc does not")) {
        waitForColor(field);
        ImGui::CloseCurrentPopup();
    }
    if (isEscaped) {
        isChanged = true;
        *value = picker.before;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
    return isChanged;
}

}  // namespace

bool color(const char* label, Vec3* value, float max, const char* tooltip) {
    static constexpr const char* kSuffixes[] = {"r", "g", "b"};
    const NumberStyle style{.format = "%.3f", .speed = 0.004f, .max = max, .tooltip = tooltip};
    beginRow(label, tooltip);
    ImGui::BeginGroup();
    const float side = ImGui::GetFrameHeight();
    if (ImGui::ColorButton("##swatch", screenColor4(*value), ImGuiColorEditFlags_NoTooltip, {side, side})) {
        ImGui::OpenPopup("picker");
    }
    record(WidgetKind::Button, fmt::format("{} patch", label), "");
    const ImGuiID field = ImGui::GetID("##swatch");
    bool changed = drawPicker(label, value, max, field);
    if (const auto given = takeGivenColor(field)) {
        // Of what is too bright the shade stays.
        *value = *given * std::min(1.0f, max / std::max(maxComponent(*given), 1e-20f));
        changed = true;
    }
    const float spacing = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SameLine(0.0f, spacing);
    changed |= dragFields3(label, value, style, kSuffixes, ImGui::GetContentRegionAvail().x);
    ImGui::EndGroup();
    record(WidgetKind::Color, label, fmt::format("{} {} {}", value->x, value->y, value->z));
    endRow();
    return changed;
}

}  // namespace glint::ui
