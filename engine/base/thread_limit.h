// How many threads the system lets the OpenMP library start.
#pragma once

namespace glint {

/// Of `threads` (0: all), how many the caller's next parallel region may have: as many as start now, by the
/// limits of memory and of threads. Warns once where they are fewer. Every region asks.
int startableThreads(int threads);

}  // namespace glint
