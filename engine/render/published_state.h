// What the render thread shows to the controlling thread: the newest picture and the status. Thread-safe.
#pragma once

#include <array>
#include <condition_variable>
#include <memory>
#include <mutex>

#include "engine/render/render_session.h"

namespace glint {

class PublishedState {
  public:
    void show(std::shared_ptr<const FilmSnapshot> snapshot);
    /// `messages`: everything asked for up to Commands::messages has been taken into account.
    void set(const SessionStatus& status, uint64_t messages);

    /// The picture of the integrator that is not shown; dropped with the first picture of another edit.
    void showOther(std::shared_ptr<const FilmSnapshot> snapshot);

    void setCurve(IntegratorKind integrator, std::shared_ptr<const ConvergenceCurve> curve);
    /// Never null.
    std::shared_ptr<const ConvergenceCurve> curve(IntegratorKind integrator) const;

    std::shared_ptr<const FilmSnapshot> snapshot() const;
    std::shared_ptr<const FilmSnapshot> snapshot(IntegratorKind integrator) const;
    SessionStatus status() const;
    /// Blocks until the state is a resting one with at least `messages` taken into account, or `seconds`
    /// have passed.
    SessionState wait(uint64_t messages, double seconds) const;

  private:
    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::shared_ptr<const FilmSnapshot> snapshot_;
    std::shared_ptr<const FilmSnapshot> other_;
    std::array<std::shared_ptr<const ConvergenceCurve>, 2> curves_{
        std::make_shared<const ConvergenceCurve>(), std::make_shared<const ConvergenceCurve>()};
    SessionStatus status_;
    uint64_t messages_ = 0;
};

}  // namespace glint
