#include "viewer/window/dialogs.h"

#include <algorithm>
#include <filesystem>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include "viewer/base/units.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr float kWidthUnits = 440.0f;
constexpr float kBrowserRows = 14.0f;

/// Draws a question in the middle of the window; `drawAnswers` draws its buttons.
template <class DrawAnswers>
void drawQuestion(const char* name, const std::string& title, const std::string& text,
                  const DrawAnswers& drawAnswers) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float scale = ui::scale();
    ImGui::SetNextWindowPos({size.x * 0.5f, size.y * 0.5f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(kWidthUnits * scale, size.x - 20.0f * scale), 0.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(20.0f * scale, 16.0f * scale));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8.0f * scale);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.13f, 0.13f, 0.13f, 0.98f));
    ImGui::Begin(name, nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushFont(ui::fonts().heading);
    ImGui::TextWrapped("%s", title.c_str());
    ImGui::PopFont();
    ImGui::Dummy({0.0f, 2.0f * scale});
    ImGui::PushStyleColor(ImGuiCol_Text, theme::kTextDim);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
    ImGui::Dummy({0.0f, 6.0f * scale});
    ui::leaveSection();
    drawAnswers();
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

bool isEscaped() { return ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false); }

std::string fileName(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace

void Dialogs::drawOverwrite(OverwriteGuard* guard) const {
    const std::vector<std::string>& paths = guard->asked();
    const size_t more = paths.size() - 1;
    const std::string place = Notice::placeOf(paths.front());
    const std::string title = more > 0 ? fmt::format("Replace {} and {} more?", fileName(paths.front()), more)
                                       : fmt::format("Replace {}?", fileName(paths.front()));
    const std::string text =
        more > 0
            ? fmt::format("{} and {} more are there already, and are not from this session.", place, more)
            : fmt::format("{} is there already, and is not from this session.", place);
    drawQuestion("##overwrite", title, text, [&] {
        const float width = ui::buttonWidth(2);
        const bool isAgreed = ui::button("Replace", width);
        ImGui::SameLine();
        const char* keep = more > 0 ? "Keep the old files" : "Keep the old file";
        const bool isRefused = ui::button(keep, width, "Esc") || isEscaped();
        if (isAgreed) {
            guard->agree();
        } else if (isRefused) {
            guard->refuse();
        }
        ui::itemArea("Question", title);
    });
}

void Dialogs::drawEndOfSeries(const FrameSeries& frames) {
    const std::string text = fmt::format("Picture {}.", frames.progressText());
    drawQuestion("##series", "Pictures are being rendered", text, [&] {
        const float width = ui::buttonWidth(2);
        if (ui::button("Close", width, "The pictures that are done stay")) { isDecided_ = true; }
        ImGui::SameLine();
        if (ui::button("Go on", width, "Esc") || isEscaped()) { asksToClose_ = false; }
    });
}

void Dialogs::drawClose(Workspace* workspace) {
    const SceneDocument& document = workspace->document;
    if (!document.hasUnsavedEdits()) {
        if (workspace->frames.isRunning()) { return drawEndOfSeries(workspace->frames); }
        asksToClose_ = false;
        return;
    }
    const std::string saved = fileName(workspace->sceneFiles.saved);
    std::string text = fmt::format("Saving writes the scene as edited to {}.", saved);
    if (workspace->notice.isError() && !isSaving_) { text += " " + workspace->notice.text(); }
    drawQuestion("##close", fmt::format("{} has unsaved edits", fileName(document.draft().path)), text, [&] {
        const float width = ui::buttonWidth(3);
        if (ui::button("Save and close", width)) {
            workspace->sceneFiles.save(document.posted());
            isSaving_ = true;
        }
        ImGui::SameLine();
        if (ui::button("Close", width, "The edits are lost")) { isDecided_ = true; }
        ImGui::SameLine();
        if (ui::button("Go on", width, "Esc") || isEscaped()) { asksToClose_ = false; }
    });
}

void Dialogs::drawRecovery(Workspace* workspace) const {
    SessionBackup& backup = workspace->backup;
    const SessionBackup::Leftover& leftover = *backup.leftover();
    const std::string text =
        fmt::format("{} was open, with its edits and {}.", leftover.scenePath, passCount(leftover.passes));
    drawQuestion("##recovery", "The last session ended unexpectedly", text, [&] {
        const float width = ui::buttonWidth(2);
        const bool isWanted = ui::button("Restore", width, "The scene as it was edited, and its film");
        ImGui::SameLine();
        const bool isUnwanted = ui::button("Discard", width);
        if (isWanted) {
            workspace->filmFiles.resume(backup.takeOver());
        } else if (isUnwanted) {
            backup.discard();
        }
    });
}

void Dialogs::drawBrowser(FileDialog* dialog) const {
    FileBrowser& browser = dialog->browser;
    const bool isForSaving = dialog->question().isForSaving;
    drawQuestion("##browser", dialog->question().title, browser.folder(), [&] {
        std::string chosen;
        if (ui::text("Name", &browser.typed, "a file, a folder, or a path", "~ is the home folder")) {
            chosen = browser.typed;
        }
        ImGui::BeginChild("##entries", {0.0f, kBrowserRows * ImGui::GetTextLineHeightWithSpacing()}, false,
                          ImGuiWindowFlags_NavFlattened);
        for (const FileBrowser::Entry& entry : browser.entries()) {
            if (!ui::selectable(entry.name.c_str(), entry.name == browser.typed)) { continue; }
            // A click must not replace a file at once.
            (isForSaving && !entry.isFolder ? browser.typed : chosen) = entry.name;
        }
        ImGui::EndChild();
        const float width = ui::buttonWidth(2);
        if (ui::button(isForSaving ? "Save this" : "Open this", width) && !browser.typed.empty()) {
            chosen = browser.typed;
        }
        ImGui::SameLine();
        const bool isCancelled = ui::button("Cancel", width, "Esc") || isEscaped();
        if (!chosen.empty()) { dialog->choose(chosen); }
        if (isCancelled) { dialog->close(); }
    });
}

void Dialogs::draw(Workspace* workspace) {
    if (!workspace->overwrite.asked().empty()) { return drawOverwrite(&workspace->overwrite); }
    const bool isUnderWay = workspace->busy() || !workspace->document.hasUnsavedEdits();
    isSaving_ = isSaving_ && isUnderWay;
    if (asksToClose_) { return drawClose(workspace); }
    if (workspace->sceneFiles.dialog.isOpen()) { return drawBrowser(&workspace->sceneFiles.dialog); }
    if (workspace->backup.leftover() != nullptr) { drawRecovery(workspace); }
}

void Dialogs::askToClose(const Workspace& workspace) {
    asksToClose_ = workspace.document.hasUnsavedEdits() || workspace.frames.isRunning();
    isDecided_ = !asksToClose_;
}

bool Dialogs::mustClose(const SceneDocument& document) const {
    return isDecided_ || (isSaving_ && !document.hasUnsavedEdits());
}

}  // namespace glint
