#include "viewer/window/frame_pacer.h"

namespace glint {
namespace {

constexpr double kFrameSeconds = 1.0 / 60.0;
constexpr double kQuietFrameSeconds = 0.1;  // while it renders and nobody touches anything
constexpr double kIdleFrameSeconds = 0.5;   // while nothing happens at all
constexpr double kLivelySeconds = 0.5;      // 60 Hz for so long after input
constexpr int kLivelyFrames = 8;            // a widget takes up to three to act on a click
constexpr double kMotionEndSeconds = 0.12;

double since(FramePacer::Clock::time_point then) {
    return std::chrono::duration<double>(FramePacer::Clock::now() - then).count();
}

}  // namespace

bool FramePacer::isLively() const {
    return framesSinceInput_ < kLivelyFrames || since(lastInput_) < kLivelySeconds;
}

bool FramePacer::motionHasEnded() const { return since(lastEdit_) > kMotionEndSeconds; }

bool FramePacer::worthDrawing(bool hasNews, bool isBusy) const {
    if (everyFrame_ || hasNews || since(lastInput_) < kLivelySeconds) { return true; }
    return since(lastDrawn_) >= (isBusy ? kQuietFrameSeconds : kIdleFrameSeconds);
}

double FramePacer::pause(bool isIdle) const {
    if (isIdle && !everyFrame_ && since(lastInput_) >= kLivelySeconds) { return kIdleFrameSeconds; }
    // A loop that had nothing to draw sleeps as well: without that it would take a core from the renderer.
    const double sinceDrawn = since(lastDrawn_);
    return sinceDrawn < kFrameSeconds ? kFrameSeconds - sinceDrawn : kFrameSeconds;
}

}  // namespace glint
