// Which scene is open, opening another, and what went wrong with that.
#include <imgui.h>

#include "engine/io/importer.h"
#include "viewer/panels/error_box.h"
#include "viewer/panels/panels.h"
#include "viewer/window/theme.h"
#include "viewer/window/widgets.h"

namespace glint {

void drawScenePanel(ViewerModel* model) {
    if (!ui::section("Scene", true)) { return; }
    ImGui::PushID("scene");
    static const std::string help = "A scene to open: " + listImporters() + ". Enter opens it.";
    const bool entered = ui::text("File", &model->files.scene, "scene.json, .txt, .obj, .ply", help.c_str());
    const char* action = model->opening() ? "Opening…" : "Open";
    if ((ui::button(action, ui::buttonWidth(1)) || entered) && !model->opening()) {
        model->open(model->files.scene);
    }
    if (model->openError()) {
        ui::gap();
        if (drawErrorBox("This scene cannot be opened", *model->openError())) { model->dismissOpenError(); }
        if (model->hasScene()) { ui::hint("The scene that was open goes on."); }
    }
    if (model->hasScene() && !model->draft().title.empty()) { ui::hint(model->draft().title.c_str()); }
    ImGui::PopID();
    ui::gap();
}

void drawPanels(ViewerModel* model) {
    drawScenePanel(model);
    drawRenderPanel(model);
    drawConvergencePanel(model);
    drawSppmPanel(model);
    drawCameraPanel(model);
    drawMaterialsPanel(model);
    drawLightsPanel(model);
    drawDisplayPanel(model);
    drawImagePanel(model);
    drawCheckpointPanel(model);
    drawLogPanel();
}

}  // namespace glint
