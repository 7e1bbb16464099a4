// Every message is joined to what already waits, so that the render thread never falls behind a dragging
// hand.
#include "engine/render/mailbox.h"

#include <utility>

namespace glint {
namespace {

/// A preview with no more than this to go is let through: stopping it would lose a picture and gain less than
/// a frame.
constexpr double kAlmostDoneSeconds = 0.008;

bool asksForMore(const Wishes& before, const Wishes& now) {
    return (now.standardError && !before.standardError) ||
           (now.photonStatistics && !before.photonStatistics) || (now.errorMaps && !before.errorMaps) ||
           (now.aovs & ~before.aovs) != 0;
}

}  // namespace

void Mailbox::post(SceneEdit edit, std::optional<ResumePoint> resume) {
    const std::lock_guard lock(mutex_);
    const auto now = SessionClock::now();
    const EditKind waiting = mail_.edit ? mail_.edit->kinds : EditKind::None;
    edit.kinds |= waiting;
    if (has(edit.kinds, EditKind::Everything)) {
        abandonBuild_ = true;
    }
    mail_.edit = std::move(edit);
    mail_.resume = std::move(resume);
    mail_.firstPosted = mail_.firstPosted.value_or(now);
    raiseStopFor(now);
    asked();
}

void Mailbox::postRestart() {
    const std::lock_guard lock(mutex_);
    const auto now = SessionClock::now();
    mail_.restart = true;
    mail_.firstPosted = mail_.firstPosted.value_or(now);
    raiseStopFor(now);
    asked();
}

void Mailbox::postQuit() {
    const std::lock_guard lock(mutex_);
    mail_.quit = true;
    abandonBuild_ = true;
    stop_ = true;
    asked();
}

void Mailbox::postCapture(CapturePromise capture) {
    const std::lock_guard lock(mutex_);
    mail_.captures.push_back(std::move(capture));
    asked();
}

void Mailbox::change(const std::function<void(Wishes&)>& how) {
    const std::lock_guard lock(mutex_);
    const Wishes before = wishes_;
    how(wishes_);
    if (pass_ && pass_->mayWait && (wishes_.paused || asksForMore(before, wishes_))) {
        stop_ = true;
        stopRaised_ = SessionClock::now();
    }
    asked();
}

Mail Mailbox::take(const std::function<bool(const Wishes&)>& hasWork, Wishes* wishes) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return mail_.ticket != taken_ || hasWork(wishes_); });
    taken_ = mail_.ticket;
    *wishes = wishes_;
    abandonBuild_ = mail_.quit;
    Mail taken = std::exchange(mail_, {});
    mail_.ticket = taken_;
    return taken;
}

void Mailbox::beginPass(const PassInFlight& pass) {
    const std::lock_guard lock(mutex_);
    pass_ = pass;
    passBegan_ = SessionClock::now();
    const bool stopNow = mail_.quit || (mail_.invalidatesPicture() && worthStopping(passBegan_)) ||
                         (wishes_.paused && pass.mayWait);
    stop_ = stopNow;
    stopRaised_ = passBegan_;
}

void Mailbox::endPass() {
    const std::lock_guard lock(mutex_);
    pass_.reset();
}

SessionClock::time_point Mailbox::stopRaised() const {
    const std::lock_guard lock(mutex_);
    return stopRaised_;
}

uint64_t Mailbox::ticket() const {
    const std::lock_guard lock(mutex_);
    return mail_.ticket;
}

bool Mailbox::worthStopping(SessionClock::time_point now) const {
    if (!pass_) {
        return true;
    }
    if (pass_->mustBeShown) {
        return false;
    }
    const double elapsed = secondsBetween(passBegan_, now);
    const double toGo = pass_->previewSeconds - elapsed;
    // One that takes much longer than expected is not trusted to end soon.
    const bool almostDone = toGo < kAlmostDoneSeconds && elapsed < 2.0 * pass_->previewSeconds;
    return !almostDone;
}

void Mailbox::asked() {
    ++mail_.ticket;
    changed_.notify_one();
}

void Mailbox::raiseStopFor(SessionClock::time_point posted) {
    if (worthStopping(posted) && !stop_.exchange(true)) {
        stopRaised_ = posted;
    }
}

}  // namespace glint
