// The Convergence panel's curves as a table in a file, written in the background.
#pragma once

#include <string>

#include "viewer/base/job_queue.h"
#include "viewer/base/run_files.h"
#include "viewer/model/convergence_watch.h"
#include "viewer/model/notice.h"
#include "viewer/model/overwrite_guard.h"

namespace glint {

class CurveExport {
  public:
    /// `notice` is told as well as the export's own.
    CurveExport(JobQueue* jobs, Notice* notice, const RunFiles* inputs, OverwriteGuard* guard)
        : jobs_(jobs), notice_(notice), inputs_(inputs), guard_(guard) {}

    std::string path = "convergence.csv";
    void save(const ConvergenceWatch& convergence);
    /// How the last one ended.
    const Notice& result() const { return result_; }

  private:
    void start(const std::string& csv);

    JobQueue* jobs_;
    Notice* notice_;
    const RunFiles* inputs_;
    OverwriteGuard* guard_;
    Notice result_;
};

}  // namespace glint
