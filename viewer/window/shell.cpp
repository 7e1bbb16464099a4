#include "viewer/window/shell.h"

#define GLFW_INCLUDE_NONE
#include <algorithm>
#include <filesystem>

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include "viewer/base/units.h"
#include "viewer/model/object_edits.h"
#include "viewer/panels/panels.h"
#include "viewer/ui/eyedropper.h"
#include "viewer/ui/keyboard_walk.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"
#include "viewer/window/key_input.h"

namespace glint {
namespace {

constexpr float kSplitterUnits = 6.0f;
constexpr float kSmallestColumn = 300.0f;
constexpr float kSmallestImage = 240.0f;
constexpr float kColumnStep = 20.0f;
constexpr float kFineColumnStep = 2.0f;
constexpr float kExposureStep = 1.0f / 3.0f;
constexpr double kNoticeSeconds = 6.0;
constexpr float kLeastStatusShare = 0.35f;  // what a long message leaves of the status line
constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

GizmoMode nextOf(GizmoMode mode) { return static_cast<GizmoMode>((static_cast<int>(mode) + 1) % 4); }

}  // namespace

void Shell::handleKeys(Workspace* workspace) {
    SceneDocument& document = workspace->document;
    DisplaySettings& display = workspace->display;
    const auto is = [&](KeyAction action) { return isPressed(workspace->keys, action); };
    if (ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false)) {
        help_.close(&workspace->keys);
        workspace->lens.picksFocus = workspace->region.picks = workspace->inspector.picksArea = false;
        ui::stopWaitingForColor();
        if (!ImGui::IsAnyItemActive() && !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) { ui::endWalk(); }
    }
    if (is(KeyAction::Help)) { help_.toggle(); }
    if (is(KeyAction::OpenScene)) { workspace->sceneFiles.browse(); }
    if (is(KeyAction::Quit)) { dialogs.askToClose(*workspace); }
    if (is(KeyAction::Undo)) { workspace->history.askUndo(); }
    if (is(KeyAction::Redo)) { workspace->history.askRedo(); }
    if (is(KeyAction::Panels)) { panelsShown_ = !panelsShown_; }
    const float step = ImGui::GetIO().KeyShift ? kFineColumnStep : kColumnStep;
    if (isPressed(workspace->keys, KeyAction::ColumnWider, true)) { workspace->layout.columnUnits += step; }
    if (isPressed(workspace->keys, KeyAction::ColumnNarrower, true)) {
        workspace->layout.columnUnits -= step;
    }
    if (is(KeyAction::Walk)) { panelsShown_ = workspace->layout.walks = true; }
    if (is(KeyAction::Darker)) { display.exposureStops -= kExposureStep; }
    if (is(KeyAction::Brighter)) { display.exposureStops += kExposureStep; }
    if (document.isOpen()) { handleSceneKeys(workspace); }
}

void Shell::handleSceneKeys(Workspace* workspace) const {
    SceneDocument& document = workspace->document;
    DisplaySettings& display = workspace->display;
    const auto is = [&](KeyAction action) { return isPressed(workspace->keys, action); };
    bool& paused = workspace->render.request.paused;
    if (is(KeyAction::SavePng)) { workspace->filmFiles.savePng(display); }
    if (is(KeyAction::SaveScene)) { workspace->sceneFiles.saveAs(document.posted()); }
    if (is(KeyAction::Pause) && !workspace->render.isHeld) { paused = !paused; }
    if (is(KeyAction::Restart)) { workspace->render.restart(); }
    if (is(KeyAction::Keep)) { workspace->snapshots.askToKeep(); }
    if (is(KeyAction::Flip)) { display.flipsToRight = !display.flipsToRight; }
    if (is(KeyAction::NextCompareView)) {
        display.compareView =
            static_cast<CompareView>((static_cast<int>(display.compareView) + 1) % kCompareViews);
    }
    if (is(KeyAction::Region)) { workspace->region.askOrGiveUp(); }
    if (is(KeyAction::Compare)) { display.split = !display.split; }
    if (is(KeyAction::ResetCamera)) { document.resetCamera(); }
    const bool isOfSelection = is(KeyAction::FrameSelection);
    if (isOfSelection && document.selectedObject >= 0) { document.frameSelection(); }
    if (is(KeyAction::FrameScene) || (isOfSelection && document.selectedObject < 0)) {
        document.frameScene();
    }
    if (is(KeyAction::Gizmo)) { workspace->gizmo.mode = nextOf(workspace->gizmo.mode); }
    if (is(KeyAction::Hide)) { hideSelection(&document); }
    if (is(KeyAction::ShowAll)) { showAll(&document); }
    if (is(KeyAction::Duplicate)) { duplicateSelection(&document); }
    if (is(KeyAction::Delete)) { deleteSelection(&document); }
}

void Shell::drawSplitter(float x, float height, float* columnUnits) const {
    const float width = kSplitterUnits * ui::scale();
    ImGui::SetNextWindowPos({x, 0.0f});
    ImGui::SetNextWindowSize({width, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
    ImGui::Begin("##splitter", nullptr, kFixed | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoNav);
    ImGui::InvisibleButton("##handle", {width, height});
    const bool active = ImGui::IsItemActive();
    const bool hovered = ImGui::IsItemHovered() || active;
    if (hovered) { ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW); }
    if (active) { *columnUnits -= ImGui::GetIO().MouseDelta.x / ui::scale(); }
    ImGui::GetWindowDrawList()->AddRectFilled(
        {x, 0.0f}, {x + width, height},
        ImGui::GetColorU32(hovered ? ImGui::GetStyleColorVec4(ImGuiCol_SeparatorHovered)
                                   : theme::kPanelBackground));
    ui::area("Splitter", {x, 0.0f}, {x + width, height}, fmt::format("{:.0f}", *columnUnits));
    ImGui::End();
    ImGui::PopStyleVar(2);
}

void Shell::drawColumn(Workspace* workspace, float x, float height) {
    const float right = ImGui::GetIO().DisplaySize.x;
    ImGui::SetNextWindowPos({x, 0.0f});
    ImGui::SetNextWindowSize({right - x, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(6.0f * ui::scale(), 8.0f * ui::scale()));
    ImGui::Begin("##panels", nullptr, kFixed | ImGuiWindowFlags_NoScrollbar);
    drawPanels(workspace);
    ImGui::End();
    ImGui::PopStyleVar();
}

/// A save or a load just ended: the panel that tells may be closed.
bool Shell::showsNotice(const Notice& notice) {
    if (notice.text() != lastNotice_) {
        lastNotice_ = notice.text();
        noticeSince_ = ImGui::GetTime();
    }
    return !lastNotice_.empty() && ImGui::GetTime() - noticeSince_ < kNoticeSeconds;
}

/// The file, the size, and the pixel under the mouse.
std::string Shell::imageText(const Workspace& workspace) const {
    const SceneDescription& scene = workspace.document.draft();
    const auto& snapshot = view_.hoversOther() ? workspace.otherImage() : workspace.ownImage();
    std::string text =
        fmt::format("{}    {} × {} px    {:.0f} %", std::filesystem::path(scene.path).filename().string(),
                    scene.resolution.width, scene.resolution.height, view_.zoom() * 100.0f);
    if (const auto& pixel = view_.hoveredPixel(); pixel && snapshot && snapshot->width > 0) {
        const auto reference = workspace.convergence.usableReference();
        text += fmt::format("    ({}, {})  {}", pixel->x, pixel->y,
                            pixelReadout(*snapshot, workspace.display.shown, reference.get(), *pixel));
    }
    return text;
}

/// "PT · 90 passes · 38.0 s · error 2.60 % ± 0.31".
std::string Shell::progressText(const Workspace& workspace) {
    const SessionStatus& status = workspace.render.status();
    const auto& shown = workspace.ownImage();
    const std::string error = status.passes > 1 ? percentWithin(status.relativeError, status.relativeErrorLow,
                                                                status.relativeErrorHigh)
                                                : "–";
    return fmt::format("{} · {} · {}{} · {} {}", inCapitals(integratorInfo(status.integrator).alias),
                       passCount(status.passes), duration(status.renderSeconds),
                       shown && shown->isDenoised ? " · denoised" : "",
                       status.region ? "region's error" : "error", error);
}

void Shell::drawStatusLine(const Workspace& workspace, float y) {
    const ImGuiIO& io = ImGui::GetIO();
    const SessionStatus& status = workspace.render.status();
    ImGui::SetNextWindowPos({0.0f, y});
    ImGui::SetNextWindowSize({io.DisplaySize.x, io.DisplaySize.y - y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10.0f * ui::scale(), 4.0f * ui::scale()));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
    ImGui::Begin("##status", nullptr, kFixed | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoNav);
    std::string left = "No scene";
    const std::string help = workspace.keys.textOf(KeyAction::Help) + ": help";
    std::string right = help;
    if (workspace.document.isOpen()) {
        left = imageText(workspace);
        right = progressText(workspace) + "    " + help;
    }
    const std::string progress = right;
    const std::string& refused = status.error;
    const bool isMessage = showsNotice(workspace.notice) || !refused.empty();
    if (isMessage) { right = refused.empty() ? workspace.notice.text() : refused; }
    right.resize(std::min(right.size(), right.find('\n')));  // where it is in a file is the panel's
    const float rightX =
        std::max(io.DisplaySize.x - ImGui::CalcTextSize(right.c_str()).x - 10.0f * ui::scale(),
                 kLeastStatusShare * io.DisplaySize.x);
    ImGui::PushStyleColor(ImGuiCol_Text, theme::kTextDim);
    ImGui::PushClipRect({0.0f, y}, {rightX - 10.0f * ui::scale(), io.DisplaySize.y}, true);
    ImGui::TextUnformatted(left.c_str());
    ImGui::PopClipRect();
    ImGui::SameLine(rightX);
    const bool isError = isMessage && (workspace.notice.isError() || !refused.empty());
    ImGui::TextColored(isError ? theme::kTextError : theme::kTextDim, "%s", right.c_str());
    ImGui::PopStyleColor();
    ui::area("Progress", {rightX, y}, {io.DisplaySize.x, io.DisplaySize.y}, progress);
    if (isMessage) { ui::area("Status message", {rightX, y}, {io.DisplaySize.x, io.DisplaySize.y}, right); }
    ui::area("Status line", {0.0f, y}, {io.DisplaySize.x, io.DisplaySize.y}, left);
    ImGui::End();
    ImGui::PopStyleVar(2);
}

bool Shell::draw(Workspace* workspace, const ImagePanes& panes) {
    handleKeys(workspace);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float scale = ui::scale();
    const float statusTop = size.y - ImGui::GetFontSize() - 9.0f * scale;
    const float widest = std::max(kSmallestColumn, size.x / scale - kSmallestImage);
    float& columnUnits = workspace->layout.columnUnits;
    columnUnits = std::clamp(columnUnits, kSmallestColumn, widest);
    const float column = panelsShown_ ? columnUnits * scale : 0.0f;
    const float splitter = panelsShown_ ? kSplitterUnits * scale : 0.0f;
    const float imageRight = std::max(1.0f, size.x - column - splitter);
    const bool moving = view_.draw(workspace, panes, {0.0f, 0.0f}, {imageRight, statusTop});
    if (panelsShown_) {
        drawSplitter(imageRight, statusTop, &columnUnits);
        drawColumn(workspace, imageRight + splitter, statusTop);
    }
    drawStatusLine(*workspace, statusTop);
    help_.draw(&workspace->keys);
    dialogs.draw(workspace);
    return moving || ImGui::IsAnyItemActive();
}

}  // namespace glint
