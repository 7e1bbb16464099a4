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
    std::map<IntegratorKind, std::shared_ptr<const FilmSnapshot>> dropped;
    const std::lock_guard lock(mutex_);
    // The memory of old pictures is freed after the lock.
    snapshot_.swap(snapshot);
    for (auto beside = beside_.begin(); beside != beside_.end();) {
        const auto now = beside++;
        if (now->second->ticket != snapshot_->ticket || now->first == snapshot_->integrator) {
            dropped.insert(beside_.extract(now));
        }
    }
}

void PublishedState::showBeside(std::shared_ptr<const FilmSnapshot> snapshot) {
    const std::lock_guard lock(mutex_);
    beside_[snapshot->integrator].swap(snapshot);
}

std::shared_ptr<const FilmSnapshot> PublishedState::snapshot(IntegratorKind integrator) const {
    const std::lock_guard lock(mutex_);
    if (snapshot_ && snapshot_->integrator == integrator) { return snapshot_; }
    const auto found = beside_.find(integrator);
    return found != beside_.end() ? found->second : nullptr;
}

void PublishedState::setBuiltScene(std::shared_ptr<const BuiltScene> scene) {
    const std::lock_guard lock(mutex_);
    builtScene_ = std::move(scene);
}

std::shared_ptr<const BuiltScene> PublishedState::builtScene() const {
    const std::lock_guard lock(mutex_);
    return builtScene_;
}

void PublishedState::setCurve(IntegratorKind integrator, std::shared_ptr<const ConvergenceCurve> curve) {
    const std::lock_guard lock(mutex_);
    curves_[integrator].swap(curve);
}

std::shared_ptr<const ConvergenceCurve> PublishedState::curve(IntegratorKind integrator) const {
    static const auto kEmpty = std::make_shared<const ConvergenceCurve>();
    const std::lock_guard lock(mutex_);
    const auto found = curves_.find(integrator);
    return found != curves_.end() ? found->second : kEmpty;
}

void PublishedState::set(const SessionStatus& status, uint64_t messages) {
    const std::lock_guard lock(mutex_);
    messages_ = messages;
    // First what needs no memory: whoever waits must not do so in vain.
    status_.state = status.state;
    changed_.notify_all();
    status_ = status;
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
