#include "viewer/window/shell.h"

#define GLFW_INCLUDE_NONE
#include <algorithm>
#include <filesystem>
#include <iterator>

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include "viewer/base/units.h"
#include "viewer/model/object_edits.h"
#include "viewer/panels/panels.h"
#include "viewer/ui/eyedropper.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr float kSplitterUnits = 6.0f;
constexpr float kSmallestColumn = 300.0f;
constexpr float kSmallestImage = 240.0f;
constexpr float kHelpColumnUnits = 470.0f;
constexpr float kHelpKeysUnits = 165.0f;
constexpr float kExposureStep = 1.0f / 3.0f;
constexpr double kNoticeSeconds = 6.0;
constexpr float kLeastStatusShare = 0.35f;  // what a long message leaves of the status line
constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

struct KeyHelp {
    const char* keys;
    const char* does;
};

constexpr KeyHelp kKeyHelp[] = {
    {"Left drag", "orbit around the target"},
    {"Right or middle drag", "pan (also Shift + left drag)"},
    {"Ctrl + left drag", "look around"},
    {"Ctrl + click, T", "focus on what is under the mouse"},
    {"Wheel", "dolly: closer or farther"},
    {"Ctrl + wheel, + and -", "zoom of the picture, around the mouse"},
    {"Ctrl + right drag", "move the zoomed picture (also the middle button)"},
    {"1, 0", "picture at 1:1 pixels, at its automatic size"},
    {"W A S D", "fly forwards, left, back, right"},
    {"E, Q", "fly up, down"},
    {"Shift", "fly fast"},
    {"Click", "select, for the outliner and the materials"},
    {"F, Shift + F", "frame the selected object, the whole scene"},
    {"G", "gizmo: move, rotate, scale, none (Ctrl: in steps)"},
    {"H, Alt + H", "hide the selected object, show all"},
    {"Ctrl + D, Del", "duplicate, delete the selected object"},
    {"Home", "the scene file's camera"},
    {"Space", "pause and go on"},
    {"R", "restart"},
    {"B", "draw a region that alone is rendered on, and give it up"},
    {"V, held", "this spot first: renders on around the mouse"},
    {"C", "compare two integrators"},
    {"K", "keep the picture, to compare it later"},
    {"N, X", "another way to compare; the other one of both"},
    {"[ and ]", "exposure by a third of a stop"},
    {"Ctrl + Z", "undo, also a restart or opening a scene"},
    {"Ctrl + Shift + Z", "redo (also Ctrl + Y)"},
    {"Ctrl + O", "look for a scene to open"},
    {"Ctrl + S, Ctrl + Shift + S", "save the PNG, save the scene as …"},
    {"Ctrl + Q", "quit"},
    {"Tab", "show or hide the panels"},
    {"F1", "this help"},
};

GizmoMode nextOf(GizmoMode mode) { return static_cast<GizmoMode>((static_cast<int>(mode) + 1) % 4); }

bool isPressed(int key) { return ImGui::IsKeyPressed(key, false); }

}  // namespace

void Shell::handleKeys(Workspace* workspace) {
    const ImGuiIO& io = ImGui::GetIO();
    SceneDocument& document = workspace->document;
    DisplaySettings& display = workspace->display;
    if (isPressed(GLFW_KEY_F1)) { helpShown_ = !helpShown_; }
    if (isPressed(GLFW_KEY_ESCAPE)) {
        helpShown_ = workspace->lens.picksFocus = workspace->region.picks = workspace->inspector.picksArea =
            false;
        ui::stopWaitingForColor();
    }
    if (io.WantTextInput) { return; }
    if (io.KeyCtrl) {
        if (isPressed(GLFW_KEY_O)) { workspace->sceneFiles.browse(); }
        if (isPressed(GLFW_KEY_S) && document.isOpen()) {
            io.KeyShift ? workspace->sceneFiles.saveAs(document.posted())
                        : workspace->filmFiles.savePng(display);
        }
        if (isPressed(GLFW_KEY_D)) { duplicateSelection(&document); }
        if (isPressed(GLFW_KEY_Q)) { dialogs.askToClose(document); }
        const bool isRedo = isPressed(GLFW_KEY_Y) || (io.KeyShift && isPressed(GLFW_KEY_Z));
        if (isRedo) {
            workspace->history.askRedo();
        } else if (isPressed(GLFW_KEY_Z)) {
            workspace->history.askUndo();
        }
        return;
    }
    if (isPressed(GLFW_KEY_TAB)) { panelsShown_ = !panelsShown_; }
    if (isPressed(GLFW_KEY_LEFT_BRACKET)) { display.exposureStops -= kExposureStep; }
    if (isPressed(GLFW_KEY_RIGHT_BRACKET)) { display.exposureStops += kExposureStep; }
    if (!document.isOpen()) { return; }
    bool& paused = workspace->render.request.paused;
    if (isPressed(GLFW_KEY_SPACE)) { paused = !paused; }
    if (isPressed(GLFW_KEY_R)) { workspace->render.restart(); }
    if (isPressed(GLFW_KEY_K)) { workspace->snapshots.askToKeep(); }
    if (isPressed(GLFW_KEY_X)) { display.flipsToRight = !display.flipsToRight; }
    if (isPressed(GLFW_KEY_N)) {
        display.compareView =
            static_cast<CompareView>((static_cast<int>(display.compareView) + 1) % kCompareViews);
    }
    if (isPressed(GLFW_KEY_B)) { workspace->region.askOrGiveUp(); }
    if (isPressed(GLFW_KEY_C)) { display.split = !display.split; }
    if (isPressed(GLFW_KEY_HOME)) { document.resetCamera(); }
    if (isPressed(GLFW_KEY_F)) {
        const bool isOfAll = io.KeyShift || document.selectedObject < 0;
        isOfAll ? document.frameScene() : document.frameSelection();
    }
    if (isPressed(GLFW_KEY_G)) { workspace->gizmo.mode = nextOf(workspace->gizmo.mode); }
    if (isPressed(GLFW_KEY_H)) { io.KeyAlt ? showAll(&document) : hideSelection(&document); }
    if (isPressed(GLFW_KEY_DELETE)) { deleteSelection(&document); }
}

void Shell::drawSplitter(float x, float height, float* columnUnits) const {
    const float width = kSplitterUnits * ui::scale();
    ImGui::SetNextWindowPos({x, 0.0f});
    ImGui::SetNextWindowSize({width, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
    ImGui::Begin("##splitter", nullptr, kFixed | ImGuiWindowFlags_NoScrollbar);
    ImGui::InvisibleButton("##handle", {width, height});
    const bool active = ImGui::IsItemActive();
    const bool hovered = ImGui::IsItemHovered() || active;
    if (hovered) { ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW); }
    if (active) { *columnUnits -= ImGui::GetIO().MouseDelta.x / ui::scale(); }
    ImGui::GetWindowDrawList()->AddRectFilled(
        {x, 0.0f}, {x + width, height},
        ImGui::GetColorU32(hovered ? ImGui::GetStyleColorVec4(ImGuiCol_SeparatorHovered)
                                   : theme::kPanelBackground));
    ui::area("Splitter", {x, 0.0f}, {x + width, height}, "");
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
    const auto& snapshot = view_.hoversOther() ? workspace.otherPicture() : workspace.ownPicture();
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

void Shell::drawStatusLine(const Workspace& workspace, float y) {
    const ImGuiIO& io = ImGui::GetIO();
    const SessionStatus& status = workspace.render.status();
    ImGui::SetNextWindowPos({0.0f, y});
    ImGui::SetNextWindowSize({io.DisplaySize.x, io.DisplaySize.y - y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10.0f * ui::scale(), 4.0f * ui::scale()));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
    ImGui::Begin("##status", nullptr, kFixed | ImGuiWindowFlags_NoScrollbar);
    std::string left = "No scene";
    std::string right = "F1: help";
    if (workspace.document.isOpen()) {
        left = imageText(workspace);
        const auto& shown = workspace.ownPicture();
        right = fmt::format("{}{}    {}    {} {}    F1: help",
                            shown && shown->isDenoised ? "denoised    " : "", passCount(status.passes),
                            duration(status.renderSeconds), status.region ? "region's error" : "error",
                            status.passes > 1 ? percent(status.relativeError) : "–");
    }
    const std::string& refused = status.error;
    const bool isMessage = showsNotice(workspace.notice) || !refused.empty();
    if (isMessage) { right = refused.empty() ? workspace.notice.text() : refused; }
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
    if (isMessage) { ui::area("Status message", {rightX, y}, {io.DisplaySize.x, io.DisplaySize.y}, right); }
    ui::area("Status line", {0.0f, y}, {io.DisplaySize.x, io.DisplaySize.y}, left);
    ImGui::End();
    ImGui::PopStyleVar(2);
}

void Shell::drawHelp() {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x * 0.5f, size.y * 0.5f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(22.0f * ui::scale(), 16.0f * ui::scale()));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8.0f * ui::scale());
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.13f, 0.13f, 0.13f, 0.97f));
    ImGui::Begin(
        "##help", nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushFont(ui::fonts().heading);
    ImGui::TextUnformatted("Mouse and keyboard");
    ImGui::PopFont();
    ImGui::Dummy({0.0f, 4.0f * ui::scale()});
    // Two columns, to fit on a screen of 720 rows.
    const size_t half = (std::size(kKeyHelp) + 1) / 2;
    const float column = kHelpColumnUnits * ui::scale();
    for (size_t i = 0; i < std::size(kKeyHelp); ++i) {
        const size_t shown = i / 2 + i % 2 * half;
        if (shown >= std::size(kKeyHelp)) { break; }
        const float left = static_cast<float>(i % 2) * column + ImGui::GetStyle().WindowPadding.x;
        if (i % 2 == 1) { ImGui::SameLine(left); }
        ImGui::TextColored(theme::kTextDim, "%s", kKeyHelp[shown].keys);
        ImGui::SameLine(left + kHelpKeysUnits * ui::scale());
        ImGui::TextUnformatted(kKeyHelp[shown].does);
    }
    ImGui::End();
    ImGui::PopStyleColor();
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
    if (helpShown_) { drawHelp(); }
    dialogs.draw(workspace);
    return moving || ImGui::IsAnyItemActive();
}

}  // namespace glint
