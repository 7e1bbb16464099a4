// Data-parallel loops on the render threads. The one place outside the CPU backend that names OpenMP.
//
// The body receives indices in no particular order, so results may not depend on it.
#pragma once

#include <cstdint>
#include <functional>

namespace glint {

/// Calls body(begin, end) over disjoint chunks of [0, count) of about `chunkSize`, on `threads` threads
/// (0: all). What the body throws is thrown here when all threads are done; chunks that had not begun are
/// left out then.
void parallelChunks(int64_t count, int64_t chunkSize, int threads,
                    const std::function<void(int64_t begin, int64_t end)>& body);

/// The number of threads that 0 stands for: what the machine offers, or OMP_NUM_THREADS.
int defaultThreadCount();

}  // namespace glint
