// `glint bench rays` on the command line.
#include "viewer/bench/bench.h"
#include "viewer/bench/bench_rays.h"

namespace glint {
namespace {

Result<BenchReport> measureRaySpeeds(const BenchSubject& subject) {
    const BenchOptions& options = subject.options;
    const auto report = measureRays({.generator = options.mesh,
                                     .triangles = options.triangles,
                                     .width = options.size,
                                     .turns = options.turns,
                                     .threads = options.threads});
    if (!report) { return report.error(); }
    return BenchReport{benchRaysText(*report), benchRaysJson(*report)};
}

}  // namespace

Benchmark raysBenchmark() {
    const BenchRaysOptions defaults;
    return {.name = "rays",
            .about = "Rays per second on a generated mesh, beside Embree's",
            .defaults = {.mesh = defaults.generator,
                         .size = defaults.width,
                         .turns = defaults.turns,
                         .triangles = defaults.triangles},
            .options = {{"--mesh", &BenchOptions::mesh, "A closed generated mesh around the origin"},
                        {"--triangles", &BenchOptions::triangles, "About how many"},
                        {"--size", &BenchOptions::size, "Primary rays are the square of this", 1, 8192},
                        turnsOption("Measurements of each; the median counts"),
                        threadsOption()},
            .scene = nullptr,
            .measure = measureRaySpeeds,
            .onError = kExitBadInput};
}

}  // namespace glint
