// The model's saves and loads. Each takes the film exactly, in the background, and reports to the panel and
// the log.
#include <chrono>
#include <future>
#include <utility>

#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/io/atomic_file.h"
#include "engine/io/file_kind.h"
#include "engine/io/image_formats.h"
#include "engine/io/importer.h"
#include "engine/io/scene_json.h"
#include "engine/render/checkpoint.h"
#include "engine/render/image_file.h"
#include "engine/render/snapshot.h"
#include "viewer/window/convergence_csv.h"
#include "viewer/window/viewer_model.h"

namespace glint {
namespace {

std::shared_ptr<FilmSnapshot> imageOf(const RenderSession::Capture& capture, bool errorMaps) {
    auto image = makeSnapshot(capture, {.standardError = true, .errorMaps = errorMaps}, 0);
    if (capture.aovs.passes() > 0) { image->aovs = std::make_shared<const AovFilm>(capture.aovs); }
    return image;
}

std::string replayLine(const std::string& scene, const FaultRecord& fault) {
    return fmt::format("glint render \"{}\" --pixel {},{} --pass {}", scene, fault.x, fault.y, fault.pass);
}

/// Whatever looks like a scene is one, also where its name says otherwise.
bool isImage(const std::string& path) {
    const std::string head = readHead(path);
    const Importer* importer = importerOf(path, head);
    const bool isScene = importer != nullptr && importer->looksLike(head);
    return !isScene && imageFormatOf(path, head) != nullptr;
}

double secondsNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

void ViewerModel::finishFileJob(const Status& result, const std::string& success) {
    fileMessageIsError_ = !result.ok();
    fileMessage_ = result.ok() ? success : result.error().format();
    if (result.ok()) {
        logInfo("{}", success);
    } else {
        logError("{}", fileMessage_);
    }
}

/// The log has it already.
void ViewerModel::tellOfReference() {
    fileMessageIsError_ = reference.loadError().has_value();
    if (fileMessageIsError_) {
        fileMessage_ = reference.loadError()->format();
    } else if (reference.image()) {
        fileMessage_ = fmt::format("Reference {}", reference.image()->path);
    }
}

void ViewerModel::saveCaptured(const std::string& path, std::function<Status(const Capture&)> save) {
    auto future = std::make_shared<std::future<std::optional<Capture>>>(session_.captureLater());
    fileMessage_ = fmt::format("Saving {}…", path);
    fileMessageIsError_ = false;
    jobs_.start(
        [this, path, future, save = std::move(save)]() -> JobQueue::Completion {
            const std::optional<Capture> capture = future->get();
            const Status result =
                capture ? save(*capture)
                        : Status(Error{"there is no picture to save yet", SourcePlace{path, 0, 0, ""}});
            const uint32_t passes = capture ? capture->film.passes() : 0;
            return [this, path, result, passes] {
                finishFileJob(result, fmt::format("Saved {} ({} passes)", path, passes));
            };
        },
        true);
}

void ViewerModel::savePng() {
    const ImageOptions options{.exposureStops = display.exposureStops, .toneMap = display.toneMap};
    const std::string path = files.png;
    saveCaptured(path, [path, options](const Capture& capture) {
        return saveImage(path, *imageOf(capture, false), *capture.scene, options);
    });
}

void ViewerModel::saveExr() {
    if (files.exrLayers && status_.aovPasses == 0) {
        pendingExr_ = true;  // refresh() goes on when the session has made them
        fileMessage_ = "Waiting for the layers…";
        fileMessageIsError_ = false;
        return;
    }
    startExr();
}

void ViewerModel::startExr() {
    pendingExr_ = false;
    ImageOptions options;
    options.exrColor = files.exrFloat ? ExrPixelType::Float : ExrPixelType::Half;
    if (files.exrLayers) {
        options.aovs =
            kAovAlbedo | kAovShadingNormal | kAovGeometricNormal | kAovDepth | kAovObjectId | kAovMaterialId;
    }
    const std::string path = files.exr;
    saveCaptured(path, [path, options, layers = files.exrLayers](const Capture& capture) {
        return saveImage(path, *imageOf(capture, layers), *capture.scene, options);
    });
}

void ViewerModel::saveCheckpointFile() {
    const std::string path = files.checkpoint;
    lastAutosave_ = secondsNow();
    saveCaptured(path, [path](const Capture& capture) { return saveCheckpoint(path, capture); });
}

void ViewerModel::resumeCheckpoint() {
    if (!posted_) { return; }
    const std::string path = files.checkpoint;
    fileMessage_ = fmt::format("Reading {}…", path);
    fileMessageIsError_ = false;
    jobs_.start(
        [this, path, scene = posted_]() -> JobQueue::Completion {
            auto loaded = std::make_shared<Result<ResumePoint>>(loadCheckpoint(path, *scene));
            return [this, path, scene, loaded] {
                if (!*loaded) {
                    finishFileJob(loaded->error(), "");
                } else if (scene != posted_) {
                    finishFileJob(
                        Error{"the scene was edited meanwhile; nothing was resumed", {path, 0, 0, ""}}, "");
                } else {
                    const uint32_t passes = loaded->value().film.passes();
                    awaitedEdit_ = session_.resume(scene, std::move(loaded->value()));
                    finishFileJob({}, fmt::format("Resumed {} at {} passes", path, passes));
                }
            };
        },
        false);
}

void ViewerModel::saveSceneFile() {
    const std::string path = files.json;
    jobs_.start(
        [this, path, scene = posted_]() -> JobQueue::Completion {
            const Status result = scene ? saveSceneJson(*scene, path) : Status(Error{"no scene is open", {}});
            return [this, path, result] { finishFileJob(result, fmt::format("Saved {}", path)); };
        },
        true);
}

void ViewerModel::saveConvergenceCsv() {
    CurvesOfBoth curves;
    for (const IntegratorKind kind : {IntegratorKind::PathTracing, IntegratorKind::Sppm}) {
        curves.estimates[static_cast<size_t>(kind)] = *curve(kind);
        curves.references[static_cast<size_t>(kind)] = reference.points(kind);
    }
    const std::string path = files.csv;
    jobs_.start(
        [this, path, curves = std::move(curves)]() -> JobQueue::Completion {
            const Status result = writeFileAtomically(path, convergenceCsv(curves));
            return [this, path, result] {
                finishFileJob(result, fmt::format("Saved {}", path));
                csvMessage_ = fileMessage_;
                csvMessageIsError_ = fileMessageIsError_;
            };
        },
        true);
}

void ViewerModel::takeDroppedFile(const std::string& path) {
    if (isImage(path)) {
        files.reference = path;
        reference.load(path);
    } else if (posted_ && hasExtension(path, ".glintfilm")) {
        files.checkpoint = path;
        resumeCheckpoint();
    } else {
        files.scene = path;
        open(path);
    }
}

void ViewerModel::findFault() {
    auto future = std::make_shared<std::future<std::optional<Capture>>>(session_.captureLater());
    jobs_.start(
        [this, future]() -> JobQueue::Completion {
            const std::optional<Capture> capture = future->get();
            std::string line;
            if (capture && !capture->film.faults().empty()) {
                line = replayLine(capture->scene->path, capture->film.faults().front());
            }
            return [this, line] { replayCommand_ = line; };
        },
        false);
}

void ViewerModel::autosave() {
    if (!files.automatic || status_.state != SessionState::Rendering || status_.passes == 0 || busy()) {
        return;
    }
    if (lastAutosave_ == 0.0) { lastAutosave_ = secondsNow(); }
    if (secondsNow() - lastAutosave_ >= static_cast<double>(files.automaticSeconds)) { saveCheckpointFile(); }
}

}  // namespace glint
