// Pictures and checkpoints out, checkpoints in. Saves are atomic and run beside the render.
#include <imgui.h>

#include "viewer/panels/panels.h"
#include "viewer/window/theme.h"
#include "viewer/window/widgets.h"

namespace glint {

void drawCheckpointPanel(ViewerModel* model) {
    if (!ui::section("Checkpoint", false)) { return; }
    ImGui::PushID("checkpoint");
    FileSettings& files = model->files;
    ui::text("PNG file", &files.png, "render.png", "As shown: with exposure and tone map");
    if (ui::button("Save PNG", ui::buttonWidth(1), "Ctrl+S")) { model->savePng(); }

    ui::gap();
    ui::text("EXR file", &files.exr, "render.exr", "Linear radiance");
    ui::toggle("32-bit float", &files.exrFloat, "Otherwise 16-bit half");
    ui::toggle("Layers", &files.exrLayers, "Albedo, normals, depth, ids, bias and the bound at 90 % too");
    if (ui::button("Save EXR", ui::buttonWidth(1), "Without exposure and tone map")) { model->saveExr(); }

    ui::gap();
    ui::text("Checkpoint file", &files.checkpoint, "render.glintfilm",
             "A render that can be gone on with, to the last bit");
    const float half = ui::buttonWidth(2);
    if (ui::button("Save", half, "After the pass that is running")) { model->saveCheckpointFile(); }
    ImGui::SameLine();
    if (ui::button("Resume", half, "Goes on from the file. Another scene or other settings are refused")) {
        model->resumeCheckpoint();
    }
    ui::toggle("Automatic", &files.automatic, "Saves the checkpoint again and again while it renders");
    ui::number("Every", &files.automaticSeconds,
               {.format = "%.0f s",
                .speed = 1.0f,
                .min = 1.0f,
                .max = 86400.0f,
                .tooltip = "Between two automatic saves"});

    ui::gap();
    ui::text("Scene file", &files.json, "scene.json", "The scene as edited, as Glint JSON");
    if (ui::button("Save scene", ui::buttonWidth(1), "With every edit that was made here")) {
        model->saveSceneFile();
    }

    if (!model->fileMessage().empty()) {
        ui::gap();
        ImGui::PushStyleColor(ImGuiCol_Text,
                              model->fileMessageIsError() ? theme::kTextError : theme::kTextDim);
        ImGui::TextWrapped("%s", model->fileMessage().c_str());
        ImGui::PopStyleColor();
    }
    ImGui::PopID();
    ui::gap();
}

}  // namespace glint
