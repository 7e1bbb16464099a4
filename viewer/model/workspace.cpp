#include "viewer/model/workspace.h"

#include <optional>
#include <tuple>
#include <utility>

#include "engine/base/log.h"
#include "engine/io/file_kind.h"
#include "engine/io/image_formats.h"
#include "engine/io/importer.h"
#include "engine/render/auto_exposure.h"
#include "viewer/model/workspace_part.h"

namespace glint {
namespace {

/// Whatever looks like a scene is one, also where its name says otherwise.
bool isImage(const std::string& path) {
    const std::string head = readHead(path);
    const Importer* importer = importerOf(path, head);
    const bool isScene = importer != nullptr && importer->looksLike(head);
    return !isScene && imageFormatOf(path, head) != nullptr;
}

}  // namespace

Workspace::Workspace(std::unique_ptr<Backend> backend)
    : render(std::move(backend)),
      sceneFiles(&jobs, &notice, &inputs, [this](SceneDescription scene) { adopt(std::move(scene)); }),
      filmFiles(&jobs, &document, &render, &notice, &inputs),
      assets(&jobs, &document, &notice),
      convergence(&document, &render, &notice),
      curveExport(&jobs, &notice, &inputs),
      faults(&jobs, &render) {}

void Workspace::adopt(SceneDescription scene) {
    for (const std::string& warning : scene.warnings) {
        logWarning("{}: {}", scene.path, warning);
    }
    for (const std::string& note : scene.notes) {
        logInfo("{}", note);
    }
    logInfo("Opened {}: {} objects, {} materials, {} lights, {}x{} pixels", scene.path, scene.objects.size(),
            scene.materials.size(), scene.lights.size(), scene.resolution.width, scene.resolution.height);
    inputs.readsScene(scene);
    if (scene.path != document.draft().path) { convergence.forget(); }
    assets.forget();
    faults.forget();
    sceneFiles.opened = scene.path;
    sceneFiles.dismissError();
    document.adopt(std::move(scene));
    if (display.exposureStops == display.chosenExposureStops) { display.exposureStops = 0.0f; }
    awaitsExposure_ = display.autoExposure && display.exposureStops == 0.0f;
    display.chosenExposureStops = 0.0f;
    sendRequest();  // first, so that not a pass too many is made
    render.post({document.posted(), EditKind::Everything});
}

void Workspace::takeDroppedFile(const std::string& path) {
    if (isImage(path)) {
        convergence.referencePath = path;
        convergence.reference.load(path, document.draft().resolution);
    } else if (document.isOpen() && hasExtension(path, ".glintfilm")) {
        filmFiles.checkpoint = path;
        filmFiles.resumeCheckpoint();
    } else {
        sceneFiles.opened = path;
        sceneFiles.open(path);
    }
}

void Workspace::refresh() {
    jobs.runCompletions();
    if (assets.takeArrival()) { commitEdits(false); }
    const IntegratorKind own = document.draft().options.integrator;
    render.refresh(display.split ? std::optional(display.otherOf(own)) : std::nullopt);
    chooseExposure();
    convergence.refresh();
    if (const auto& reference = convergence.reference.loaded()) {
        inputs.reads("the reference picture", reference->path);
    }
    filmFiles.refresh(busy());
}

EditKind Workspace::commitEdits(bool held) {
    if (!document.isOpen()) { return EditKind::None; }
    const SceneDocument::Edits edits = document.takeEdits();
    if (edits.lacksAssets) { assets.read(); }
    if (edits.kinds != EditKind::None) {
        if (held) { render.setInteracting(true); }
        render.post({document.posted(), edits.kinds});
        faults.forget();
    }
    sendRequest();
    return edits.kinds;
}

/// Not once the user has moved it.
void Workspace::chooseExposure() {
    const auto& picture = render.snapshot();
    if (!awaitsExposure_ || !picture || render.awaitsImage()) { return; }
    awaitsExposure_ = false;
    if (display.exposureStops != 0.0f) { return; }
    const float stops = autoExposure(picture->radiance, picture->width, picture->height);
    display.exposureStops = display.chosenExposureStops = stops;
    if (stops != 0.0f) {
        logInfo("Exposure {:+.2f} stops: without, the picture is {}", stops,
                stops < 0.0f ? "white" : "black");
    }
}

void Workspace::sendRequest() {
    RenderRequest& request = render.request;
    request.aovs = filmFiles.needsLayers() ? kAllAovs : 0;
    request.standardError = request.errorMaps = request.integratorMaps = false;
    if (const auto ask = infoOf(display.shown).ask) { ask(&request); }
    request.compare.clear();
    if (display.split) {
        const auto [left, right] = comparedPair();
        request.compare = {left, right};
    }
    render.send();
}

bool Workspace::busy() const {
    return jobs.running() > 0 || filmFiles.isExrPending() || convergence.reference.loading() ||
           convergence.reference.measuring();
}

bool Workspace::carriesShownImage() const {
    const auto& own = render.snapshot();
    const auto& other = render.otherSnapshot();
    if (!own || !carries(*own, display.shown)) { return false; }
    return !display.split || (other && other->previewScale == 1 && carries(*other, display.shown));
}

template <class Part>
Part* partOf(Workspace* w) {
    return &std::get<Part&>(std::tie(w->notice, w->document, w->render, w->display, w->sceneFiles,
                                     w->filmFiles, w->assets, w->convergence, w->curveExport, w->faults));
}

template Notice* partOf(Workspace*);
template SceneDocument* partOf(Workspace*);
template RenderControl* partOf(Workspace*);
template DisplaySettings* partOf(Workspace*);
template SceneFiles* partOf(Workspace*);
template FilmFiles* partOf(Workspace*);
template AssetReader* partOf(Workspace*);
template ConvergenceWatch* partOf(Workspace*);
template CurveExport* partOf(Workspace*);
template FaultFinder* partOf(Workspace*);

}  // namespace glint
