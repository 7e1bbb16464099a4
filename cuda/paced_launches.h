// Runs a pass's threads in launches of about the same time, so that a raised stop flag is seen soon.
//
// One launch runs while the next one is queued.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>

#include "cuda/chunk_pacer.h"
#include "cuda/device.h"

namespace glint {

inline double secondsNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Runs threads [0, threads) of `kernel` and waits for them; `launch` gets their numbers. False: stopped
/// before all of them had run.
template <class Launch>
Result<bool> runPaced(Device& device, const Kernel<Launch>& kernel, Launch launch, uint32_t threads,
                      const std::atomic<bool>& stop, ChunkPacer* pacer) {
    double lastEnd = secondsNow();
    uint32_t running = 0;
    // The launch before is waited for while the next one already runs.
    const auto waitForRunning = [&](int pending) -> Status {
        if (Status s = device.waitForLaunches(pending); !s) { return s; }
        const double end = secondsNow();
        if (running != 0) { pacer->measured(running, end - std::exchange(lastEnd, end)); }
        return {};
    };
    launch.first = 0;
    while (launch.first < threads && !stop.load(std::memory_order_relaxed)) {
        launch.count = std::min(pacer->threads(), threads - launch.first);
        if (Status s = device.launch(kernel, launch); !s) { return s.error(); }
        if (Status s = waitForRunning(1); !s) { return s.error(); }
        running = launch.count;
        launch.first += launch.count;
    }
    if (Status s = waitForRunning(0); !s) { return s.error(); }
    return launch.first >= threads;
}

/// Runs threads [0, threads) of `kernel` in one launch, which is started and not waited for.
template <class Launch>
Status runAtOnce(Device& device, const Kernel<Launch>& kernel, Launch launch, uint32_t threads) {
    launch.first = 0;
    launch.count = threads;
    return threads == 0 ? Status{} : device.launch(kernel, launch);
}

}  // namespace glint
