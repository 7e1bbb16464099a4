// Every message is joined to what already waits, so that the render thread never falls behind a
// dragging hand.
#include "engine/render/command_queue.h"

#include <utility>

namespace glint {
namespace {

/// A preview with no more than this to go is let through: stopping it would lose a picture and gain less than
/// a frame.
constexpr double kAlmostDoneSeconds = 0.008;

bool asksForMore(const RenderRequest& before, const RenderRequest& now) {
    return (now.standardError && !before.standardError) || (now.integratorMaps && !before.integratorMaps) ||
           (now.errorMaps && !before.errorMaps) || (now.aovs & ~before.aovs) != 0;
}

}  // namespace

EditTicket CommandQueue::post(SceneEdit edit, FilmTake take, std::optional<ResumePoint> resume) {
    const std::lock_guard lock(mutex_);
    const EditKind waiting = commands_.edit ? commands_.edit->kinds : EditKind::None;
    edit.kinds |= waiting;
    if (has(edit.kinds, EditKind::Everything)) { abandonBuild_ = true; }
    commands_.edit = std::move(edit);
    commands_.take = take;
    commands_.resume = std::move(resume);
    return postEdit(SessionClock::now());
}

EditTicket CommandQueue::postRestart() {
    const std::lock_guard lock(mutex_);
    commands_.restart = true;
    return postEdit(SessionClock::now());
}

void CommandQueue::postQuit() {
    const std::lock_guard lock(mutex_);
    commands_.quit = true;
    abandonBuild_ = true;
    stop_ = true;
    asked();
}

void CommandQueue::postCapture(CapturePromise capture) {
    const std::lock_guard lock(mutex_);
    commands_.captures.push_back(std::move(capture));
    asked();
}

void CommandQueue::request(const RenderRequest& request) {
    const std::lock_guard lock(mutex_);
    if (request == request_) { return; }
    const RenderRequest before = std::exchange(request_, request);
    if (pass_ && pass_->mayWait &&
        (request_.paused || asksForMore(before, request_) || before.region != request_.region)) {
        stop_ = true;
        stopRaised_ = SessionClock::now();
    }
    asked();
}

Commands CommandQueue::take(const std::function<bool(const RenderRequest&)>& hasWork,
                            RenderRequest* request) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return commands_.messages != taken_ || hasWork(request_); });
    taken_ = commands_.messages;
    *request = request_;
    abandonBuild_ = commands_.quit;
    Commands taken = std::exchange(commands_, {});
    commands_.ticket = taken.ticket;
    commands_.messages = taken_;
    return taken;
}

void CommandQueue::beginPass(const PassInFlight& pass) {
    const std::lock_guard lock(mutex_);
    pass_ = pass;
    passBegan_ = SessionClock::now();
    const bool stopNow = commands_.quit || (commands_.invalidatesImage() && worthStopping(passBegan_)) ||
                         (request_.paused && pass.mayWait);
    stop_ = stopNow;
    stopRaised_ = passBegan_;
}

void CommandQueue::endPass() {
    const std::lock_guard lock(mutex_);
    pass_.reset();
}

SessionClock::time_point CommandQueue::stopRaised() const {
    const std::lock_guard lock(mutex_);
    return stopRaised_;
}

uint64_t CommandQueue::messages() const {
    const std::lock_guard lock(mutex_);
    return commands_.messages;
}

EditTicket CommandQueue::postEdit(SessionClock::time_point now) {
    commands_.firstPosted = commands_.firstPosted.value_or(now);
    raiseStopFor(now);
    asked();
    return ++commands_.ticket;
}

bool CommandQueue::worthStopping(SessionClock::time_point now) const {
    if (!pass_) { return true; }
    if (pass_->mustBeShown) { return false; }
    const double elapsed = secondsBetween(passBegan_, now);
    const double toGo = pass_->previewSeconds - elapsed;
    // One that takes much longer than expected is not trusted to end soon.
    const bool almostDone = toGo < kAlmostDoneSeconds && elapsed < 2.0 * pass_->previewSeconds;
    return !almostDone;
}

void CommandQueue::asked() {
    ++commands_.messages;
    changed_.notify_one();
}

void CommandQueue::raiseStopFor(SessionClock::time_point posted) {
    if (worthStopping(posted) && !stop_.exchange(true)) { stopRaised_ = posted; }
}

}  // namespace glint
