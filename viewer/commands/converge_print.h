// What `glint converge` says: where it is, while it runs, and a table at the end.
#pragma once

#include <string>

#include "engine/report/convergence_report.h"

namespace glint {

/// One line on standard error: drawn over on a terminal, elsewhere written only where a new part begins.
class PartLine {
  public:
    PartLine();
    void begin(const std::string& part);
    void draw(const std::string& text);
    /// Wipes what was drawn.
    void finish();

  private:
    bool terminal_;
    bool drawn_ = false;
};

/// The table, the reference and the warnings, to standard output.
void printReport(const ConvergenceReport& report);

}  // namespace glint
