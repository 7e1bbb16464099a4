#include "viewer/model/film_files.h"

#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "engine/render/checkpoint.h"
#include "engine/render/checkpoint_scene.h"
#include "engine/render/denoised_snapshot.h"
#include "engine/render/image_file.h"
#include "engine/render/snapshot.h"
#include "viewer/base/checkpoint_file.h"
#include "viewer/model/session_backup.h"

namespace glint {
namespace {

/// As it is shown, which is with its noise where the layers to take it out were not rendered.
std::shared_ptr<FilmSnapshot> snapshotOf(const SessionCapture& capture, bool denoises,
                                         bool errorMaps = false) {
    auto snapshot = makeSnapshot(capture, {.standardError = true, .errorMaps = errorMaps}, 0);
    if (capture.aovs.passes() > 0) { snapshot->aovs = std::make_shared<const AovFilm>(capture.aovs); }
    auto denoised = denoises ? denoisedSnapshot(*snapshot, DenoiseQuality::Careful, 0) : nullptr;
    return denoised ? denoised : snapshot;
}

double secondsNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct LoadedCheckpoint {
    Result<ResumePoint> point;
    std::optional<FilmFiles::ResumedScene> resumed{};  ///< that it is of; nothing: the one that is open
};

/// `open` may be null.
LoadedCheckpoint loadWithScene(const std::string& path, const SceneDescription* open) {
    if (open != nullptr) {
        Result<ResumePoint> point = loadCheckpoint(path, *open);
        if (point || !readCheckpointInfo(path) || readCheckpointInfo(path)->scenePath.empty()) {
            return {std::move(point)};
        }
    }
    Result<SceneDescription> scene = loadCheckpointScene(path);
    if (!scene) { return {scene.error()}; }
    Result<ResumePoint> point = loadCheckpoint(path, *scene);
    restoreBeside(path, &*scene);
    SceneReading reading{.path = scene->path,
                         .options = loadOptionsOf(scene->readWith),
                         .choices = readSceneChoices(scene->path)};
    return {std::move(point), FilmFiles::ResumedScene{std::move(*scene), std::move(reading)}};
}

/// What a checkpoint is of, as the overwrite guard has it.
std::string sceneName(const SceneDescription* scene) {
    return scene == nullptr ? "" : absolutePath(scene->path);
}

Status saveOverShorter(const std::string& path, const SessionCapture& capture) {
    const Status replaces =
        checkReplacesCheckpoint(path, capture.film.passes(), nullptr);  // the guard has asked
    return replaces ? saveCheckpoint(path, capture) : replaces;
}

}  // namespace

Status saveShownImage(const std::string& path, const SessionCapture& capture,
                      const DisplaySettings& display) {
    return saveImage(path, *snapshotOf(capture, display.denoises), *capture.scene, {.look = display.look()});
}

void FilmFiles::saveCaptured(const std::string& path, Save save, const std::string& of) {
    if (const Status free = inputs_->checkIsNoInput(path); !free) { return notice_->tell(free, ""); }
    guard_->save(
        path, [this, path, save = std::move(save)] { startSave(path, save); }, of);
}

void FilmFiles::startSave(const std::string& path, Save save) {
    auto future = std::make_shared<std::future<std::optional<SessionCapture>>>(render_->captureLater());
    notice_->show(fmt::format("Saving {}…", path));
    jobs_->start(
        [this, path, future, save = std::move(save)]() -> JobQueue::Completion {
            const std::optional<SessionCapture> capture = future->get();
            const Status result =
                capture ? save(*capture)
                        : Status(Error{"there is no picture to save yet", SourcePlace{path, 0, 0, ""}});
            const uint32_t passes = capture ? capture->film.passes() : 0;
            return [this, path, result, passes] {
                notice_->tell(result, fmt::format("Saved {} ({} passes)", Notice::placeOf(path), passes));
            };
        },
        true);
}

void FilmFiles::savePng(const DisplaySettings& display) {
    saveCaptured(png, [path = png, display](const SessionCapture& capture) {
        return saveShownImage(path, capture, display);
    });
}

Status FilmFiles::saveNow(const std::string& path, const DisplaySettings& display) {
    const auto capture = render_->capture();
    if (!capture) { return Error{"there is no picture to save", {.file = path}}; }
    return saveShownImage(path, *capture, display);
}

void FilmFiles::saveExr(const DisplaySettings& display) {
    exrDenoises_ = display.denoises;
    if (exrLayers && render_->status().aovPasses == 0) {
        isExrPending_ = true;  // refresh() goes on when the session has made them
        notice_->show("Waiting for the layers…");
        return;
    }
    startExr();
}

void FilmFiles::startExr() {
    isExrPending_ = false;
    ImageOptions options;
    options.exrColor = exrFloat ? ExrPixelType::Float : ExrPixelType::Half;
    if (exrLayers) { options.aovs = kAllAovs; }
    saveCaptured(exr, [path = exr, options, denoises = exrDenoises_,
                       layers = exrLayers](const SessionCapture& capture) {
        return saveImage(path, *snapshotOf(capture, denoises, layers), *capture.scene, options);
    });
}

void FilmFiles::saveCheckpointFile() {
    saveCaptured(
        checkpoint,
        [path = checkpoint](const SessionCapture& capture) { return saveOverShorter(path, capture); },
        sceneName(document_->posted().get()));
}

void FilmFiles::autosave() {
    if (!checkReplacesCheckpoint(checkpoint, render_->status().passes, document_->posted().get())) {
        checkpoint = freeNameBeside(checkpoint);
    }
    guard_->mayReplace(checkpoint, sceneName(document_->posted().get()));
    saveCheckpointFile();
}

void FilmFiles::resume(const std::string& file) {
    notice_->show(fmt::format("Reading {}…", file));
    jobs_->start(
        [this, path = file, scene = document_->posted()]() -> JobQueue::Completion {
            auto loaded = std::make_shared<LoadedCheckpoint>(loadWithScene(path, scene.get()));
            return [this, path, scene, loaded] {
                if (!loaded->point) {
                    notice_->tell(loaded->point.error(), "");
                } else if (scene != document_->posted()) {
                    notice_->tell(
                        Error{"the scene was edited meanwhile; nothing was resumed", {path, 0, 0, ""}}, "");
                } else {
                    const uint32_t passes = loaded->point->film.passes();
                    const char* how = loaded->resumed ? ", with the scene it is of" : "";
                    guard_->mayReplace(path,
                                       sceneName(loaded->resumed ? &loaded->resumed->scene : scene.get()));
                    resume_(std::move(loaded->resumed), std::move(*loaded->point),
                            fmt::format("Resume {}", std::filesystem::path(path).filename().string()));
                    notice_->tell({}, fmt::format("Resumed {} at {} passes{}", path, passes, how));
                }
            };
        },
        false);
}

void FilmFiles::refresh(bool busy) {
    const SessionStatus& status = render_->status();
    if (isExrPending_ && status.aovPasses > 0) { startExr(); }
    const bool isDue = isAutomatic && status.state == SessionState::Rendering && status.passes > 0 && !busy;
    if (!isDue) { return; }
    if (lastAutosave_ == 0.0) { lastAutosave_ = secondsNow(); }
    if (secondsNow() - lastAutosave_ < static_cast<double>(automaticSeconds)) { return; }
    lastAutosave_ = secondsNow();
    autosave();
}

}  // namespace glint
