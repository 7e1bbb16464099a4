// The command's loop sleeps most of the time: the session renders on its own threads.
#include "viewer/commands/render_run.h"

#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/base/log.h"
#include "engine/build/scene_builder.h"
#include "engine/render/checkpoint.h"
#include "engine/render/pass_params.h"
#include "engine/render/path_replay.h"
#include "engine/render/picture_file.h"
#include "engine/render/snapshot.h"
#include "engine/render/sppm_state.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/interrupt.h"
#include "viewer/commands/json_output.h"
#include "viewer/commands/progress.h"
#include "viewer/make_backend.h"

namespace glint {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPollSeconds = 0.1;

int complain(const std::string& message, int exitCode) {
    fmt::print(stderr, "error: {}\n", message);
    return exitCode;
}

/// "out.png" after 10 passes: "out-000010.png".
std::string numberedPath(const std::string& path, uint32_t passes) {
    const size_t dot = path.rfind('.');
    return fmt::format("{}-{:06}{}", path.substr(0, dot), passes, path.substr(dot));
}

class BatchRender {
  public:
    BatchRender(std::shared_ptr<const SceneDescription> scene, const RenderCommandOptions& options,
                double loadSeconds)
        : scene_(std::move(scene)), options_(options), loadSeconds_(loadSeconds), limits_(options.limits) {
        if (limits_.passes == 0 && limits_.renderSeconds == 0.0 && limits_.relativeError == 0.0) {
            limits_.passes = kDefaultPasses;
        }
        const uint32_t asked = scene_->sppm.photonsPerPass;
        photonsPerPass_ = isSppm() ? planSppmMemory(*scene_).photonsPerPass : 0;
        if (isSppm() && photonsPerPass_ < asked) {
            logWarning("{} photons a pass instead of {}: more would not fit into {} MiB (--memory)",
                       photonsPerPass_, asked, scene_->sppm.memoryBudgetMiB);
        }
    }

    int run() {
        if (const int code = start(); code != kExitDone) {
            return code;
        }
        const bool finished = waitUntilDone();
        const SessionStatus status = session_->status();
        if (status.state == SessionState::Failed && status.passes == 0) {
            return kExitBadInput;  // The session has logged why.
        }
        const auto capture = session_->capture();
        if (!capture) {
            return complain(status.error.empty() ? "nothing was rendered" : status.error, kExitFailed);
        }
        if (const Status saved = save(*capture); !saved) {
            return complain(saved.error().format(), kExitFailed);
        }
        const Status reported = report(*capture, session_->status());
        if (status.state == SessionState::Failed) {
            return kExitFailed;
        }
        if (!reported) {
            return complain(reported.error().format(), kExitFailed);
        }
        return finished ? kExitDone : kExitInterrupted;
    }

  private:
    bool isSppm() const { return scene_->options.integrator == IntegratorKind::Sppm; }

    int start() {
        auto backend = makeBackend(options_.backend, options_.threads);
        if (!backend) {
            return complain(backend.error().format(), kExitBadInput);
        }
        const Result<AovChoice> aovs = chooseAovs(options_.aovs);
        if (!aovs) {
            return complain(aovs.error().format(), kExitBadInput);
        }
        aovs_ = *aovs;
        std::optional<ResumePoint> from;
        if (!options_.resume.empty()) {
            Result<ResumePoint> loaded = loadCheckpoint(options_.resume, *scene_);
            if (!loaded) {
                return complain(loaded.error().format(), kExitBadInput);
            }
            from = std::move(*loaded);
            startPasses_ = from->film.passes();
        }
        SessionOptions session;
        session.previews = false;
        session.snapshots = false;
        session.lowPriority = false;
        session.threads = options_.threads;
        session_ = std::make_unique<RenderSession>(std::move(*backend), session);
        session_->setLimits(limitsUntilNextPicture(startPasses_));
        session_->request(aovs_.aovs, aovs_.standardError);
        if (from) {
            session_->resume(scene_, std::move(*from));
        } else {
            session_->post({scene_, EditKind::Everything});
        }
        return kExitDone;
    }

    /// True when a limit was reached or the session failed, false when the user interrupted.
    bool waitUntilDone() {
        const InterruptGuard interrupt;
        ProgressLine progress;
        auto savedAt = Clock::now();
        bool finished = false;
        while (!finished && !interrupt.interrupted()) {
            const SessionState state = session_->wait(kPollSeconds);
            finished = state == SessionState::Finished || state == SessionState::Failed;
            if (state == SessionState::Finished && goesOnAfterPicture()) {
                finished = false;
            }
            progress.update(session_->status(), limits_);
            const double sinceSave = std::chrono::duration<double>(Clock::now() - savedAt).count();
            if (!finished && options_.checkpointEvery > 0.0 && sinceSave >= options_.checkpointEvery) {
                saveOnTheWay();
                savedAt = Clock::now();
            }
        }
        progress.finish();
        return finished;
    }

    /// The limits, or fewer passes where a numbered picture comes before.
    StopLimits limitsUntilNextPicture(uint32_t passes) {
        StopLimits limits = limits_;
        nextPicture_ = 0;
        if (options_.pictureEvery > 0) {
            const uint32_t next = (passes / options_.pictureEvery + 1) * options_.pictureEvery;
            if (limits.passes == 0 || next < limits.passes) {
                limits.passes = nextPicture_ = next;
            }
        }
        return limits;
    }

    /// When the session stopped for a numbered picture: writes it and lets it go on. False: a limit that the
    /// user set was reached.
    bool goesOnAfterPicture() {
        const uint32_t passes = session_->status().passes;
        if (nextPicture_ == 0 || passes != nextPicture_) {
            return false;
        }
        if (const auto capture = session_->capture()) {
            const std::string path = numberedPath(options_.output, passes);
            if (const Status saved = writePicture(*capture, path); !saved) {
                logError("{}", saved.error().format());
            }
        }
        session_->setLimits(limitsUntilNextPicture(passes));
        return true;
    }

    void saveOnTheWay() {
        const auto capture = session_->capture();
        if (!capture) {
            return;
        }
        const Status saved = saveCheckpoint(options_.checkpoint, *capture);
        if (!saved) {
            // The render is worth more than this save: the one at the end may succeed.
            logError("{}", saved.error().format());
        }
    }

    Status writePicture(const SessionCapture& capture, const std::string& path) const {
        auto snapshot = makeSnapshot(capture, {.standardError = aovs_.standardError}, options_.threads);
        snapshot->aovs = std::make_shared<AovFilm>(capture.aovs);
        PictureOptions picture;
        picture.exposureStops = options_.exposure;
        picture.toneMap = toneMapFromName(options_.tone).value_or(ToneMap::Srgb);
        picture.exrColor = options_.exrFloat ? ExrPixelType::Float : ExrPixelType::Half;
        picture.aovs = aovs_.aovs;
        picture.threads = options_.threads;
        return savePicture(path, *snapshot, *capture.scene, picture);
    }

    Status save(const SessionCapture& capture) const {
        const Status saved = writePicture(capture, options_.output);
        // A full disk must not cost the checkpoint too.
        const Status kept =
            options_.checkpoint.empty() ? Status() : saveCheckpoint(options_.checkpoint, capture);
        return saved ? kept : saved;
    }

    Status report(const SessionCapture& capture, const SessionStatus& status) const {
        const double seconds = capture.renderSeconds;
        const double error = isSppm() ? capture.sppm.relativeErrorEstimate(capture.film)
                                      : capture.film.relativeErrorEstimate(options_.threads);
        const double paths = static_cast<double>(capture.film.pixels().size()) * capture.film.passes();
        if (!jsonTakesOutput(options_.json)) {
            fmt::print(
                "{}: {}x{}, {} passes in {:.2f} s ({:.2f} Mpaths/s, {}, kernel {}), relative error {}\n",
                options_.output, capture.film.width(), capture.film.height(), capture.film.passes(), seconds,
                paths / seconds * 1e-6, status.backend, status.kernel,
                std::isfinite(error) ? fmt::format("{:.2f} %", 100.0 * error) : "unknown");
        }
        if (isSppm() && !jsonTakesOutput(options_.json)) {
            fmt::print("photons: {} a pass, {:.4g} in all ({:.3f} M/s)\n", photonsPerPass_,
                       static_cast<double>(capture.sppm.emittedPhotons),
                       static_cast<double>(capture.sppm.emittedPhotons) / seconds * 1e-6);
        }
        reportFaults(capture.film);
        if (scene_->options.fireflyClamp > 0.0f) {
            logWarning("samples were clamped to {} (firefly clamp): the picture is biased",
                       scene_->options.fireflyClamp);
        }
        return writeJson(options_.json, jsonReport(capture, status, error));
    }

    void reportFaults(const Film& film) const {
        const auto& counts = film.faultCounts();
        const uint64_t dropped = counts[1] + counts[2] + counts[3];
        if (dropped == 0) {
            return;
        }
        fmt::print(stderr, "{} samples were dropped: {} not a number, {} infinite, {} negative\n", dropped,
                   counts[1], counts[2], counts[3]);
        if (!film.faults().empty() && !isSppm()) {
            const FaultRecord& first = film.faults().front();
            fmt::print(stderr,
                       "  look into the first with: glint render {} --pixel {},{} --pass {} --size {}x{} "
                       "--seed {}\n",
                       options_.scene, first.x, first.y, first.pass, film.width(), film.height(),
                       scene_->options.seed);
        }
    }

    nlohmann::ordered_json jsonReport(const SessionCapture& capture, const SessionStatus& status,
                                      double error) const {
        const Film& film = capture.film;
        const double paths = static_cast<double>(film.pixels().size()) * film.passes();
        nlohmann::ordered_json faults = nlohmann::ordered_json::array();
        for (const FaultRecord& fault : film.faults()) {
            faults.push_back({{"x", fault.x},
                              {"y", fault.y},
                              {"pass", fault.pass},
                              {"cause", static_cast<int>(fault.fault)}});
        }
        nlohmann::ordered_json report = {{"scene", options_.scene},
                                         {"output", options_.output},
                                         {"integrator", isSppm() ? "sppm" : "path"},
                                         {"width", film.width()},
                                         {"height", film.height()},
                                         {"passes", film.passes()},
                                         {"load_seconds", loadSeconds_},
                                         {"build_seconds", status.lastBuildSeconds},
                                         {"render_seconds", capture.renderSeconds},
                                         {"paths_per_second", paths / capture.renderSeconds},
                                         {"rays", film.rays()},
                                         {"relative_error", error},
                                         {"backend", status.backend},
                                         {"kernel", status.kernel},
                                         {"seed", scene_->options.seed},
                                         {"dropped",
                                          {{"not_a_number", film.faultCounts()[1]},
                                           {"infinite", film.faultCounts()[2]},
                                           {"negative", film.faultCounts()[3]}}},
                                         {"dropped_samples", faults},
                                         {"firefly_clamp", scene_->options.fireflyClamp}};
        if (isSppm()) {
            report["sppm"] = {{"photons_per_pass", photonsPerPass_},
                              {"photons_asked", scene_->sppm.photonsPerPass},
                              {"emitted_photons", capture.sppm.emittedPhotons},
                              {"bytes", capture.sppm.bytes()}};
        }
        return report;
    }

    std::shared_ptr<const SceneDescription> scene_;
    const RenderCommandOptions& options_;
    double loadSeconds_;
    StopLimits limits_;
    AovChoice aovs_;
    uint32_t photonsPerPass_ = 0;  ///< SPPM: what the budget allows
    uint32_t startPasses_ = 0;     ///< that the checkpoint brought
    uint32_t nextPicture_ = 0;     ///< pass count of the next numbered picture; 0: none before the end
    std::unique_ptr<RenderSession> session_;
};

}  // namespace

int runRender(std::shared_ptr<const SceneDescription> scene, const RenderCommandOptions& options,
              double loadSeconds) {
    return BatchRender(std::move(scene), options, loadSeconds).run();
}

int runReplay(const SceneDescription& scene, const RenderCommandOptions& options) {
    const Result<Vec2i> pixel = parsePair(options.pixel, ',', "--pixel");
    if (!pixel) {
        return complain(pixel.error().format(), kExitBadInput);
    }
    if (scene.options.integrator == IntegratorKind::Sppm) {
        return complain("--pixel follows the path tracer's paths; add --integrator path", kExitBadInput);
    }
    const Resolution& size = scene.resolution;
    if (pixel->x < 0 || pixel->y < 0 || pixel->x >= size.width || pixel->y >= size.height) {
        return complain(fmt::format("--pixel {} lies outside the picture of {}x{} pixels", options.pixel,
                                    size.width, size.height),
                        kExitBadInput);
    }
    const auto built = buildScene({std::make_shared<SceneDescription>(scene), EditKind::Everything}, nullptr,
                                  options.threads, nullptr, nullptr);
    if (!built) {
        return complain(built.error().format(), kExitBadInput);
    }
    PassParams params = passParamsOf(scene);
    params.pass = options.replayPass.value_or(0);
    const PathReplay replay = replayPath((*built)->view(), (*built)->features, params, pixel->x, pixel->y);
    fmt::print("{}", formatPathLog(replay, params, pixel->x, pixel->y));
    return kExitDone;
}

}  // namespace glint
