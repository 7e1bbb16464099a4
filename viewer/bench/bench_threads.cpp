// `glint bench threads`: passes per second with one thread beside more, by turns in one run, so that a
// machine that slows down slows both. Medians over the turns.
#include <fmt/format.h>

#include "viewer/bench/bench.h"
#include "viewer/bench/bench_pairs.h"
#include "viewer/bench/bench_path_passes.h"
#include "viewer/bench/bench_scenes.h"
#include "viewer/bench/bench_statistics.h"

namespace glint {
namespace {

Result<std::shared_ptr<SceneDescription>> threadsScene(const BenchOptions& options) {
    return benchCornell(options.size, options.size);
}

Result<BenchReport> measureThreads(const BenchSubject& subject) {
    const BenchOptions& options = subject.options;
    PathPasses one(subject, 1), many(subject, options.threads);
    for (const PathPasses* passes : {&one, &many}) {
        if (!passes->status()) { return passes->status().error(); }
    }
    const PairTimes times = measureByTurns(
        options.turns, [&](uint32_t turn) { return one.render(turn); },
        [&](uint32_t turn) { return many.render(turn); });
    const double oneSeconds = percentilesOf(times.first).median;
    const double manySeconds = percentilesOf(times.second).median;
    const RatioInterval ratio = ratioOf(times.first, times.second);
    const bool same = compareImages(one.film(), many.film()).identical();
    return BenchReport{
        .text = fmt::format(
            "1 thread   {:.2f} passes/s\n{} threads  {:.2f} passes/s\nratio      {}\nfilms are {}\n",
            1.0 / oneSeconds, options.threads, 1.0 / manySeconds, ratioText(ratio),
            same ? "identical" : "DIFFERENT"),
        .json = {{"size", options.size},
                 {"threads", options.threads},
                 {"turns", options.turns},
                 {"one_passes_per_s", 1.0 / oneSeconds},
                 {"many_passes_per_s", 1.0 / manySeconds},
                 {"ratio", ratio.median},
                 {"ratio_low", ratio.low},
                 {"ratio_high", ratio.high},
                 {"films_identical", same}},
        .isWrong = !same};
}

}  // namespace

Benchmark threadsBenchmark() {
    return {.name = "threads",
            .about = "One thread beside all of them, on the Cornell box",
            .defaults = {.size = 512, .turns = 9},
            .options = {threadsOption("Beside one; all by default", 2), turnsOption("Passes of each"),
                        sizeOption("Picture width and height")},
            .scene = threadsScene,
            .measure = measureThreads};
}

}  // namespace glint
