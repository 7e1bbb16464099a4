// The log's recent lines, newest at the bottom.
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "engine/base/log.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

ImVec4 colorOf(LogLevel level) {
    if (level == LogLevel::Error) { return theme::kTextError; }
    return level == LogLevel::Warning ? theme::kTextWarning : ImGui::GetStyleColorVec4(ImGuiCol_Text);
}

void drawLine(const LogLine& line) {
    ImGui::TextColored(theme::kTextDim, "%7.1f", line.seconds);
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, colorOf(line.level));
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(line.text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void draw() {
    static std::vector<LogLine> lines;
    static uint64_t seen = 0;
    std::vector<LogLine> fresh = recentLogLines(&seen);
    const bool grew = !fresh.empty();
    if (grew) { lines = std::move(fresh); }
    ImGui::BeginChild("log", {0.0f, ImGui::GetTextLineHeightWithSpacing() * 10.0f});
    const bool follow = ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - 1.0f;
    for (const LogLine& line : lines) {
        drawLine(line);
    }
    if (grew && follow) { ImGui::SetScrollHereY(1.0f); }
    ImGui::EndChild();
    if (ui::button("Copy log", ui::buttonWidth(1))) {
        std::string all;
        for (const LogLine& line : lines) {
            all += fmt::format("{:.1f} {}\n", line.seconds, line.text);
        }
        ImGui::SetClipboardText(all.c_str());
    }
}

}  // namespace

Panel logPanel() { return {"Log", false, OfParts<draw>::call}; }

}  // namespace glint
