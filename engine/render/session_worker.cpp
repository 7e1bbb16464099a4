// The loop, and what an edit does to it. Passes are in session_passes.cpp, what is shown of
// them in session_pictures.cpp.
#include "engine/render/session_worker.h"

#include <algorithm>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/base/thread_priority.h"

namespace glint {
namespace {

void count(const BuildReport& report, SessionStatus::Counters* counters) {
    counters->meshBuilds += static_cast<uint64_t>(report.meshesBuilt);
    counters->topLevelBuilds += report.topLevelBuilt;
    counters->materialTables += report.materialsBuilt;
    counters->textureTables += report.texturesBuilt;
    counters->lightTables += report.lightsBuilt;
    counters->featureScans += report.featuresScanned;
}

}  // namespace

SessionWorker::SessionWorker(std::unique_ptr<Backend> backend, SessionOptions options, Mailbox* mailbox,
                             Bulletin* bulletin)
    : backend_(std::move(backend)), options_(std::move(options)), mailbox_(mailbox), bulletin_(bulletin) {
    status_.backend = backend_->name();
    setStatus();
}

void SessionWorker::run() {
    if (options_.lowPriority) {
        lowerThreadPriority();
    }
    for (;;) {
        Mail mail = mailbox_->take(
            [this](const Wishes& wishes) { return nextPass(wishes) != NextPass::None; }, &wishes_);
        if (mail.quit) {
            std::ranges::move(mail.captures, std::back_inserter(captures_));
            answerCaptures();
            return;
        }
        try {
            runOnce(std::move(mail));
        } catch (const std::exception& problem) {
            fail(fmt::format("the render thread stopped: {}", problem.what()));
        }
    }
}

void SessionWorker::runOnce(Mail mail) {
    ticket_ = mail.ticket;
    std::ranges::move(mail.captures, std::back_inserter(captures_));
    if (mail.firstPosted && !unansweredEdit_) {
        unansweredEdit_ = mail.firstPosted;
    }
    if (mail.edit) {
        if (mail.restart) {
            mail.edit->kinds |= EditKind::Camera;  // empties the films of both integrators
        }
        takeEdit(std::move(*mail.edit), std::move(mail.resume));
    } else if (mail.restart && built_) {
        failed_ = false;
        ++status_.generation;
        restartPicture(EditKind::Everything);
    }
    takeRequests();
    showIfDue();  // what is there already, before a pass that may take long
    const NextPass kind = nextPass(wishes_);
    if (kind != NextPass::None) {
        setStatus();
        runPass(kind);
    }
    serveCaptures();
    showIfDue();
    setStatus();
}

void SessionWorker::takeRequests() {
    if (wishes_.aovs == 0 && (aovFilm_.width() > 0 || previewAovs_.width() > 0)) {
        aovFilm_ = AovFilm();
        previewAovs_ = AovFilm();
        shownAovs_.reset();
    }
    if (built_ && wishes_.compare && !otherPreviewing_ && !comparing_) {
        startOtherPreview();
    }
    comparing_ = wishes_.compare;
    // A picture at rest has to be shown again with what it lacked.
    if (shownLacksWishes() && filmPasses() > 0) {
        shownIsOld_ = true;
    }
}

bool SessionWorker::shownLacksWishes() const {
    return (wishes_.standardError && !shownStandardError_) ||
           (wishes_.photonStatistics && !shownPhotonStatistics_) || (wishes_.errorMaps && !shownErrorMaps_);
}

void SessionWorker::fail(const std::string& why) {
    mailbox_->endPass();
    failed_ = true;
    status_.error = why;
    logError("{}", why);
    serveCaptures();
    setStatus();
}

void SessionWorker::takeEdit(SceneEdit edit, std::optional<ResumePoint> resume) {
    ++status_.generation;
    edit.kinds |= refusedKinds_;
    if (!built_) {
        edit.kinds |= EditKind::Everything;
    }
    status_.state = SessionState::Building;
    bulletin_->set(status_, ticket_);
    if (!rebuild(edit)) {
        return;
    }
    scene_ = std::move(edit.scene);
    refusedKinds_ = EditKind::None;
    failed_ = false;
    status_.error.clear();
    if (has(edit.kinds, EditKind::Everything)) {
        std::ranges::for_each(paces_, &PreviewScale::forget);
    }
    if (resume) {
        continueFrom(std::move(*resume));
    } else {
        restartPicture(edit.kinds);
    }
}

bool SessionWorker::rebuild(const SceneEdit& edit) {
    if ((edit.kinds & (EditKind::SppmParameters | EditKind::Integrator)) == edit.kinds) {
        return true;
    }
    const auto began = SessionClock::now();
    BuildReport report;
    auto result = options_.build(edit, built_.get(), options_.threads, &mailbox_->abandonBuild(), &report);
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
    status_.kernel = backend_->kernelName();
    status_.lastBuildSeconds = secondsSince(began);
    return true;
}

void SessionWorker::refuse(EditKind kinds, const std::string& why) {
    refusedKinds_ |= kinds;
    if (mailbox_->abandonBuild()) {
        return;  // Given up for a newer scene, which will be built instead.
    }
    unansweredEdit_.reset();
    ++status_.counters.editsRefused;
    status_.error = why;
    failed_ = failed_ || built_ == nullptr;
    logError("{}", why);
}

IntegratorKind SessionWorker::integrator() const {
    return scene_ ? scene_->options.integrator : IntegratorKind::PathTracing;
}

IntegratorKind SessionWorker::otherIntegrator() const {
    return integrator() == IntegratorKind::Sppm ? IntegratorKind::PathTracing : IntegratorKind::Sppm;
}

void SessionWorker::restartPicture(EditKind kinds) {
    const bool sppmOnly = (kinds & (EditKind::SppmParameters | EditKind::Integrator)) == kinds;
    for (size_t kind = 0; kind < kTracks; ++kind) {
        const bool isSppm = static_cast<IntegratorKind>(kind) == IntegratorKind::Sppm;
        if (!sppmOnly || (isSppm && has(kinds, EditKind::SppmParameters))) {
            tracks_[kind].isStale = true;
            ++tracks_[kind].restarts;
            tracks_[kind].renderSeconds = 0.0;
            tracks_[kind].error = {};
            tracks_[kind].secondsPerPass = 0.0;
            tracks_[kind].curve.clear();
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
        startTrack();
    }
    startOtherPreview();
}

void SessionWorker::startTrack() {
    ++status_.counters.filmRestarts;
    const int scale = previewScaleNow(previewing_ ? previewScale_ : 0);
    previewing_ = scale > 1;
    if (previewing_) {
        startPreview(scale);
    }
}

void SessionWorker::continueFrom(ResumePoint resume) {
    const Resolution& size = scene_->resolution;
    restartPicture(EditKind::Everything);
    if (resume.film.width() != size.width || resume.film.height() != size.height) {
        fail(fmt::format("the checkpoint's film has {}x{} pixels, the scene {}x{}", resume.film.width(),
                         resume.film.height(), size.width, size.height));
        return;
    }
    Track& resumed = track();
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
    if (integrator() == IntegratorKind::Sppm) {
        previewSppm_.passes = 0;
    }
    previewAovs_ = AovFilm();
    previewScale_ = scale;
}

/// While comparing, the two previews share the time and have one size: that of the slower integrator.
int SessionWorker::previewScaleNow(int present) const {
    if (!options_.previews) {
        return 1;
    }
    const Resolution& size = scene_->resolution;
    if (!wishes_.compare) {
        return pace().choose(size.width, size.height, present);
    }
    constexpr double kSeconds = 0.6 * PreviewScale::kTargetSeconds;
    return std::max(pace().choose(size.width, size.height, present, kSeconds),
                    paceOf(otherIntegrator()).choose(size.width, size.height, present, kSeconds));
}

void SessionWorker::startOtherPreview() {
    if (!wishes_.compare || trackOf(otherIntegrator()).passes() > 0) {
        return;
    }
    const int scale = previewing_ ? previewScale_ : previewScaleNow(otherPreviewScale_);
    otherPreviewing_ = scale > 1;
    if (!otherPreviewing_) {
        return;
    }
    otherPreviewScale_ = scale;
    const int width = previewSize(scene_->resolution.width, scale);
    const int height = previewSize(scene_->resolution.height, scale);
    if (otherPreview_.width() == width && otherPreview_.height() == height) {
        otherPreview_.clear();
    } else {
        otherPreview_ = Film(width, height);
    }
    if (otherIntegrator() == IntegratorKind::Sppm) {
        previewSppm_.passes = 0;
    }
}

void SessionWorker::serveCaptures() {
    const bool possible = built_ && !failed_;
    if (!captures_.empty() && (!possible || filmPasses() > 0)) {
        answerCaptures();
    }
}

void SessionWorker::answerCaptures() {
    for (CapturePromise& promise : captures_) {
        if (filmPasses() > 0) {
            const Track& shown = track();
            promise.set_value(
                SessionCapture{scene_, shown.film, shown.sppm, aovFilm_, shown.renderSeconds, shown.curve});
        } else {
            promise.set_value(std::nullopt);
        }
    }
    captures_.clear();
}

SessionState SessionWorker::state() const {
    if (failed_) {
        return SessionState::Failed;
    }
    if (!built_) {
        return SessionState::Empty;
    }
    if (nextPass(wishes_) != NextPass::None) {
        return SessionState::Rendering;
    }
    return limitReached(wishes_) ? SessionState::Finished : SessionState::Paused;
}

MemoryUse SessionWorker::memoryUse() const {
    MemoryUse use = sceneMemory_;
    use.add(backend_->memory());
    for (const Track& kept : tracks_) {
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
    const Track& shown = track();
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
    for (const Track& kept : tracks_) {
        status_.filmBytes += kept.film.bytes() + kept.sppm.bytes();
    }
    status_.faultCounts =
        shown.isStale ? std::array<uint64_t, kSampleFaultCount>{} : shown.film.faultCounts();
    status_.photonsPerPass = scene_ ? planSppmMemory(*scene_).photonsPerPass : 0;
    bulletin_->set(status_, ticket_);
}

}  // namespace glint
