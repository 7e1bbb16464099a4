#include "viewer/ui/widgets.h"

#include <algorithm>
#include <cfloat>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "engine/base/nearest_name.h"
#include "engine/math/color.h"
#include "viewer/base/typed_path.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widget_row.h"

namespace glint::ui {
namespace {

constexpr float kLabelShare = 0.35f;  // of a row's width
constexpr float kTooltipDelaySeconds = 0.5f;
constexpr float kTooltipWidthInLines = 22.0f;  // of the font's size
constexpr float kNarrowestValueInLines = 4.0f;

WidgetRegistry* registry = nullptr;
const Fonts* frameFonts = nullptr;
float frameScale = 1.0f;

/// To the item that was drawn last, also where it is in a list of its own within the column.
void scrollHere() {
    ImGui::SetScrollHereY(0.5f);
    const ImGuiWindow* window = ImGui::GetCurrentWindow();
    if ((window->Flags & ImGuiWindowFlags_ChildWindow) != 0) {
        ImGui::ScrollToBringRectIntoView(window->ParentWindow, window->Rect());
    }
}

bool isCentreVisible(const ImVec2& min, const ImVec2& max) {
    const ImVec2 centre{(min.x + max.x) * 0.5f, (min.y + max.y) * 0.5f};
    return ImGui::GetCurrentWindow()->ClipRect.Contains(centre);
}

}  // namespace

WidgetRegistry* frameRegistry() { return registry; }

Vec3 screenColor(const Vec3& linear) {
    const auto encode = [](float x) { return linearToSrgb(clampf(x, 0.0f, 1.0f)); };
    return {encode(linear.x), encode(linear.y), encode(linear.z)};
}

ImVec4 screenColor4(const Vec3& linear) {
    const Vec3 encoded = screenColor(linear);
    return {encoded.x, encoded.y, encoded.z, 1.0f};
}

void record(WidgetKind kind, std::string_view label, std::string shown) {
    const ImVec2 min = ImGui::GetItemRectMin();
    const ImVec2 max = ImGui::GetItemRectMax();
    if (registry->wantsScroll(label)) { scrollHere(); }
    registry->add(kind, label, {min.x, min.y}, {max.x, max.y}, isCentreVisible(min, max), std::move(shown));
}

void tooltip(const char* text) {
    if (text == nullptr) { return; }
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * kTooltipWidthInLines);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/// Left of the window that the item is in, where there is room: it covers none of the numbers. Nothing while
/// something is edited.
void tooltipBeside(const char* text) {
    if (text == nullptr || ImGui::IsAnyItemActive()) { return; }
    const ImVec2 corner = ImGui::GetCurrentWindow()->RootWindow->Pos;
    const float gap = 6.0f * frameScale;
    if (corner.x > kTooltipWidthInLines * ImGui::GetFontSize()) {
        ImGui::SetNextWindowPos({corner.x - gap, ImGui::GetItemRectMin().y}, ImGuiCond_Always, {1.0f, 0.0f});
    }
    tooltip(text);
}

void tooltipForItem(const char* tooltip) {
    if (ImGui::IsItemHovered() && ImGui::GetCurrentContext()->HoveredIdTimer > kTooltipDelaySeconds) {
        tooltipBeside(tooltip);
    }
}

void beginRow(const char* label, const char* tooltip) {
    ImGui::PushID(label);
    const float start = ImGui::GetCursorPosX();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(theme::kTextDim, "%s", label);
    if (ImGui::IsItemHovered()) { tooltipBeside(tooltip); }
    const float labelWidth = ImGui::GetItemRectSize().x + ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SameLine(start + std::max({width * kLabelShare, ImGui::GetFontSize() * 6.5f, labelWidth}));
    ImGui::SetNextItemWidth(-FLT_MIN);
}

void endRow() { ImGui::PopID(); }

void beginFrame(WidgetRegistry* registryOfFrame, const Fonts* fontsOfFrame, float scaleOfFrame) {
    registry = registryOfFrame;
    frameFonts = fontsOfFrame;
    frameScale = scaleOfFrame;
    registry->beginFrame();
}

float scale() { return frameScale; }
const Fonts& fonts() { return *frameFonts; }

int strip(const char* prefix, std::span<const std::string_view> names, std::span<const char> isLit) {
    registry->setSection("");
    int pressed = -1;
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    const float spacing = 3.0f * frameScale;
    const ImVec2 padding{5.0f * frameScale, 2.0f * frameScale};
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(spacing, spacing));
    for (size_t i = 0; i < names.size(); ++i) {
        const std::string name(names[i]);
        const float width = ImGui::CalcTextSize(name.c_str()).x + 2.0f * padding.x;
        const bool fits = i > 0 && ImGui::GetItemRectMax().x + spacing + width <= right;
        if (fits) { ImGui::SameLine(); }
        ImGui::PushStyleColor(ImGuiCol_Text,
                              isLit[i] != 0 ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : theme::kTextDim);
        if (ImGui::Button(name.c_str())) { pressed = static_cast<int>(i); }
        ImGui::PopStyleColor();
        record(WidgetKind::Button, fmt::format("{}{}", prefix, name), isLit[i] != 0 ? "on" : "off");
    }
    ImGui::PopStyleVar(2);
    return pressed;
}

bool section(const char* label, bool openAtFirst, const char* tooltip, bool goTo) {
    registry->setSection("");
    const auto words = registry->takeAssignment(label);
    if (goTo) { ImGui::SetNextItemOpen(true, ImGuiCond_Always); }
    if (words) { ImGui::SetNextItemOpen(!words->empty() && (*words)[0] == "open", ImGuiCond_Always); }
    ImGui::PushFont(frameFonts->heading);
    const bool open = ImGui::CollapsingHeader(label, openAtFirst ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    ImGui::PopFont();
    record(WidgetKind::Section, label, open ? "open" : "closed");
    if (goTo) { ImGui::SetScrollHereY(0.0f); }
    tooltipForItem(tooltip);
    registry->setSection(label);
    return open;
}

void leaveSection() { registry->setSection(""); }

void heading(const char* text) {
    ImGui::Dummy({0.0f, 2.0f * frameScale});
    ImGui::PushFont(frameFonts->heading);
    ImGui::TextColored(theme::kTextDim, "%s", text);
    ImGui::PopFont();
}

void gap() { ImGui::Dummy({0.0f, 3.0f * frameScale}); }

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
            if (i == *index) { ImGui::SetItemDefaultFocus(); }
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
    if (const auto words = registry->takeAssignment(label)) {
        *value = fmt::format("{}", fmt::join(*words, " "));
    }
    const bool entered =
        ImGui::InputTextWithHint("##value", hintText, value, ImGuiInputTextFlags_EnterReturnsTrue);
    record(WidgetKind::Text, label, *value);
    tooltipForItem(tooltip);
    endRow();
    return entered;
}

bool file(const char* label, std::string* value, const char* hintText, const char* tooltip) {
    const bool entered = text(label, value, hintText, tooltip);
    if (entered || !ImGui::IsItemActive()) { *value = typedPath(*value); }
    return entered;
}

bool button(const char* label, float width, const char* tooltip, bool emphasis) {
    if (emphasis) { ImGui::PushStyleColor(ImGuiCol_Button, theme::kAccent); }
    const bool pressed = ImGui::Button(label, {width, 0.0f});
    if (emphasis) { ImGui::PopStyleColor(); }
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
    // Where a label leaves hardly any room, lines of one letter would be no better than a cut.
    const bool wraps = ImGui::GetContentRegionAvail().x > kNarrowestValueInLines * ImGui::GetFontSize();
    ImGui::PushTextWrapPos(wraps ? 0.0f : -1.0f);
    ImGui::TextUnformatted(shown.c_str());
    ImGui::PopTextWrapPos();
    record(WidgetKind::Value, label, shown);
    if (ImGui::IsItemHovered()) { tooltipBeside(tooltip); }
    endRow();
    ImGui::PopStyleVar(2);
}

void hint(const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme::kTextDim);
    ImGui::TextWrapped("%s", text);
    ImGui::PopStyleColor();
}

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
