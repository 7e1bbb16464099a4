// The command's loop sleeps most of the time: the session renders on its own threads.
#include "viewer/commands/render_run.h"

#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "engine/base/console.h"
#include "engine/base/log.h"
#include "engine/builders/scene_builder.h"
#include "engine/render/checkpoint.h"
#include "engine/render/image_file.h"
#include "engine/render/pass_params.h"
#include "engine/render/path_replay.h"
#include "engine/render/snapshot.h"
#include "engine/render/sppm_state.h"
#include "viewer/base/interrupt.h"
#include "viewer/base/make_backend.h"
#include "viewer/base/progress.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/render_report.h"

namespace glint {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPollSeconds = 0.1;

class BatchRender {
  public:
    BatchRender(std::shared_ptr<const SceneDescription> scene, const RenderCommandOptions& options,
                double loadSeconds)
        : scene_(std::move(scene)),
          options_(options),
          saves_(parseSaveInterval(options.checkpointEvery).value()),
          loadSeconds_(loadSeconds),
          limits_(options.limits) {
        if (limits_.passes == 0 && limits_.renderSeconds == 0.0 && limits_.relativeError == 0.0) {
            limits_.passes = kDefaultPasses;
        }
        const uint32_t asked = scene_->sppm.photonsPerPass;
        photonsPerPass_ = isSppm() ? planSppmMemory(*scene_).photonsPerPass : 0;
        if (isSppm() && photonsPerPass_ < asked) {
            logWarning("{} photons a pass instead of {}: more would not fit into {} MiB (--memory)",
                       photonsPerPass_, asked, scene_->sppm.memoryBudgetMiB);
        }
        if (const int depth = scene_->options.maxDepth; isSppm() && depth > kMostPhotonScatterings) {
            logWarning("{} scattering events along a path instead of {}: photons count no more",
                       kMostPhotonScatterings, depth);
        }
    }

    int run() {
        if (const int code = start(); code != kExitDone) { return code; }
        const bool finished = waitUntilDone();
        if (!finished && !stopsWithPicture()) { return kExitInterrupted; }
        const SessionStatus status = session_->status();
        if (status.state == SessionState::Failed && status.passes == 0) {
            return kExitBadInput;  // The session has logged why.
        }
        const auto capture = session_->capture();
        if (!capture) {
            return reportError(Error{status.error.empty() ? "nothing was rendered" : status.error, {}},
                               kExitFailed);
        }
        if (const Status saved = save(*capture); !saved) { return reportError(saved.error(), kExitFailed); }
        const Status reported =
            reportRender({options_, *capture, session_->status(), loadSeconds_, photonsPerPass_});
        if (status.state == SessionState::Failed) { return kExitFailed; }
        if (!reported) { return reportError(reported.error(), kExitFailed); }
        return finished ? kExitDone : kExitInterrupted;
    }

  private:
    bool isSppm() const { return scene_->options.integrator == IntegratorKind::Sppm; }

    int start() {
        auto backend = makeBackend(options_.backend, options_.threads);
        if (!backend) { return reportError(backend.error(), kExitBadInput); }
        const Result<AovChoice> aovs = chooseAovs(options_.aovs);
        if (!aovs) { return reportError(aovs.error(), kExitBadInput); }
        aovs_ = *aovs;
        std::optional<ResumePoint> from;
        if (!options_.resume.empty()) {
            Result<ResumePoint> loaded = loadCheckpoint(options_.resume, *scene_);
            if (!loaded) { return reportError(loaded.error(), kExitBadInput); }
            from = std::move(*loaded);
            startPasses_ = from->film.passes();
        }
        SessionOptions session;
        session.previews = false;
        session.snapshots = false;
        session.lowPriority = false;
        session.threads = options_.threads;
        session_ = std::make_unique<RenderSession>(std::move(*backend), session);
        request_ = {.limits = limitsUntilNextImage(startPasses_),
                    .aovs = aovs_.aovs,
                    .aovsEndWithFilm = true,
                    .standardError = aovs_.standardError};
        session_->request(request_);
        if (from) {
            session_->resume(scene_, std::move(*from));
        } else {
            session_->post({scene_, EditKind::Everything});
        }
        return kExitDone;
    }

    /// True when a limit was reached or the session failed, false when the user interrupted.
    bool waitUntilDone() {
        ProgressLine progress;
        auto savedAt = Clock::now();
        bool finished = false;
        while (!finished && !interrupt_.interrupted()) {
            const SessionState state = session_->wait(kPollSeconds);
            finished = state == SessionState::Finished || state == SessionState::Failed;
            if (state == SessionState::Finished && goesOnAfterImage()) { finished = false; }
            progress.update(session_->status(), limits_,
                            *session_->convergenceCurve(scene_->options.integrator));
            const double sinceSave = std::chrono::duration<double>(Clock::now() - savedAt).count();
            if (!finished && saves_.seconds > 0.0 && sinceSave >= saves_.seconds) {
                if (const auto capture = session_->capture()) { saveOnTheWay(*capture); }
                savedAt = Clock::now();
            }
        }
        progress.finish();
        return finished;
    }

    /// After a signal: gives up the pass in flight where there is a picture without it. False: there is none,
    /// and none will be soon.
    bool stopsWithPicture() {
        request_.paused = true;
        session_->request(request_);
        return announceInterruption(session_->status());
    }

    /// The limits, or fewer passes where a numbered picture comes before.
    StopLimits limitsUntilNextImage(uint32_t passes) {
        StopLimits limits = limits_;
        nextImage_ = 0;
        if (saves_.passes > 0) {
            const uint32_t next = (passes / saves_.passes + 1) * saves_.passes;
            if (limits.passes == 0 || next < limits.passes) { limits.passes = nextImage_ = next; }
        }
        return limits;
    }

    /// When the session stopped for a numbered picture: writes it and lets it go on. False: a limit that the
    /// user set was reached.
    bool goesOnAfterImage() {
        const uint32_t passes = session_->status().passes;
        if (nextImage_ == 0 || passes != nextImage_) { return false; }
        if (const auto capture = session_->capture()) {
            const std::string path = numberedPath(options_.output, passes);
            if (const Status saved = writeImage(*capture, path); !saved) {
                logError("{}", saved.error().format());
            }
            saveOnTheWay(*capture);
        }
        request_.limits = limitsUntilNextImage(passes);
        session_->request(request_);
        return true;
    }

    void saveOnTheWay(const SessionCapture& capture) {
        const Status saved =
            options_.checkpoint.empty() ? Status() : saveCheckpoint(options_.checkpoint, capture);
        if (!saved) {
            // The render is worth more than this save: the one at the end may succeed.
            logError("{}", saved.error().format());
        }
    }

    Status writeImage(const SessionCapture& capture, const std::string& path) const {
        auto snapshot = makeSnapshot(
            capture, {.standardError = aovs_.standardError, .errorMaps = aovs_.errorMaps}, options_.threads);
        snapshot->aovs = std::make_shared<AovFilm>(capture.aovs);
        ImageOptions image;
        image.exposureStops = options_.exposure;
        image.toneMap = toneMapFromName(options_.tone).value_or(ToneMap::Srgb);
        image.exrColor = options_.exrFloat ? ExrPixelType::Float : ExrPixelType::Half;
        image.aovs = aovs_.aovs;
        image.threads = options_.threads;
        return saveImage(path, *snapshot, *capture.scene, image);
    }

    Status save(const SessionCapture& capture) const {
        const Status saved = writeImage(capture, options_.output);
        // A full disk must not cost the checkpoint too.
        const Status kept =
            options_.checkpoint.empty() ? Status() : saveCheckpoint(options_.checkpoint, capture);
        return saved ? kept : saved;
    }

    std::shared_ptr<const SceneDescription> scene_;
    const RenderCommandOptions& options_;
    SaveInterval saves_;
    double loadSeconds_;
    StopLimits limits_;
    AovChoice aovs_;
    uint32_t photonsPerPass_ = 0;  ///< SPPM: what the budget allows
    uint32_t startPasses_ = 0;     ///< that the checkpoint brought
    uint32_t nextImage_ = 0;       ///< pass count of the next numbered picture; 0: none before the end
    RenderRequest request_;
    InterruptGuard interrupt_;
    std::unique_ptr<RenderSession> session_;
};

}  // namespace

std::string numberedPath(const std::string& path, uint32_t passes) {
    const size_t dot = path.rfind('.');
    return fmt::format("{}-{:06}{}", path.substr(0, dot), passes, path.substr(dot));
}

int runRender(std::shared_ptr<const SceneDescription> scene, const RenderCommandOptions& options,
              double loadSeconds) {
    return BatchRender(std::move(scene), options, loadSeconds).run();
}

int runReplay(const SceneDescription& scene, const RenderCommandOptions& options) {
    const Result<Vec2i> pixel = parsePair(options.pixel, ',', "--pixel");
    if (!pixel) { return reportError(pixel.error(), kExitBadInput); }
    if (scene.options.integrator == IntegratorKind::Sppm) {
        return reportError(Error{"--pixel follows the path tracer's paths; add --integrator path", {}},
                           kExitBadInput);
    }
    const Resolution& size = scene.resolution;
    if (pixel->x < 0 || pixel->y < 0 || pixel->x >= size.width || pixel->y >= size.height) {
        return reportError(Error{fmt::format("--pixel {} lies outside the picture of {}x{} pixels",
                                             options.pixel, size.width, size.height),
                                 {}},
                           kExitBadInput);
    }
    const auto built = buildScene({std::make_shared<SceneDescription>(scene), EditKind::Everything}, nullptr,
                                  options.threads, nullptr, nullptr);
    if (!built) { return reportError(built.error(), kExitBadInput); }
    PassParams params = passParamsOf(scene);
    params.pass = options.replayPass.value_or(0);
    PathReplay replay = replayPath((*built)->view(), (*built)->features, params, pixel->x, pixel->y);
    for (PathEvent& event : replay.events) {
        event.position += (*built)->origin();
    }
    put("{}", formatPathLog(replay, params, pixel->x, pixel->y));
    return kExitDone;
}

}  // namespace glint
