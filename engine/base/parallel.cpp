// OpenMP behind a function, so that callers need no pragmas.
#include "engine/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>

#include <omp.h>

#include "engine/base/thread_limit.h"

namespace glint {

int defaultThreadCount() { return std::max(1, omp_get_max_threads()); }

void parallelChunks(int64_t count, int64_t chunkSize, int threads,
                    const std::function<void(int64_t begin, int64_t end)>& body) {
    const int64_t size = std::max<int64_t>(1, chunkSize);
    const int64_t chunks = (count + size - 1) / size;
    const int used = chunks > 1 ? startableThreads(threads) : 1;
    if (used == 1) {  // a team of one, too, takes memory, without which the OpenMP library ends the program
        for (int64_t chunk = 0; chunk < chunks; ++chunk) {
            body(chunk * size, std::min(count, (chunk + 1) * size));
        }
        return;
    }
    std::atomic<bool> hasFailed{false};
    std::exception_ptr problem;
#pragma omp parallel for schedule(dynamic, 1) num_threads(used)
    for (int64_t chunk = 0; chunk < chunks; ++chunk) {
        if (hasFailed.load(std::memory_order_relaxed)) { continue; }
        // No exception may leave the region: there is nobody to catch it.
        try {
            body(chunk * size, std::min(count, (chunk + 1) * size));
        } catch (...) {
            if (!hasFailed.exchange(true)) { problem = std::current_exception(); }
        }
    }
    if (problem) { std::rethrow_exception(problem); }
}

}  // namespace glint
