// Signal handlers may touch nothing but lock-free atomics and a few system calls.
#include "viewer/base/interrupt.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <string_view>

#include <unistd.h>

#include "engine/base/console.h"

namespace glint {
namespace {

constexpr std::array<int, 4> kSignals{SIGINT, SIGTERM, SIGHUP, SIGXCPU};

std::atomic<int> raised{0};  ///< the last signal; 0: none
std::atomic<int64_t> raisedNs{0};
std::atomic<int> guards{0};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<int64_t>::is_always_lock_free);

constexpr int64_t kOneWishNs = 300'000'000;

[[noreturn]] void endNow(std::string_view why) {
    [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, why.data(), why.size());
    _exit(kInterruptedExitCode);
}

/// Monotonic; safe within a handler.
int64_t nowNs() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

void onSignal(int signal) {
    const int errorBefore = errno;
    const int64_t now = nowNs();
    const bool isSame = raised.exchange(signal) == signal && (signal == SIGINT || signal == SIGTERM);
    // Who kills a process and its group sends one wish twice: timeout(1) does.
    const bool isRepeated = isSame && now - raisedNs.load() > kOneWishNs;
    if (!isSame) { raisedNs = now; }
    if (guards == 0) { endNow("\ninterrupted\n"); }
    if (isRepeated) { endNow("\nended without saving\n"); }
    errno = errorBefore;
}

sigset_t allSignals() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : kSignals) {
        sigaddset(&set, signal);
    }
    return set;
}

}  // namespace

void holdSignals() {
    const sigset_t set = allSignals();
    sigprocmask(SIG_BLOCK, &set, nullptr);
}

void takeSignals() {
    for (const int signal : kSignals) {
        struct sigaction before = {};
        sigaction(signal, nullptr, &before);
        if (signal == SIGHUP && before.sa_handler == SIG_IGN) { continue; }
        struct sigaction action = {};
        action.sa_handler = onSignal;
        action.sa_flags = SA_RESTART;
        sigaction(signal, &action, nullptr);
    }
    const sigset_t set = allSignals();
    sigprocmask(SIG_UNBLOCK, &set, nullptr);
}

InterruptGuard::InterruptGuard() { ++guards; }

InterruptGuard::~InterruptGuard() { --guards; }

bool InterruptGuard::interrupted() const { return raised != 0; }

bool announceInterruption(const SessionStatus& status) {
    if (status.passes > 0) { return true; }
    if (status.state != SessionState::Rendering) {
        say("interrupted before anything was rendered\n");
        return false;
    }
    say("interrupted in the first pass, which is awaited, so that there is a picture to save; interrupt "
        "again to end without one\n");
    return true;
}

}  // namespace glint
