// A mutex around two values: readers copy, and hold it for no longer.
#include "engine/render/published_state.h"

#include <chrono>
#include <utility>

namespace glint {
namespace {

bool rests(SessionState state) {
    return state == SessionState::Finished || state == SessionState::Failed || state == SessionState::Paused;
}

}  // namespace

void PublishedState::show(std::shared_ptr<const FilmSnapshot> snapshot) {
    const std::lock_guard lock(mutex_);
    // The old picture's memory is freed after the lock.
    snapshot_.swap(snapshot);
    if (other_ && (other_->ticket != snapshot_->ticket || other_->integrator == snapshot_->integrator)) {
        other_.reset();
    }
}

void PublishedState::showOther(std::shared_ptr<const FilmSnapshot> snapshot) {
    const std::lock_guard lock(mutex_);
    other_.swap(snapshot);
}

std::shared_ptr<const FilmSnapshot> PublishedState::snapshot(IntegratorKind integrator) const {
    const std::lock_guard lock(mutex_);
    if (snapshot_ && snapshot_->integrator == integrator) { return snapshot_; }
    return other_ && other_->integrator == integrator ? other_ : nullptr;
}

void PublishedState::setCurve(IntegratorKind integrator, std::shared_ptr<const ConvergenceCurve> curve) {
    const std::lock_guard lock(mutex_);
    // The old curve's memory is freed after the lock.
    curves_[static_cast<size_t>(integrator)].swap(curve);
}

std::shared_ptr<const ConvergenceCurve> PublishedState::curve(IntegratorKind integrator) const {
    const std::lock_guard lock(mutex_);
    return curves_[static_cast<size_t>(integrator)];
}

void PublishedState::set(const SessionStatus& status, uint64_t messages) {
    const std::lock_guard lock(mutex_);
    status_ = status;
    messages_ = messages;
    changed_.notify_all();
}

std::shared_ptr<const FilmSnapshot> PublishedState::snapshot() const {
    const std::lock_guard lock(mutex_);
    return snapshot_;
}

SessionStatus PublishedState::status() const {
    const std::lock_guard lock(mutex_);
    return status_;
}

SessionState PublishedState::wait(uint64_t messages, double seconds) const {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                      [&] { return messages_ >= messages && rests(status_.state); });
    return status_.state;
}

}  // namespace glint
