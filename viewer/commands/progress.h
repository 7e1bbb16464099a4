// A render's progress: one line that is drawn over on a terminal, plain lines now and then elsewhere.
#pragma once

#include <string>

#include "engine/render/render_session.h"

namespace glint {

/// How much is done, in [0, 1], and how many seconds are left, by the limit that will be reached first.
/// secondsLeft is negative while it cannot be known.
struct Forecast {
    double fraction = 0.0;
    double secondsLeft = -1.0;
};
Forecast forecast(const SessionStatus& status, const StopLimits& limits);

/// "1:05", "2:03:00"; "?" for a negative time.
std::string formatSeconds(double seconds);

class ProgressLine {
  public:
    /// Writes to standard error.
    ProgressLine();
    void update(const SessionStatus& status, const StopLimits& limits);
    /// Ends the drawn line, so that what follows starts on its own.
    void finish();

  private:
    bool terminal_;
    bool drawn_ = false;
    double lastFraction_ = -1.0;
    double lastSeconds_ = 0.0;
};

}  // namespace glint
