// The folder of a convergence run: refused where it would destroy something, filled at the end.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/report/convergence_report.h"
#include "viewer/base/run_files.h"

namespace glint {

class ConvergeFolder {
  public:
    explicit ConvergeFolder(std::string path) : path_(std::move(path)) {}

    /// Error: it is a file, cannot be made or written to, holds an earlier run's results and `overwrite` is
    /// false, or one of the `files` that are read would be replaced. Makes nothing.
    Status check(bool overwrite, const RunFiles& files) const;
    /// Makes it where it is missing, with the parents.
    Status make() const;
    /// What make() made, when nothing came into it; parents stay.
    void removeIfEmpty() const;

    std::string file(const std::string& name) const;
    std::string reference() const { return file("reference.exr"); }

    /// Pictures (whose names go into `result`), CSV, JSON, plots and the page.
    Status write(const ConvergenceReport& report, ConvergenceResult* result) const;

  private:
    std::string path_;
};

}  // namespace glint
