// What the render thread shows to the controlling thread: the newest picture and the status. Thread-safe.
#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>

#include "engine/render/render_session.h"

namespace glint {

class PublishedState {
  public:
    void show(std::shared_ptr<const FilmSnapshot> snapshot);
    /// `messages`: everything asked for up to Commands::messages has been taken into account.
    void set(const SessionStatus& status, uint64_t messages);

    /// The picture of an integrator beside the one that is shown; dropped with the first picture of
    /// another edit.
    void showBeside(std::shared_ptr<const FilmSnapshot> snapshot);

    void setBuiltScene(std::shared_ptr<const BuiltScene> scene);
    std::shared_ptr<const BuiltScene> builtScene() const;

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
    std::map<IntegratorKind, std::shared_ptr<const FilmSnapshot>> beside_;
    std::map<IntegratorKind, std::shared_ptr<const ConvergenceCurve>> curves_;
    std::shared_ptr<const BuiltScene> builtScene_;
    SessionStatus status_;
    uint64_t messages_ = 0;
};

}  // namespace glint
