// Which scene is open, opening another, and what went wrong with that.
#include <string>

#include "engine/io/importer.h"
#include "viewer/model/scene_document.h"
#include "viewer/model/scene_files.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/error_box.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

void draw(SceneFiles* files, const SceneDocument* document) {
    static const std::string help = "A scene to open: " + listImporters() + ". Enter opens it.";
    const bool entered = ui::text("File", &files->opened, "scene.json, .txt, .obj, .ply", help.c_str());
    const char* action = files->opening() ? "Opening…" : "Open";
    if ((ui::button(action, ui::buttonWidth(1)) || entered) && !files->opening()) {
        files->open(files->opened);
    }
    if (files->error()) {
        ui::gap();
        if (drawErrorBox("This scene cannot be opened", *files->error())) { files->dismissError(); }
        if (document->isOpen()) { ui::hint("The scene that was open goes on."); }
    }
    if (document->isOpen() && !document->draft().title.empty()) { ui::hint(document->draft().title.c_str()); }
}

}  // namespace

Panel scenePanel() { return {"Scene", true, OfParts<draw>::call}; }

}  // namespace glint
