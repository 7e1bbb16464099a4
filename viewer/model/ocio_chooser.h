// Reads OpenColorIO configurations for the display, by jobs: large ones take a while.
#pragma once

#include <memory>
#include <string>

#include "viewer/base/job_queue.h"
#include "viewer/model/display_settings.h"
#include "viewer/model/notice.h"

namespace glint {

class OcioChooser {
  public:
    OcioChooser(JobQueue* jobs, DisplaySettings* display, Notice* notice)
        : jobs_(jobs), display_(display), notice_(notice) {}

    std::string config;     ///< the file that is asked for next
    bool isWanted = false;  ///< a configuration is to be chosen, though none is shown yet

    /// Shows that view as soon as it is read, or says why it cannot. Of several, the last counts.
    void load(const OcioChoice& choice);
    void use(const std::shared_ptr<const OcioView>& view);
    /// Something else was chosen: what is being read is shown no more.
    void giveUp();
    bool isLoading() const { return isLoading_; }

  private:
    JobQueue* jobs_;
    DisplaySettings* display_;
    Notice* notice_;
    bool isLoading_ = false;
    int asked_ = 0;
};

}  // namespace glint
