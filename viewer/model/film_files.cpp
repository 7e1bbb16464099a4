#include "viewer/model/film_files.h"

#include <chrono>
#include <future>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "engine/render/checkpoint.h"
#include "engine/render/image_file.h"
#include "engine/render/snapshot.h"
#include "viewer/base/checkpoint_file.h"

namespace glint {
namespace {

std::shared_ptr<FilmSnapshot> snapshotOf(const SessionCapture& capture, bool errorMaps) {
    auto snapshot = makeSnapshot(capture, {.standardError = true, .errorMaps = errorMaps}, 0);
    if (capture.aovs.passes() > 0) { snapshot->aovs = std::make_shared<const AovFilm>(capture.aovs); }
    return snapshot;
}

ImageOptions optionsOf(const DisplaySettings& display) {
    return {.exposureStops = display.exposureStops, .toneMap = display.toneMap};
}

double secondsNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

void FilmFiles::saveCaptured(const std::string& path, std::function<Status(const SessionCapture&)> save) {
    if (const Status free = inputs_->checkIsNoInput(path); !free) { return notice_->tell(free, ""); }
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
    saveCaptured(png, [path = png, options = optionsOf(display)](const SessionCapture& capture) {
        return saveImage(path, *snapshotOf(capture, false), *capture.scene, options);
    });
}

Status FilmFiles::saveNow(const std::string& path, const DisplaySettings& display) {
    const auto capture = render_->capture();
    if (!capture) { return Error{"there is no picture to save", {.file = path}}; }
    return saveImage(path, *snapshotOf(*capture, false), *capture->scene, optionsOf(display));
}

void FilmFiles::saveExr() {
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
    saveCaptured(exr, [path = exr, options, layers = exrLayers](const SessionCapture& capture) {
        return saveImage(path, *snapshotOf(capture, layers), *capture.scene, options);
    });
}

void FilmFiles::saveCheckpointFile() {
    lastAutosave_ = secondsNow();
    saveCaptured(checkpoint, [path = checkpoint](const SessionCapture& capture) {
        const Status replaces = checkReplacesCheckpoint(path, capture.film.passes());
        return replaces ? saveCheckpoint(path, capture) : replaces;
    });
}

void FilmFiles::resumeCheckpoint() {
    if (!document_->isOpen()) { return; }
    notice_->show(fmt::format("Reading {}…", checkpoint));
    jobs_->start(
        [this, path = checkpoint, scene = document_->posted()]() -> JobQueue::Completion {
            auto loaded = std::make_shared<Result<ResumePoint>>(loadCheckpoint(path, *scene));
            return [this, path, scene, loaded] {
                if (!*loaded) {
                    notice_->tell(loaded->error(), "");
                } else if (scene != document_->posted()) {
                    notice_->tell(
                        Error{"the scene was edited meanwhile; nothing was resumed", {path, 0, 0, ""}}, "");
                } else {
                    const uint32_t passes = loaded->value().film.passes();
                    render_->resume(scene, std::move(loaded->value()));
                    notice_->tell({}, fmt::format("Resumed {} at {} passes", path, passes));
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
    if (!checkReplacesCheckpoint(checkpoint, status.passes)) { checkpoint = freeNameBeside(checkpoint); }
    saveCheckpointFile();
}

}  // namespace glint
