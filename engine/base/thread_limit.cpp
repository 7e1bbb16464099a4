// The OpenMP library ends the program where one of its threads does not start, so as many are started, and
// ended, before it starts its own; their stacks are kept by the C library and wait for it.
#include "engine/base/thread_limit.h"

#include <algorithm>
#include <array>
#include <atomic>

#include <omp.h>
#include <pthread.h>

#include "engine/base/log.h"
#include "engine/base/parallel.h"

namespace glint {
namespace {

constexpr int kMostThreads = 1024;

/// How many of `count` threads start while the others live. Allocates nothing.
int tryThreads(int count) {
    std::array<pthread_t, kMostThreads> threads{};
    std::atomic<bool> mayEnd{false};
    const auto wait = [](void* end) -> void* {
        static_cast<std::atomic<bool>*>(end)->wait(false);
        return nullptr;
    };
    size_t started = 0;
    const size_t most = std::min(static_cast<size_t>(count), threads.size());
    while (started < most && pthread_create(&threads[started], nullptr, wait, &mayEnd) == 0) {
        ++started;
    }
    mayEnd = true;
    mayEnd.notify_all();
    std::for_each_n(threads.begin(), started, [](pthread_t thread) { pthread_join(thread, nullptr); });
    return static_cast<int>(started);
}

int tryTeam(int size) {
    // The first leaves room for one of the program's own, such as a session's. More would take memory
    // for nothing.
    static std::atomic<int> spare{1};
    const int spared = spare.exchange(0);
    const int team = std::clamp(1 + tryThreads(size - 1 + spared) - spared, 1, size);
    static std::atomic<bool> isSaid{false};
    if (team < size && !isSaid.exchange(true)) {
        logWarning("{} of {} threads start; memory or their number is limited", team, size);
    }
    return team;
}

}  // namespace

int startableThreads(int threads) {
    const int asked = threads > 0 ? threads : defaultThreadCount();
    if (asked == 1 || omp_get_active_level() >= omp_get_max_active_levels()) { return 1; }
    thread_local int lastAsked = 1;
    thread_local int team = 1;  // that the OpenMP library keeps for this thread, until it is to be smaller
    if (asked != lastAsked) {
        team = asked <= team ? asked : tryTeam(asked);
        lastAsked = asked;
    }
    return team;
}

}  // namespace glint
