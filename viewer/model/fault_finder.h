// Looks up the first sample that the render dropped, and makes the command line that replays its path.
#pragma once

#include <string>

#include "viewer/base/job_queue.h"
#include "viewer/model/render_control.h"

namespace glint {

class FaultFinder {
  public:
    FaultFinder(JobQueue* jobs, RenderControl* render) : jobs_(jobs), render_(render) {}

    /// In the background.
    void find();
    /// "" before one is found.
    const std::string& replayCommand() const { return replayCommand_; }
    /// The scene has changed.
    void forget() { replayCommand_.clear(); }

  private:
    JobQueue* jobs_;
    RenderControl* render_;
    std::string replayCommand_;
};

}  // namespace glint
