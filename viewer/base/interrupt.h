// Signals that ask the program to end, as a request: Ctrl-C, a terminal that closes, a scheduler,
// a limit of processor time. A command that has something to lose looks for it, saves, and ends
// with kInterruptedExitCode.
#pragma once

#include "engine/render/session_status.h"

namespace glint {

constexpr int kInterruptedExitCode = 130;

/// Holds SIGINT, SIGTERM, SIGHUP and SIGXCPU back until takeSignals(), also through exec(). The one function
/// here that may be called before main().
void holdSignals();

/// To be called first in the program: from now on those signals end it with kInterruptedExitCode and a line
/// on standard error, unless an InterruptGuard lives. SIGHUP stays ignored where it was (nohup).
void takeSignals();

/// While one lives, signals only raise a flag; the same SIGINT or SIGTERM once more ends the program at once.
/// (A closing terminal repeats SIGHUP by itself, and the kernel SIGXCPU.)
class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    bool interrupted() const;
};

/// Tells the user what becomes of an interrupted render, before it is saved. False: nothing is rendered, and
/// nothing will be soon.
bool announceInterruption(const SessionStatus& status);

}  // namespace glint
