// The loop, and what an edit does to it. Passes are in session_passes.cpp, what is shown of
// them in session_snapshots.cpp.
#include "engine/render/session_worker.h"

#include <algorithm>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/base/thread_priority.h"

namespace glint {
namespace {

void count(const BuildReport& report, SessionCounters* counters) {
    counters->meshBuilds += static_cast<uint64_t>(report.meshesBuilt);
    counters->topLevelBuilds += report.topLevelBuilt;
    counters->materialTables += report.materialsBuilt;
    counters->textureTables += report.texturesBuilt;
    counters->lightTables += report.lightsBuilt;
    counters->featureScans += report.featuresScanned;
}

}  // namespace

SessionWorker::SessionWorker(std::unique_ptr<Backend> backend, SessionOptions options,
                             CommandQueue* commandQueue, PublishedState* published)
    : backend_(std::move(backend)),
      options_(std::move(options)),
      commandQueue_(commandQueue),
      published_(published) {
    status_.backend = backend_->name();
    setStatus();
}

void SessionWorker::run() {
    if (options_.lowPriority) { lowerThreadPriority(); }
    for (;;) {
        Commands commands = commandQueue_->take(
            [this](const RenderRequest& request) { return nextPass(request) != NextPass::None; }, &request_);
        if (commands.quit) {
            std::ranges::move(commands.captures, std::back_inserter(captures_));
            answerCaptures();
            return;
        }
        try {
            runOnce(std::move(commands));
        } catch (const std::exception& problem) {
            fail(fmt::format("the render thread stopped: {}", problem.what()));
        }
    }
}

void SessionWorker::runOnce(Commands commands) {
    messages_ = commands.messages;
    std::ranges::move(commands.captures, std::back_inserter(captures_));
    if (commands.firstPosted && !unansweredEdit_) { unansweredEdit_ = commands.firstPosted; }
    if (commands.invalidatesImage()) {
        previousTicket_ = status_.ticket;
        status_.ticket = commands.ticket;
    }
    if (commands.edit) {
        if (commands.restart) {
            commands.edit->kinds |= EditKind::Camera;  // empties the films of both integrators
        }
        takeEdit(std::move(*commands.edit), std::move(commands.resume));
    } else if (commands.restart && built_) {
        failed_ = false;
        restartImage(EditKind::Everything);
    }
    takeRequests();
    showIfDue();  // what is there already, before a pass that may take long
    const NextPass kind = nextPass(request_);
    if (kind != NextPass::None) {
        setStatus();
        runPass(kind);
    }
    serveCaptures();
    showIfDue();
    setStatus();
}

void SessionWorker::takeRequests() {
    if (request_.aovs == 0 && (aovFilm_.width() > 0 || previewAovs_.width() > 0)) {
        aovFilm_ = AovFilm();
        previewAovs_ = AovFilm();
        shownAovs_.reset();
    }
    if (built_ && isComparing(request_) && !otherPreviewing_ && !comparing_) { startOtherPreview(); }
    comparing_ = isComparing(request_);
    // A picture at rest has to be shown again with what it lacked.
    if (shownLacksRequest() && filmPasses() > 0) { shownIsOld_ = true; }
}

bool SessionWorker::shownLacksRequest() const {
    return (request_.standardError && !shownStandardError_) ||
           (request_.integratorMaps && !shownIntegratorMaps_) || (request_.errorMaps && !shownErrorMaps_);
}

void SessionWorker::fail(const std::string& why) {
    commandQueue_->endPass();
    failed_ = true;
    status_.error = why;
    logError("{}", why);
    serveCaptures();
    setStatus();
}

void SessionWorker::takeEdit(SceneEdit edit, std::optional<ResumePoint> resume) {
    edit.kinds |= refusedKinds_;
    if (!built_) { edit.kinds |= EditKind::Everything; }
    status_.state = SessionState::Building;
    published_->set(status_, messages_);
    if (!rebuild(edit)) { return; }
    scene_ = std::move(edit.scene);
    refusedKinds_ = EditKind::None;
    failed_ = false;
    status_.error.clear();
    if (has(edit.kinds, EditKind::Everything)) { std::ranges::for_each(paces_, &PreviewScale::forget); }
    if (resume) {
        continueFrom(std::move(*resume));
    } else {
        restartImage(edit.kinds);
    }
}

bool SessionWorker::rebuild(const SceneEdit& edit) {
    if ((edit.kinds & (EditKind::SppmParameters | EditKind::Integrator)) == edit.kinds) { return true; }
    const auto began = SessionClock::now();
    BuildReport report;
    auto result =
        options_.build(edit, built_.get(), options_.threads, &commandQueue_->abandonBuild(), &report);
    count(report, &status_.counters);
    if (!result) {
        refuse(edit.kinds, result.error().format());
        return false;
    }
    if (const Status taken = backend_->setScene(*result); !taken) {
        refuse(edit.kinds, taken.error().format());
        return false;
    }
    built_ = std::move(result).value();
    sceneMemory_ = memoryOf(*built_);
    status_.kernel = backend_->kernelName(edit.scene->options.sampler);
    status_.lastBuildSeconds = secondsSince(began);
    return true;
}

void SessionWorker::refuse(EditKind kinds, const std::string& why) {
    refusedKinds_ |= kinds;
    if (commandQueue_->abandonBuild()) {
        return;  // Given up for a newer scene, which will be built instead.
    }
    unansweredEdit_.reset();
    ++status_.counters.editsRefused;
    status_.refusedTicket = status_.ticket;
    status_.error = why;
    failed_ = failed_ || built_ == nullptr;
    logError("{}", why);
}

IntegratorKind SessionWorker::integrator() const {
    return scene_ ? scene_->options.integrator : IntegratorKind::PathTracing;
}

bool SessionWorker::isComparing(const RenderRequest& request) const {
    return std::ranges::find(request.compare, otherIntegrator()) != request.compare.end();
}

IntegratorKind SessionWorker::otherIntegrator() const {
    return integrator() == IntegratorKind::Sppm ? IntegratorKind::PathTracing : IntegratorKind::Sppm;
}

void SessionWorker::restartImage(EditKind kinds) {
    const bool sppmOnly = (kinds & (EditKind::SppmParameters | EditKind::Integrator)) == kinds;
    for (size_t kind = 0; kind < kIntegrators; ++kind) {
        const bool isSppm = static_cast<IntegratorKind>(kind) == IntegratorKind::Sppm;
        if (!sppmOnly || (isSppm && has(kinds, EditKind::SppmParameters))) {
            integratorStates_[kind].isStale = true;
            ++integratorStates_[kind].restarts;
            integratorStates_[kind].renderSeconds = 0.0;
            integratorStates_[kind].error = {};
            integratorStates_[kind].secondsPerPass = 0.0;
            integratorStates_[kind].curve.clear();
            publishCurve(static_cast<IntegratorKind>(kind));
        }
    }
    if (!sppmOnly) {
        aovFilm_.clear();
        shownAovs_.reset();
    }
    otherPreviewing_ = false;
    if (filmPasses() > 0) {
        previewing_ = false;
        shownIsOld_ = true;
    } else {
        startIntegratorState();
    }
    startOtherPreview();
}

void SessionWorker::startIntegratorState() {
    ++status_.counters.filmRestarts;
    const int scale = previewScaleNow(previewing_ ? previewScale_ : 0);
    previewing_ = scale > 1;
    if (previewing_) { startPreview(scale); }
}

void SessionWorker::continueFrom(ResumePoint resume) {
    const Resolution& size = scene_->resolution;
    restartImage(EditKind::Everything);
    if (resume.film.width() != size.width || resume.film.height() != size.height) {
        fail(fmt::format("the checkpoint's film has {}x{} pixels, the scene {}x{}", resume.film.width(),
                         resume.film.height(), size.width, size.height));
        return;
    }
    IntegratorState& resumed = integratorState();
    resumed.film = std::move(resume.film);
    resumed.sppm = std::move(resume.sppm);
    resumed.isStale = false;
    ++resumed.restarts;
    resumed.renderSeconds = resume.renderSeconds;
    resumed.error = errorEstimate(resumed);
    resumed.curve = std::move(resume.curve);
    publishCurve(integrator());
    previewing_ = false;
    shownIsOld_ = true;
}

void SessionWorker::startPreview(int scale) {
    const Resolution& size = scene_->resolution;
    const int width = previewSize(size.width, scale);
    const int height = previewSize(size.height, scale);
    if (preview_.width() == width && preview_.height() == height) {
        preview_.clear();
    } else {
        preview_ = Film(width, height);
    }
    if (integrator() == IntegratorKind::Sppm) { previewSppm_.passes = 0; }
    previewAovs_ = AovFilm();
    previewScale_ = scale;
}

/// While comparing, the two previews share the time and have one size: that of the slower integrator.
int SessionWorker::previewScaleNow(int present) const {
    if (!options_.previews) { return 1; }
    const Resolution& size = scene_->resolution;
    if (!isComparing(request_)) { return pace().choose(size.width, size.height, present); }
    constexpr double kSeconds = 0.6 * PreviewScale::kTargetSeconds;
    return std::max(pace().choose(size.width, size.height, present, kSeconds),
                    paceOf(otherIntegrator()).choose(size.width, size.height, present, kSeconds));
}

void SessionWorker::startOtherPreview() {
    if (!isComparing(request_) || stateOf(otherIntegrator()).passes() > 0) { return; }
    const int scale = previewing_ ? previewScale_ : previewScaleNow(otherPreviewScale_);
    otherPreviewing_ = scale > 1;
    if (!otherPreviewing_) { return; }
    otherPreviewScale_ = scale;
    const int width = previewSize(scene_->resolution.width, scale);
    const int height = previewSize(scene_->resolution.height, scale);
    if (otherPreview_.width() == width && otherPreview_.height() == height) {
        otherPreview_.clear();
    } else {
        otherPreview_ = Film(width, height);
    }
    if (otherIntegrator() == IntegratorKind::Sppm) { previewSppm_.passes = 0; }
}

void SessionWorker::serveCaptures() {
    const bool possible = built_ && !failed_;
    if (!captures_.empty() && (!possible || filmPasses() > 0)) { answerCaptures(); }
}

void SessionWorker::answerCaptures() {
    for (CapturePromise& promise : captures_) {
        if (filmPasses() > 0) {
            const IntegratorState& shown = integratorState();
            promise.set_value(
                SessionCapture{scene_, shown.film, shown.sppm, aovFilm_, shown.renderSeconds, shown.curve});
        } else {
            promise.set_value(std::nullopt);
        }
    }
    captures_.clear();
}

SessionState SessionWorker::state() const {
    if (failed_) { return SessionState::Failed; }
    if (!built_) { return SessionState::Empty; }
    if (nextPass(request_) != NextPass::None) { return SessionState::Rendering; }
    return limitReached(request_) ? SessionState::Finished : SessionState::Paused;
}

MemoryUse SessionWorker::memoryUse() const {
    MemoryUse use = sceneMemory_;
    use.add(backend_->memory());
    for (const IntegratorState& kept : integratorStates_) {
        use[MemoryPart::Film] += kept.film.bytes();
        use[MemoryPart::SppmStatistics] += kept.sppm.bytes();
    }
    use[MemoryPart::PassSamples] = samples_.capacity() * sizeof(PixelSample);
    use[MemoryPart::Preview] =
        preview_.bytes() + otherPreview_.bytes() + previewSppm_.bytes() + previewAovs_.bytes();
    use[MemoryPart::Aovs] = aovFilm_.bytes() + aovSamples_.capacity() * sizeof(AovSample);
    return use;
}

void SessionWorker::setStatus() {
    status_.state = state();
    status_.passes = filmPasses();
    const IntegratorState& shown = integratorState();
    status_.integrator = integrator();
    status_.renderSeconds = shown.renderSeconds;
    const double passesPerSecond = shown.secondsPerPass > 0.0 ? 1.0 / shown.secondsPerPass : 0.0;
    status_.passesPerSecond = passesPerSecond;
    status_.pathsPerSecond = passesPerSecond * static_cast<double>(shown.film.pixels().size());
    status_.raysPerSecond = passesPerSecond * static_cast<double>(shown.raysOfPass);
    status_.relativeError = shown.error.relative;
    status_.relativeErrorLow = shown.error.low;
    status_.relativeErrorHigh = shown.error.high;
    status_.aovPasses = aovFilm_.passes();
    status_.memory = memoryUse();
    status_.filmBytes = preview_.bytes() + otherPreview_.bytes() + previewSppm_.bytes() + aovFilm_.bytes() +
                        previewAovs_.bytes();
    for (const IntegratorState& kept : integratorStates_) {
        status_.filmBytes += kept.film.bytes() + kept.sppm.bytes();
    }
    status_.faultCounts =
        shown.isStale ? std::array<uint64_t, kSampleFaultCount>{} : shown.film.faultCounts();
    status_.photonsPerPass = scene_ ? planSppmMemory(*scene_).photonsPerPass : 0;
    published_->set(status_, messages_);
}

}  // namespace glint
