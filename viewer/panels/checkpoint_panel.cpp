// Pictures and checkpoints out, checkpoints in. Saves are atomic and run beside the render.
#include <imgui.h>

#include "viewer/model/display_settings.h"
#include "viewer/model/film_files.h"
#include "viewer/model/key_map.h"
#include "viewer/model/notice.h"
#include "viewer/model/scene_document.h"
#include "viewer/model/scene_files.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"

namespace glint {

namespace {

void drawImages(FilmFiles* files, FileDialog* dialog, const DisplaySettings& display, const KeyMap& keys) {
    ui::file("PNG file", &files->png, "render.png", "As shown: with exposure and tone map");
    const float half = ui::buttonWidth(2);
    if (ui::button("Save PNG", half, keys.tip("As it is shown", KeyAction::SavePng).c_str())) {
        files->savePng(display);
    }
    ImGui::SameLine();
    if (ui::button("Save PNG as…", half, "Into another folder or under another name")) {
        dialog->ask({"Save the picture as", files->png, true, [files, display](const std::string& path) {
                         files->png = path;
                         files->savePng(display);
                     }});
    }

    ui::gap();
    ui::file("EXR file", &files->exr, "render.exr", "Linear radiance");
    ui::toggle("32-bit float", &files->exrFloat, "Otherwise 16-bit half");
    ui::toggle("Layers", &files->exrLayers, "Albedo, normals, depth, ids, bias and the bound at 90 % too");
    if (ui::button("Save EXR", ui::buttonWidth(1), "Without exposure and tone map")) {
        files->saveExr(display);
    }
}

void drawCheckpoint(FilmFiles* files) {
    ui::gap();
    ui::file("Checkpoint file", &files->checkpoint, "render.glintfilm",
             "A render that can be gone on with, to the last bit");
    const float half = ui::buttonWidth(2);
    if (ui::button("Save", half, "After the pass that is running")) { files->saveCheckpointFile(); }
    ImGui::SameLine();
    if (ui::button("Resume", half, "Goes on from the file, with the scene that it is of")) {
        files->resume(files->checkpoint);
    }
    ui::toggle("Automatic", &files->isAutomatic, "Saves the checkpoint again and again while it renders");
    ui::number("Every", &files->automaticSeconds,
               {.format = "%.0f s",
                .speed = 1.0f,
                .min = 1.0f,
                .max = 86400.0f,
                .tooltip = "Between two automatic saves"});
}

void drawNotice(const Notice& notice) {
    if (notice.text().empty()) { return; }
    ui::gap();
    ImGui::PushStyleColor(ImGuiCol_Text, notice.isError() ? theme::kTextError : theme::kTextDim);
    ImGui::TextWrapped("%s", notice.text().c_str());
    ImGui::PopStyleColor();
}

void draw(FilmFiles* files, SceneFiles* scenes, const SceneDocument* document, const DisplaySettings* display,
          const Notice* notice, const KeyMap* keys) {
    drawImages(files, &scenes->dialog, *display, *keys);
    drawCheckpoint(files);
    ui::gap();
    ui::file("Scene file", &scenes->saved, "scene.json", "The scene as edited, as Glint JSON");
    const float half = ui::buttonWidth(2);
    if (ui::button("Save scene", half, "With every edit that was made here")) {
        scenes->save(document->posted());
    }
    ImGui::SameLine();
    const std::string tip = keys->tip("Into another folder or under another name", KeyAction::SaveScene);
    if (ui::button("Save scene as…", half, tip.c_str())) { scenes->saveAs(document->posted()); }
    drawNotice(*notice);
}

}  // namespace

Panel checkpointPanel() { return {"Checkpoint", false, OfParts<draw>::call}; }

}  // namespace glint
