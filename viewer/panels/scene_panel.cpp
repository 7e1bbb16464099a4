// Which scene is open, opening another, and what went wrong with that.
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "engine/io/importer.h"
#include "viewer/model/key_map.h"
#include "viewer/model/scene_document.h"
#include "viewer/model/scene_files.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/error_box.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

void drawRecent(SceneFiles* files) {
    const std::vector<std::string>& paths = files->recent.paths();
    if (paths.empty()) { return; }
    std::vector<std::string_view> names{"–"};
    names.insert(names.end(), paths.begin(), paths.end());
    int chosen = 0;
    if (ui::choice("Recent", &chosen, names, "Opened last, also in earlier sessions") && chosen > 0) {
        files->opened = paths[static_cast<size_t>(chosen) - 1];
        files->open(files->opened);
    }
}

void draw(SceneFiles* files, const SceneDocument* document, const KeyMap* keys) {
    static const std::string help = "A scene to open: " + listImporters() + ". Enter opens it.";
    const bool entered = ui::text("File", &files->opened, "scene.json, .txt, .obj, .ply", help.c_str());
    const char* action = files->opening() ? "Opening…" : "Open";
    const float width = ui::buttonWidth(2);
    if ((ui::button(action, width) || entered) && !files->opening()) { files->open(files->opened); }
    ImGui::SameLine();
    const std::string tip = keys->tip("Look for a file in folders", KeyAction::OpenScene);
    if (ui::button("Browse…", width, tip.c_str())) { files->browse(); }
    drawRecent(files);
    if (files->error()) {
        ui::gap();
        if (drawErrorBox("This scene cannot be opened", *files->error())) { files->dismissError(); }
        if (document->isOpen()) { ui::hint("The scene that was open goes on."); }
    }
    if (!document->isOpen()) { return; }
    for (const std::string* text : {&document->draft().title, &document->draft().description}) {
        if (!text->empty()) { ui::hint(text->c_str()); }
    }
}

}  // namespace

Panel scenePanel() { return {"Scene", true, OfParts<draw>::call}; }

}  // namespace glint
