// How long frames take, by part, so that our own code's time is told apart from software drawing's; and what
// the window was left at.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/render/render_session.h"
#include "engine/scene/camera.h"

namespace glint {

struct FrameTimes {
    double uiMs = 0.0;      ///< input, panels and edits
    double uploadMs = 0.0;  ///< a new picture to the graphics card and its tone mapping
    double drawMs = 0.0;    ///< ImGui's draw lists and the swap: all drawing when OpenGL is software
    /// how much later than asked the loop woke up: the scheduler, with all cores rendering
    double wakeMs = 0.0;
};

class FrameStats {
  public:
    void add(const FrameTimes& times) { frames_.push_back(times); }
    size_t count() const { return frames_.size(); }
    /// FrameTimes::uiMs of each frame, in seconds.
    std::vector<double> uiSeconds() const;
    /// {"frames": n, "ui_ms": {"p50", "p95", "p99", "max"}, "upload_ms", "draw_ms", "wake_ms",
    /// "frame_ms_without_drawing", "over_60hz_without_drawing": how many frames took more than 1/60 s,
    /// "session": {"state", "integrator", "passes", "restarts", "preview_passes", "last_edit_ms",
    /// "last_cancel_ms"}, "camera": {"position", "target"}}
    std::string json(const SessionStatus& session, const Camera& camera) const;

  private:
    std::vector<FrameTimes> frames_;
};

/// "rendering", "paused", …: as scripts and reports write it.
const char* stateName(SessionState state);

}  // namespace glint
