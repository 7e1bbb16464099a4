#include "engine/render/session_worker.h"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/base/thread_priority.h"
#include "engine/render/first_frame.h"

namespace glint {

SessionWorker::SessionWorker(std::unique_ptr<Backend> backend, SessionOptions options, CommandQueue* queue,
                             PublishedState* published)
    : backend_(std::move(backend)),
      options_(std::move(options)),
      queue_(queue),
      published_(published),
      keeper_(backend_.get(), options_.build, options_.threads, queue),
      images_(options_.previews, options_.heldFilmBytes, &status_.counters),
      passes_(backend_.get(), queue, published, options_.threads),
      snapshots_(published, options_.snapshots, options_.threads) {
    status_.backend = backend_->name();
    setStatus();
}

void SessionWorker::run() {
    if (options_.lowPriority) { lowerThreadPriority(); }
    bool hasQuit = false;
    while (!hasQuit) {
        try {
            Commands commands = queue_->take(
                [this](const RenderRequest& request) { return static_cast<bool>(next(request)); }, &request_);
            hasQuit = commands.quit;
            if (hasQuit) {
                std::ranges::move(commands.captures, std::back_inserter(captures_));
                answerCaptures();
            } else {
                runOnce(std::move(commands));
            }
        } catch (const std::bad_alloc&) {
            fail("not enough memory to render; fewer pixels, layers or photons need less");
        } catch (const std::exception& problem) { fail(problem.what()); }
    }
}

void SessionWorker::runOnce(Commands commands) {
    messages_ = commands.messages;
    status_.ticket = commands.ticket;
    std::ranges::move(commands.captures, std::back_inserter(captures_));
    if (commands.firstPosted) { snapshots_.expectAnswer(*commands.firstPosted); }
    if (commands.edit) {
        takeEdit(std::move(commands));
    } else if (commands.restart && keeper_.hasScene()) {
        failed_ = false;
        images_.takeTicket(status_.ticket);
        publishCurves(images_.restart(request_));
    }
    images_.takeRequest(request_);
    // What is there already, before a pass that may take long.
    showIfDue();
    serveCaptures();
    if (const NextPass pass = next(request_)) {
        setStatus();
        runPass(pass);
    }
    serveCaptures();
    showIfDue();
    setStatus();
}

void SessionWorker::fail(std::string_view why) noexcept {
    queue_->endPass();
    failed_ = true;
    status_.state = SessionState::Failed;
    const auto attempt = [](const auto& step) {
        try {
            step();
        } catch (const std::exception&) {
            // The other steps may need less memory.
        }
    };
    logError("{}", why);
    attempt([&] { status_.error = why; });
    attempt([&] { published_->set(status_, messages_); });
    attempt([&] { serveCaptures(); });
    attempt([&] { setStatus(); });
}

void SessionWorker::takeEdit(Commands commands) {
    SceneEdit& edit = *commands.edit;
    status_.state = SessionState::Building;
    if (!keeper_.hasScene()) { status_.integrator = edit.scene->options.integrator; }
    published_->set(status_, messages_);
    showFirstFrame(edit);
    const SceneKeeper::Outcome outcome = keeper_.take(&edit, &status_);
    published_->setBuiltScene(keeper_.built());
    if (outcome == SceneKeeper::Outcome::Abandoned) { return; }
    images_.takeTicket(status_.ticket);
    if (outcome == SceneKeeper::Outcome::Refused) {
        snapshots_.forgetAnswer();
        failed_ = failed_ || !keeper_.hasScene();
        return;
    }
    failed_ = false;
    if (commands.restart) { edit.kinds |= EditKind::Camera; }  // empties the films of all integrators
    publishCurves(images_.takeScene(std::move(edit.scene), edit.kinds, commands.take, request_));
    if (commands.resume) { goOnFrom(std::move(*commands.resume)); }
}

/// Of another scene that takes long to build. While one is edited, its last picture says more.
void SessionWorker::showFirstFrame(const SceneEdit& edit) {
    const bool isSeen = options_.previews && options_.snapshots;
    const bool isAnother = !keeper_.hasScene() || has(edit.kinds, EditKind::Everything);
    if (!isSeen || !isAnother ||
        trianglesToBuild(*edit.scene, keeper_.built().get()) < options_.heavyTriangles) {
        return;
    }
    try {
        auto frame = drawFirstFrame(*edit.scene, options_.threads, queue_->abandonBuild());
        if (!frame) { return; }
        frame->ticket = status_.ticket;
        status_.previewScale = frame->previewScale;
        published_->show(std::move(frame));
        published_->setBuiltScene(nullptr);  // what is seen is not the one before
    } catch (const std::bad_alloc&) {
        // The scene itself may have enough.
    }
}

void SessionWorker::goOnFrom(ResumePoint resume) {
    const Resolution& size = images_.size();
    if (resume.film.width() != size.width || resume.film.height() != size.height) {
        fail(fmt::format("the checkpoint's film has {}x{} pixels, the scene {}x{}", resume.film.width(),
                         resume.film.height(), size.width, size.height));
        return;
    }
    images_.shown().goOnFrom({.image = {std::move(resume.film), std::move(resume.statistics)},
                              .renderSeconds = resume.renderSeconds,
                              .curve = std::move(resume.curve)});
    images_.shown().estimateErrorAnew(options_.threads);
    passes_.publishCurve(images_.shown());
}

void SessionWorker::publishCurves(const std::vector<IntegratorKind>& kinds) {
    for (const IntegratorKind kind : kinds) {
        passes_.publishCurve(images_.of(kind));
    }
}

NextPass SessionWorker::next(const RenderRequest& request) const {
    if (!keeper_.hasScene() || failed_) { return {}; }
    return nextPass(images_, request, !captures_.empty());
}

void SessionWorker::runPass(const NextPass& pass) {
    const bool mustBeShown = snapshots_.shownTicket(images_, pass.integrator) < images_.ticketBefore();
    const Result<bool> done = passes_.run(pass, mustBeShown, &images_, &status_.counters);
    if (!done) {
        fail(done.error().format());
    } else if (!*done) {
        ++status_.counters.passesDiscarded;
        status_.lastCancelSeconds = secondsSince(queue_->stopRaised());
    } else if (pass.kind == NextPass::Kind::Preview && pass.integrator == images_.shownKind()) {
        showIfDue();
        images_.refinePreview(request_);
    }
}

void SessionWorker::showIfDue() { snapshots_.showIfDue(&images_, request_, !next(request_), &status_); }

void SessionWorker::serveCaptures() {
    const bool isPossible = keeper_.hasScene() && !failed_;
    const bool isComplete = request_.aovs == 0 || images_.aovs.film.passes() > 0;
    if (!captures_.empty() && (!isPossible || (images_.shown().passes() > 0 && isComplete))) {
        answerCaptures();
    }
}

void SessionWorker::answerCaptures() {
    const IntegratorState& shown = images_.shown();
    for (CapturePromise& promise : std::exchange(captures_, {})) {
        try {
            if (shown.passes() == 0) {
                promise.set_value(std::nullopt);
                continue;
            }
            const RenderedImage& image = shown.image();
            promise.set_value(SessionCapture{images_.scene(), image.film,
                                             image.statistics ? image.statistics->clone() : nullptr,
                                             images_.aovs.film, shown.renderSeconds(), shown.curve()});
        } catch (const std::bad_alloc&) { promise.set_exception(std::current_exception()); }
    }
}

SessionState SessionWorker::state() const {
    if (failed_) { return SessionState::Failed; }
    if (!keeper_.hasScene()) { return SessionState::Empty; }
    if (next(request_)) { return SessionState::Rendering; }
    return isLimitReached(images_, request_) ? SessionState::Finished : SessionState::Paused;
}

MemoryUse SessionWorker::memoryUse() const {
    MemoryUse use = keeper_.memory();
    use.add(backend_->memory());
    images_.addMemory(&use);
    passes_.addMemory(&use);
    return use;
}

void SessionWorker::setStatus() {
    const IntegratorState& shown = images_.shown();
    const Film& film = shown.image().film;
    const bool isEmpty = shown.passes() == 0;
    status_.state = state();
    status_.integrator = shown.kind();
    status_.passes = shown.passes();
    status_.renderSeconds = shown.renderSeconds();
    const double passesPerSecond = shown.secondsPerPass() > 0.0 ? 1.0 / shown.secondsPerPass() : 0.0;
    status_.passesPerSecond = passesPerSecond;
    status_.region = shown.region();
    const int64_t pathsOfPass = shown.region() ? shown.region()->pixels() : shown.image().pixels();
    status_.pathsPerSecond = passesPerSecond * static_cast<double>(pathsOfPass);
    status_.raysPerSecond = passesPerSecond * static_cast<double>(shown.raysOfPass());
    status_.relativeError = shown.error().relative;
    status_.relativeErrorLow = shown.error().low;
    status_.relativeErrorHigh = shown.error().high;
    status_.aovPasses = images_.aovs.film.passes();
    status_.memory = memoryUse();
    status_.filmBytes = images_.bytes();
    status_.faultCounts = isEmpty ? std::array<uint64_t, kSampleFaultCount>{} : film.faultCounts();
    published_->set(status_, messages_);
}

}  // namespace glint
