// Ctrl-C as a request: a command looks for it, saves, and ends with kExitInterrupted.
#pragma once

namespace glint {

/// While one lives, the first SIGINT or SIGTERM only raises a flag; a second one ends the program at once.
class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    bool interrupted() const;
};

}  // namespace glint
