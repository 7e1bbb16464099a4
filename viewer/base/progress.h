// A render's progress: one line that is drawn over on a terminal, plain lines now and then elsewhere.
#pragma once

#include <string>

#include "engine/render/render_session.h"

namespace glint {

/// How much is done, in [0, 1], and how many seconds are left, by the limit that will be reached first.
/// secondsLeft is negative while it cannot be known. How fast the error falls is measured, not assumed
/// (convergence_curve.h), so that a time to `--error` has a range, whose upper end may be infinite.
struct Forecast {
    double fraction = 0.0;
    double secondsLeft = -1.0;
    double secondsLow = -1.0;  ///< 90 % band of secondsLeft; of limits other than the error the same
    double secondsHigh = -1.0;
};
Forecast forecast(const SessionStatus& status, const StopLimits& limits, const ConvergenceCurve& curve);

/// "1:05", "1:05 to 2:10", "more than 1:05", "?".
std::string describeTimeLeft(const Forecast& ahead);

/// "1:05", "2:03:00"; "?" for a negative time.
std::string formatSeconds(double seconds);

class ProgressLine {
  public:
    /// Writes to standard error.
    ProgressLine();
    void update(const SessionStatus& status, const StopLimits& limits, const ConvergenceCurve& curve = {});
    /// Ends the drawn line, so that what follows starts on its own.
    void finish();

  private:
    bool terminal_;
    bool drawn_ = false;
    double lastFraction_ = -1.0;
    double lastSeconds_ = 0.0;
};

}  // namespace glint
