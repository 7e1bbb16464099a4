// How long the window's own work of a frame takes beside a full render, with thousands of objects in
// its outliner.
#pragma once

#include "engine/base/result.h"
#include "viewer/bench/bench_statistics.h"

namespace glint {

/// Plays a script headless on a scene of so many spheres that renders on `threads` threads: the outliner is
/// scrolled, its rows are chosen, searched for, and a sphere is moved. Of all frames, input, panels and
/// edits; drawing is not in it. Error: the program has no window, or its script failed.
Result<Percentiles> measureWindow(int objects, int threads);

}  // namespace glint
