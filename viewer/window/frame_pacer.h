// When the window draws, and how long its loop sleeps: 60 frames a second for a while after input, then as
// few as what happens needs, so that drawing takes no time from the renderer.
#pragma once

#include <chrono>

namespace glint {

class FramePacer {
  public:
    using Clock = std::chrono::steady_clock;

    /// `everyFrame`: scripts and measurements want frames whatever happens.
    explicit FramePacer(bool everyFrame) : everyFrame_(everyFrame) {}

    void noteInput() {
        lastInput_ = Clock::now();
        framesSinceInput_ = 0;
    }
    void noteEdit() { lastEdit_ = Clock::now(); }
    void noteDrawn() {
        lastDrawn_ = Clock::now();
        ++framesSinceInput_;
    }

    /// What was input may still have its effects.
    bool isLively() const;
    /// What is held has not moved for a while: the image may refine.
    bool motionHasEnded() const;
    /// `hasNews`: there is something new to be seen. `isBusy`: figures change, if no more.
    bool worthDrawing(bool hasNews, bool isBusy) const;
    /// Seconds until the loop should look again. `isIdle`: nothing will change by itself.
    double pause(bool isIdle) const;

  private:
    bool everyFrame_;
    int framesSinceInput_ = 0;
    Clock::time_point lastInput_ = Clock::now();
    Clock::time_point lastEdit_ = Clock::now();
    Clock::time_point lastDrawn_{};
};

}  // namespace glint
