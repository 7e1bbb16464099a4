#include "viewer/model/workspace.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/io/file_kind.h"
#include "engine/io/image_formats.h"
#include "engine/io/importer.h"
#include "engine/io/studio.h"
#include "engine/render/auto_exposure.h"
#include "viewer/model/camera_controller.h"
#include "viewer/model/object_edits.h"

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
    : backup(&document, &render, &notice),
      render(std::move(backend)),
      ocio(&jobs, &display, &notice),
      sceneFiles(
          &jobs, &notice, &inputs, &overwrite, [this](SceneDescription scene) { adopt(std::move(scene)); },
          [this](SceneDescription scene) { addObjectsOf(std::move(scene)); },
          [this](const auto& scene) { document.noteSaved(scene); }),
      filmFiles(&jobs, &document, &render, &notice, &inputs, &overwrite,
                [this](std::optional<FilmFiles::ResumedScene> resumed, ResumePoint point,
                       const std::string& name) { resumeFrom(std::move(resumed), std::move(point), name); }),
      assets(&jobs, &document, &notice),
      convergence(&document, &render, &notice),
      curveExport(&jobs, &notice, &inputs, &overwrite),
      frames(&jobs, &document, &render, &bookmarks, &notice, &inputs, &overwrite),
      faults(&jobs, &render) {}

void Workspace::rememberIn(const std::string& folder, double backupSeconds) {
    backup.begin(folder + "/sessions", backupSeconds);
    sceneFiles.recent.begin(folder + "/recent");
    layout.begin(folder + "/layout");
    bookmarks.begin(folder + "/views");
}

void Workspace::adopt(SceneDescription scene, bool isSaved) {
    const bool isReload = sceneFiles.reloading() && scene.path == document.draft().path;
    const Camera camera = document.draft().camera;
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
    sceneFiles.dismissError();
    document.adopt(std::move(scene), isSaved);
    if (isReload) { document.keepCamera(camera); }
    watch.watch(filesOf(document.draft()));
    forgetScene();
    if (!isReload) { expectExposure(); }
    const FilmTake take = history.nextTake();
    const std::string file = std::filesystem::path(document.draft().path).filename().string();
    history.record({fmt::format("{} {}", isReload ? "Reload" : "Open", file), document.version(), take,
                    display.choices()},
                   0);
    if (!inputs.checkIsNoInput(sceneFiles.saved)) {
        sceneFiles.saved = std::filesystem::path(document.draft().path).stem().string() + "-edited.json";
    }
    sceneFiles.recent.add(document.draft().path);
    sendRequest();  // first, so that not a pass too many is made
    render.post({document.posted(), EditKind::Everything}, take);
}

void Workspace::addObjectsOf(SceneDescription scene) {
    if (hasStudio(scene)) { removeStudio(&scene); }
    inputs.readsScene(scene);
    const Camera& camera = document.draft().camera;
    constexpr float kSizeShare = 0.3f;  // of the target's distance
    const size_t count =
        addScene(scene, camera.target, kSizeShare * targetDistance(camera), &document.draft());
    const std::string file = std::filesystem::path(scene.path).filename().string();
    document.selectedObject = count > 0 ? static_cast<int>(document.draft().objects.size()) - 1 : -1;
    document.nameEdit("Add " + file);
    notice.show(
        fmt::format("Added {} of {}", count == 1 ? "1 object" : fmt::format("{} objects", count), file));
}

void Workspace::forgetScene() {
    assets.forget();
    faults.forget();
    sceneFiles.opened = document.draft().path;
}

/// Of another scene that is shown now.
void Workspace::expectExposure() {
    if (display.exposureStops == display.chosenExposureStops) { display.exposureStops = 0.0f; }
    awaitsExposure_ = display.autoExposure && display.exposureStops == 0.0f;
    display.chosenExposureStops = 0.0f;
}

void Workspace::takeDroppedFile(const std::string& path) {
    if (isImage(path)) {
        convergence.referencePath = path;
        convergence.reference.load(path, document.draft().resolution);
    } else if (hasExtension(path, ".glintfilm")) {
        filmFiles.checkpoint = path;
        filmFiles.resume(path);
    } else {
        sceneFiles.opened = path;
        sceneFiles.open(path);
    }
}

FirstHit Workspace::hitAt(Vec2i pixel) const {
    const std::shared_ptr<const BuiltScene> scene = render.builtScene();
    const auto [width, height] = document.draft().resolution;
    return scene ? firstHit(*scene, width, height, pixel.x, pixel.y) : FirstHit{};
}

void Workspace::selectAt(Vec2i pixel) {
    const FirstHit hit = hitAt(pixel);
    document.selectedObject = static_cast<int>(hit.object) - 1;
    if (hit.material > 0) { document.selectedMaterial = static_cast<int>(hit.material) - 1; }
}

void Workspace::giveMaterialAt(Vec2i pixel, const MaterialDrag& given) {
    const FirstHit hit = hitAt(pixel);
    if (hit.object == 0) { return notice.show("There is no object to give the material to"); }
    giveMaterial(&document, static_cast<int>(hit.object) - 1, given);
}

void Workspace::focusAt(Vec2i pixel) {
    lens.picksFocus = false;
    const SceneDescription& draft = document.draft();
    const FirstHit hit = hitAt(pixel);
    if (hit.depth <= 0.0f) { return notice.show("There is nothing to focus on"); }
    const size_t index = hit.object - 1;
    const bool isNamed = index < draft.objects.size() && !draft.objects[index].name.empty();
    document.focusAt(hit.depth, isNamed ? draft.objects[index].name : fmt::format("object {}", hit.object));
}

void Workspace::reload() {
    const std::string& path = document.draft().path;
    logInfo("{} has changed on the disk", path);
    if (document.hasUnsavedEdits()) {
        notice.show(
            fmt::format("{} has changed on the disk; your edits stay until it is opened again", path));
        return;
    }
    sceneFiles.reload(path);
}

void Workspace::refresh() {
    jobsEnded_ = jobs.runCompletions() || jobsEnded_;
    if (assets.takeArrival()) { commitEdits(false); }
    if (!document.isOpen()) { examples.list(&jobs); }
    const double now =
        std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    if (document.isOpen() && !sceneFiles.opening() && watch.hasChanged(now)) { reload(); }
    const IntegratorKind own = document.draft().options.integrator;
    render.refresh(display.split ? std::optional(display.otherOf(own)) : std::nullopt);
    chooseExposure();
    convergence.refresh();
    if (const auto& reference = convergence.reference.loaded()) {
        inputs.reads("the reference picture", reference->path);
    }
    const bool rests = render.status().state != SessionState::Rendering && !render.awaitsImage();
    denoised.refresh(wantsDenoised() ? render.snapshot() : nullptr, rests);
    filmFiles.refresh(busy());
    backup.refresh();
    if (snapshots.takeKeep() && !snapshots.keep(liveImage(), document.posted(), display)) {
        notice.show("There is no picture at full resolution yet");
    }
    refreshDifference();
    inspector.image = ownImage();
    focusOverlay.refresh({.kind = lens.overlay,
                          .sharpPixels = lens.sharpPixels,
                          .camera = document.draft().camera,
                          .resolution = document.draft().resolution,
                          .isMoving = render.request.interacting},
                         render.builtScene());
}

bool Workspace::commitEdits(bool held, bool mayBeEdited) {
    if (!document.isOpen()) { return false; }
    if (!held) { ++gesture_; }
    if (const KeptRender* kept = snapshots.takeAsked()) { openSceneOf(*kept); }
    bool isPosted = commitDraft(held, std::exchange(jobsEnded_, false) || mayBeEdited);
    if (const auto asked = history.takeAsked()) {
        goTo(*asked);
        isPosted = true;
    }
    if (render.takeRestart()) {
        restart();
        isPosted = true;
    }
    sendRequest();
    return isPosted;
}

/// Not once the user has moved it.
void Workspace::chooseExposure() {
    const auto& image = render.snapshot();
    if (!awaitsExposure_ || !image || render.awaitsImage()) { return; }
    awaitsExposure_ = false;
    if (!display.awaitsExposure()) { return; }
    const float stops = autoExposure(image->radiance, image->width, image->height);
    display.exposureStops = display.chosenExposureStops = stops;
    history.noteExposure(document.version().opened.get(), stops);
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
    if (display.denoises) {
        request.aovs |= kDenoisingAovs;
        request.standardError = true;
    }
    if (std::exchange(inspector.isOpen, false)) { request.standardError = request.integratorMaps = true; }
    request.region = region.wanted();
    render.isHeld = frames.isRunning();
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

}  // namespace glint
