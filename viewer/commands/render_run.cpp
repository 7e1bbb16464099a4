// The command's loop sleeps most of the time: the session renders on its own threads.
#include "viewer/commands/render_run.h"

#include <chrono>
#include <cmath>
#include <exception>

#include <fmt/format.h>

#include "engine/base/console.h"
#include "engine/base/log.h"
#include "engine/base/parallel.h"
#include "engine/render/auto_exposure.h"
#include "engine/render/checkpoint.h"
#include "engine/render/denoised_snapshot.h"
#include "engine/render/image_file.h"
#include "engine/render/snapshot.h"
#include "engine/render/sppm_state.h"
#include "viewer/base/checkpoint_file.h"
#include "viewer/base/interrupt.h"
#include "viewer/base/make_backend.h"
#include "viewer/base/memory_reserve.h"
#include "viewer/base/numbered_files.h"
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
          checkpoint_(options.checkpoint, options.overwrite),
          saves_(parseSaveInterval(options.checkpointEvery).value()),
          loadSeconds_(loadSeconds),
          limits_(finalLimits(options)),
          reserve_(bytesToSave(*scene_, options.denoise || !options.aovs.empty())) {
        const uint32_t asked = scene_->sppm.photonsPerPass;
        photonsPerPass_ = isSppm() ? planSppmMemory(*scene_).photonsPerPass : 0;
        if (isSppm() && photonsPerPass_ < asked) {
            const uint32_t budget = scene_->sppm.memoryBudgetMiB;
            logWarning("{} photons a pass instead of {}: more would not fit into {}", photonsPerPass_, asked,
                       budget > 0 ? fmt::format("{} MiB (--memory)", budget) : "a photon map at all");
        }
        if (const int depth = scene_->options.maxDepth; isSppm() && depth > kMostPhotonScatterings) {
            logWarning("{} scattering events along a path instead of {}: photons count no more",
                       kMostPhotonScatterings, depth);
        }
    }

    std::optional<float> exposure() const { return exposure_; }

    int run() {
        if (const int code = start(); code != kExitDone) { return code; }
        const End end = waitWithMemory();
        reserve_.release();
        int code = kExitFailed;
        const Status finished = withMemory(options_.output, [&] {
            code = finish(end);
            return Status();
        });
        return finished ? code : reportError(finished.error(), kExitFailed);
    }

  private:
    enum class End { Done, Interrupted, OutOfMemory };

    bool isSppm() const { return scene_->options.integrator == IntegratorKind::Sppm; }

    int start() {
        auto backend = makeBackend(options_.backend, options_.threads);
        if (!backend) { return reportError(backend.error(), kExitBadInput); }
        const Result<AovChoice> aovs = chooseAovs(options_.aovs);
        if (!aovs) { return reportError(aovs.error(), kExitBadInput); }
        aovs_ = *aovs;
        if (!reserve_.isHeld()) {
            return reportError(Error{fmt::format("not enough memory to save a picture of {}x{} pixels",
                                                 scene_->resolution.width, scene_->resolution.height),
                                     {}},
                               kExitFailed);
        }
        // The threads that saving takes are made now, too.
        parallelChunks(2, 1, options_.threads, [](int64_t, int64_t) {});
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
                    .aovs = aovs_.aovs | (options_.denoise ? kDenoisingAovs : 0),
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

    /// Saves and reports what there is. Returns the exit code.
    int finish(End end) {
        if (end == End::Interrupted && !stopsWithImage()) { return kExitInterrupted; }
        const SessionStatus status = session_->status();
        if (status.state == SessionState::Failed && status.passes == 0) {
            // The session has logged why.
            return status.counters.editsRefused > 0 ? kExitBadInput : kExitFailed;
        }
        const auto capture = session_->capture();
        if (!capture) { return reportError(Error{"nothing was rendered", {}}, kExitFailed); }
        const Status saved = save(*capture);
        if (!saved) { logError("{}", saved.error().format()); }
        const Status reported = reportRender({options_, *capture, session_->status(), loadSeconds_,
                                              photonsPerPass_, exposure_.value_or(0.0f), denoiseSeconds_});
        const bool hasAll = saved && !lacksImage_ && end != End::OutOfMemory;
        if (!hasAll || status.state == SessionState::Failed) { return kExitFailed; }
        if (!reported) { return reportError(reported.error(), kExitFailed); }
        return end == End::Done ? kExitDone : kExitInterrupted;
    }

    End waitWithMemory() {
        try {
            return waitUntilDone() ? End::Done : End::Interrupted;
        } catch (const std::exception&) {
            logError("not enough memory to go on; what is rendered is saved");
            request_.paused = true;
            session_->request(request_);
            return End::OutOfMemory;
        }
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
                saveOnTheWay();
                savedAt = Clock::now();
            }
        }
        progress.finish();
        return finished;
    }

    /// After a signal: gives up the pass in flight where there is a picture without it. False: there is none,
    /// and none will be soon.
    bool stopsWithImage() {
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
        saveOnTheWay(numberedPath(options_.output, passes));
        request_.limits = limitsUntilNextImage(passes);
        session_->request(request_);
        return true;
    }

    /// The checkpoint, and a picture where it has a name. The render is worth more than these; a checkpoint
    /// that cannot be saved now may be at the end.
    void saveOnTheWay(const std::string& image = {}) {
        bool hasImage = image.empty();
        const Status saved = withMemory(image.empty() ? options_.checkpoint : image, [&] {
            const auto capture = session_->capture();
            if (!capture) { return Status(); }
            const Status written = hasImage ? Status() : writeImage(*capture, image);
            hasImage = static_cast<bool>(written);
            const Status kept = checkpoint_.save(*capture);
            return written ? kept : written;
        });
        if (!hasImage) { lacksImage_ = true; }
        if (!saved) { logError("{}", saved.error().format()); }
    }

    /// `save()`, and once more where memory ran short: what the first try took is free then.
    template <class Save>
    static Status withMemory(const std::string& path, const Save& save) {
        for (int tries = 2; tries > 0; --tries) {
            try {
                return save();
            } catch (const std::exception&) {
                // Without memory, also what was asked of the session may be lost on the way.
            }
        }
        return Error{"not enough memory to save it", {.file = path}};
    }

    /// The same for all pictures of the run.
    float exposureOf(const FilmSnapshot& image) {
        if (!exposure_) { exposure_ = autoExposure(image.radiance, image.width, image.height); }
        return *exposure_;
    }

    Status writeImage(const SessionCapture& capture, const std::string& path) {
        const SnapshotRequest request{.standardError = aovs_.standardError || options_.denoise,
                                      .errorMaps = aovs_.errorMaps};
        auto snapshot = makeSnapshot(capture, request, options_.threads);
        snapshot->aovs = std::make_shared<AovFilm>(capture.aovs);
        if (options_.denoise) { denoise(&snapshot); }
        ImageOptions image;
        image.look = {exposureOf(*snapshot), toneMapOf(options_), options_.white, options_.dither,
                      options_.view};
        image.exrColor = options_.exrFloat ? ExrPixelType::Float : ExrPixelType::Half;
        // A failure may come before the layers are rendered; the picture is worth saving without them.
        image.aovs = capture.aovs.passes() > 0 ? aovs_.aovs : 0;
        image.threads = options_.threads;
        return saveImage(path, *snapshot, *capture.scene, image);
    }

    /// A failure may come before the layers are rendered; the picture is worth saving with its noise.
    void denoise(std::shared_ptr<FilmSnapshot>* snapshot) {
        const auto began = Clock::now();
        if (auto denoised = denoisedSnapshot(**snapshot, DenoiseQuality::Careful, options_.threads)) {
            *snapshot = std::move(denoised);
        } else {
            logWarning("{} is not denoised: its albedo, normals and depth were not rendered",
                       options_.output);
        }
        denoiseSeconds_ = std::chrono::duration<double>(Clock::now() - began).count();
        if (!aovs_.standardError) { (*snapshot)->standardError.clear(); }
    }

    Status save(const SessionCapture& capture) {
        const Status saved =
            withMemory(options_.output, [&] { return writeImage(capture, options_.output); });
        // A full disk must not cost the checkpoint too.
        const Status kept = withMemory(options_.checkpoint, [&] { return checkpoint_.save(capture); });
        return saved ? kept : saved;
    }

    std::shared_ptr<const SceneDescription> scene_;
    const RenderCommandOptions& options_;
    CheckpointFile checkpoint_;
    SaveInterval saves_;
    double loadSeconds_;
    StopLimits limits_;
    AovChoice aovs_;
    uint32_t photonsPerPass_ = 0;  ///< SPPM: what the budget allows
    uint32_t startPasses_ = 0;     ///< that the checkpoint brought
    uint32_t nextImage_ = 0;       ///< pass count of the next numbered picture; 0: none before the end
    bool lacksImage_ = false;      ///< a numbered one could not be written
    std::optional<float> exposure_ = statedExposure(options_);  ///< of PNGs
    std::optional<double> denoiseSeconds_;                      ///< that the last picture took
    RenderRequest request_;
    InterruptGuard interrupt_;
    MemoryReserve reserve_;
    std::unique_ptr<RenderSession> session_;
};

}  // namespace

RenderOutcome runRender(std::shared_ptr<const SceneDescription> scene, const RenderCommandOptions& options,
                        double loadSeconds) {
    BatchRender render(std::move(scene), options, loadSeconds);
    const int exitCode = render.run();
    return {exitCode, render.exposure()};
}

}  // namespace glint
