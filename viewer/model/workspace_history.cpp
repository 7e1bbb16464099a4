// What leads from one version of the scene to another: edits, restarts, and the way back to one of before.
#include <optional>
#include <utility>
#include <vector>

#include "engine/base/log.h"
#include "viewer/model/edit_name.h"
#include "viewer/model/workspace.h"

namespace glint {

bool Workspace::commitDraft(bool held, bool mayBeEdited) {
    const std::shared_ptr<const SceneDescription> before = document.posted();
    const SceneDocument::Edits edits = mayBeEdited ? document.takeEdits() : SceneDocument::Edits{};
    std::string name = document.takeEditName();
    if (edits.lacksAssets) { assets.read(); }
    const FilmTake take = history.take();
    const bool isEdited = edits.kinds != EditKind::None || edits.isUnseen;
    if (edits.isUnseen && name.empty()) { name = "Rename"; }
    const DisplayChoices& shown = history.display();
    if (!isEdited && shown == display.choices()) { return false; }
    if (name.empty()) {
        name = isEdited ? editName(*before, *document.posted()) : editName(shown, display.choices());
    }
    history.record({std::move(name), document.version(), take, display.choices()}, held ? gesture_ : 0);
    if (!isEdited) { return false; }
    if (held) { render.setInteracting(true); }
    render.post({document.posted(), edits.kinds}, take);
    faults.forget();
    return true;
}

void Workspace::goTo(size_t index) {
    const SceneDocument::Version before = document.version();
    const FilmTake take = history.take();
    const EditHistory::State state = history.goTo(index);
    ocio.giveUp();
    display.choose(state.display);
    if (state.version == before && state.take == take) { return; }
    const EditKind kinds = document.show(state.version);
    if (document.draft().path != before.scene->path) {
        convergence.forget();
        watch.watch(filesOf(document.draft()));
    }
    if (state.version.opened != before.opened) { awaitsExposure_ = display.awaitsExposure(); }
    forgetScene();
    render.post({document.posted(), kinds}, state.take);
}

void Workspace::restart() {
    const FilmTake take = history.nextTake();
    history.record({"Restart", document.version(), take, display.choices()}, 0);
    render.post({document.posted(), EditKind::None}, take);
    logInfo("Restarted by hand");
}

void Workspace::resumeFrom(std::optional<FilmFiles::ResumedScene> resumed, ResumePoint point,
                           const std::string& name) {
    if (resumed) {
        sceneFiles.reading = std::move(resumed->reading);
        adopt(std::move(resumed->scene), false);
    }
    const FilmTake take = history.nextTake();
    history.record({name, document.version(), take, display.choices()}, 0);
    render.resume(document.posted(), std::move(point), take);
}

}  // namespace glint
