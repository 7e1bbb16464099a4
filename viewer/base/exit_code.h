// What the program answers the shell with.
#pragma once

#include "viewer/base/interrupt.h"

namespace glint {

enum ExitCode : int {
    kExitDone = 0,
    kExitBadInput = 1,     ///< the input or the options are wrong
    kExitFailed = 2,       ///< the run failed: disk full, no context, device lost
    kExitBeyondLimit = 3,  ///< done, and what was measured is beyond a limit that was asked for
    kExitInterrupted = kInterruptedExitCode,  ///< by Ctrl-C or another signal, after saving
};

}  // namespace glint
