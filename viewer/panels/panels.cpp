#include "viewer/panels/panels.h"

#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <imgui.h>

#include "viewer/model/workspace.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/keyboard_walk.h"
#include "viewer/ui/widgets.h"

// A line for each, in their order on the screen; <name>_panel.cpp defines Panel <name>Panel().
#define GLINT_PANELS(X) \
    X(scene)            \
    X(render)           \
    X(convergence)      \
    X(sppm)             \
    X(raycast)          \
    X(camera)           \
    X(lens)             \
    X(object)           \
    X(outliner)         \
    X(materials)        \
    X(library)          \
    X(profile)          \
    X(lights)           \
    X(display)          \
    X(snapshots)        \
    X(inspector)        \
    X(image)            \
    X(frames)           \
    X(history)          \
    X(checkpoint)       \
    X(log)

namespace glint {

#define GLINT_DECLARE_PANEL(name) Panel name##Panel();
GLINT_PANELS(GLINT_DECLARE_PANEL)
#undef GLINT_DECLARE_PANEL

namespace {

constexpr Panel (*kPanels[])() = {
#define GLINT_LIST_PANEL(name) name##Panel,
    GLINT_PANELS(GLINT_LIST_PANEL)
#undef GLINT_LIST_PANEL
};

bool isShown(const Panel& panel, Workspace* workspace) {
    if (!workspace->document.isOpen()) { return panel.withoutScene != WithoutScene::Hides; }
    return panel.isShown == nullptr || panel.isShown(workspace);
}

void drawPanel(const Panel& panel, Workspace* workspace) {
    ImGui::PushID(panel.title);
    if (!workspace->document.isOpen() && panel.withoutScene == WithoutScene::Hints) {
        ui::hint("No scene is open.");
    } else {
        panel.draw(workspace);
    }
    ImGui::PopID();
}

/// A button for each panel, lit where it is open: none is farther away than a click.
void drawStrip(Workspace* workspace) {
    std::vector<std::string_view> titles;
    std::vector<char> isOpen;
    for (const auto& makePanel : kPanels) {
        const Panel panel = makePanel();
        if (!isShown(panel, workspace)) { continue; }
        titles.emplace_back(panel.title);
        const auto known = workspace->layout.open.find(panel.title);
        isOpen.push_back(known != workspace->layout.open.end() ? known->second : panel.isOpenAtFirst);
    }
    const int pressed = ui::strip("Go to ", titles, isOpen);
    if (pressed >= 0) { workspace->layout.goTo = titles[static_cast<size_t>(pressed)]; }
}

}  // namespace

void drawPanels(Workspace* workspace) {
    drawStrip(workspace);
    WindowLayout& layout = workspace->layout;
    const std::string goTo = std::exchange(layout.goTo, {});
    ImGui::BeginChild("##sections", {0.0f, 0.0f}, false,
                      ImGuiWindowFlags_AlwaysVerticalScrollbar | ImGuiWindowFlags_NavFlattened);
    if (std::exchange(layout.walks, false)) { ui::beginWalkHere(); }
    for (size_t i = 0; i < std::size(kPanels); ++i) {
        const Panel panel = kPanels[i]();
        if (!isShown(panel, workspace)) { continue; }
        const auto [known, isNew] = layout.open.try_emplace(panel.title, panel.isOpenAtFirst);
        const bool isOpen = ui::section(panel.title, known->second, panel.tooltip, goTo == panel.title);
        known->second = isOpen;
        if (!isOpen) { continue; }
        drawPanel(panel, workspace);
        if (i + 1 < std::size(kPanels)) { ui::gap(); }
    }
    ImGui::EndChild();
}

}  // namespace glint
