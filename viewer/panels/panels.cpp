#include "viewer/panels/panels.h"

#include <iterator>

#include <imgui.h>

#include "viewer/model/workspace.h"
#include "viewer/panels/panel.h"
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
    X(outliner)         \
    X(materials)        \
    X(profile)          \
    X(lights)           \
    X(display)          \
    X(inspector)        \
    X(image)            \
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

}  // namespace

void drawPanels(Workspace* workspace) {
    for (size_t i = 0; i < std::size(kPanels); ++i) {
        const Panel panel = kPanels[i]();
        if (!isShown(panel, workspace)) { continue; }
        if (!ui::section(panel.title, panel.isOpenAtFirst, panel.tooltip)) { continue; }
        drawPanel(panel, workspace);
        if (i + 1 < std::size(kPanels)) { ui::gap(); }
    }
}

}  // namespace glint
