// Signal handlers may touch nothing but a lock-free atomic.
#include "viewer/commands/interrupt.h"

#include <atomic>
#include <csignal>

#include <unistd.h>

#include "viewer/commands/commands.h"

namespace glint {
namespace {

std::atomic<bool> raised{false};
static_assert(std::atomic<bool>::is_always_lock_free);
struct sigaction previousInterrupt, previousTerminate;

void onSignal(int) {
    if (raised.exchange(true)) { _exit(kExitInterrupted); }
}

}  // namespace

InterruptGuard::InterruptGuard() {
    raised = false;
    struct sigaction action = {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, &previousInterrupt);
    sigaction(SIGTERM, &action, &previousTerminate);
}

InterruptGuard::~InterruptGuard() {
    sigaction(SIGINT, &previousInterrupt, nullptr);
    sigaction(SIGTERM, &previousTerminate, nullptr);
}

bool InterruptGuard::interrupted() const { return raised; }

}  // namespace glint
