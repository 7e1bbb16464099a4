#include "viewer/ui/error_box.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

/// The lines of Error::format() below the message: the offending line, cut and cleaned, and the caret's.
struct MarkedLine {
    std::string text;
    size_t mark = std::string::npos;
};

MarkedLine markedLine(const Error& error) {
    const std::string all = error.format();
    const size_t caretLine = all.rfind('\n');
    if (caretLine == std::string::npos || all.find('^', caretLine) == std::string::npos) { return {}; }
    const size_t textLine = all.rfind('\n', caretLine - 1);
    if (textLine == std::string::npos) { return {}; }
    return {all.substr(textLine + 1, caretLine - textLine - 1), all.find('^', caretLine) - caretLine - 1};
}

std::string placeOf(const SourcePlace& place) {
    if (place.file.empty()) { return ""; }
    if (place.line == 0) { return place.file; }
    return place.column == 0 ? fmt::format("{}, line {}", place.file, place.line)
                             : fmt::format("{}, line {}, column {}", place.file, place.line, place.column);
}

/// The line with a bar under its mark; scrolls so that the mark is inside.
void drawMarkedLine(const MarkedLine& line) {
    const float height = ImGui::GetTextLineHeight() * 2.0f + ImGui::GetStyle().ScrollbarSize;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, theme::kImageBackground);
    ImGui::BeginChild("##line", {0.0f, height}, false, ImGuiWindowFlags_HorizontalScrollbar);
    const size_t mark = std::min(line.mark, line.text.size());
    const float offset = ImGui::CalcTextSize(line.text.c_str(), line.text.c_str() + mark).x;
    const float width = ImGui::GetFontSize() * 0.6f;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::TextUnformatted(line.text.c_str());
    const float y = corner.y + ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddTriangleFilled(
        {corner.x + offset, y + width}, {corner.x + offset + width, y + width},
        {corner.x + offset + width * 0.5f, y + width * 0.2f}, ImGui::GetColorU32(theme::kTextError));
    if (ImGui::IsWindowAppearing()) { ImGui::SetScrollFromPosX(offset, 0.5f); }
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

}  // namespace

bool drawErrorBox(const char* title, const Error& error) {
    const MarkedLine line = markedLine(error);
    const std::string place = placeOf(error.place);
    const ImGuiStyle& style = ImGui::GetStyle();
    const float inner = ImGui::GetContentRegionAvail().x - 2.0f * style.FramePadding.x;
    ImGui::BeginGroup();
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->ChannelsSplit(2);
    draw->ChannelsSetCurrent(1);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({corner.x + style.FramePadding.x, corner.y + style.FramePadding.y});
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + inner);
    ImGui::PushFont(ui::fonts().heading);
    ImGui::TextColored(theme::kTextError, "%s", title);
    ImGui::PopFont();
    ImGui::TextUnformatted(error.message.c_str());
    if (!place.empty()) { ImGui::TextColored(theme::kTextDim, "%s", place.c_str()); }
    ImGui::PopTextWrapPos();
    if (line.mark != std::string::npos) {
        ImGui::PushItemWidth(inner);
        ImGui::BeginChild("##frame", {inner, ImGui::GetTextLineHeight() * 2.0f + style.ScrollbarSize + 2.0f});
        drawMarkedLine(line);
        ImGui::EndChild();
        ImGui::PopItemWidth();
    }
    const bool dismissed = ui::button("Dismiss");
    ImGui::EndGroup();
    const float bottom = ImGui::GetItemRectMax().y + style.FramePadding.y;
    draw->ChannelsSetCurrent(0);
    draw->AddRectFilled(corner, {corner.x + inner + 2.0f * style.FramePadding.x, bottom},
                        ImGui::GetColorU32({0.21f, 0.165f, 0.16f, 1.0f}), style.ChildRounding);
    draw->ChannelsMerge();
    ImGui::SetCursorScreenPos({corner.x, bottom});
    ImGui::Dummy({inner, 1.0f});
    ImGui::EndGroup();
    return dismissed;
}

}  // namespace glint
