// `glint bench paths`: camera paths and rays per second of the path tracer, by default on a small Cornell box
// where nothing but the kernels counts. Whole passes, film included, after one that warms up; the median over
// passes and the fastest.
#include <algorithm>

#include <fmt/format.h>

#include "engine/render/cpu_variants.h"
#include "viewer/bench/bench.h"
#include "viewer/bench/bench_path_passes.h"
#include "viewer/bench/bench_scenes.h"
#include "viewer/bench/bench_statistics.h"

namespace glint {
namespace {

Result<std::shared_ptr<SceneDescription>> pathsScene(const BenchOptions& options) {
    if (!options.scene.empty()) { return benchFile(options.scene); }
    return benchCornell(options.size, options.size);
}

Result<BenchReport> measurePaths(const BenchSubject& subject) {
    const BenchOptions& options = subject.options;
    PathPasses passes(subject, options.threads);
    if (!passes.status()) { return passes.status().error(); }
    std::vector<double> times;
    for (int pass = 0; pass <= options.passes; ++pass) {
        const double seconds = passes.render(static_cast<uint32_t>(pass));
        if (pass > 0) { times.push_back(seconds); }
    }
    const Film& film = passes.film();
    const SamplerKind sampler = subject.scene->options.sampler;
    const char* kernel = chooseVariant(kernelVariants(), subject.built->features, sampler).name;
    const double fastest = *std::ranges::min_element(times);
    const double seconds = percentilesOf(std::move(times)).median;
    const double paths = static_cast<double>(film.width()) * static_cast<double>(film.height());
    const double rays = static_cast<double>(film.rays()) / static_cast<double>(film.passes());
    const double raySeconds = seconds * options.threads / rays;
    const double relativeError = film.relativeErrorEstimate();
    BenchReport report;
    report.text =
        fmt::format("kernel          {}\nthreads         {}\n", kernel, options.threads) +
        fmt::format("camera paths    {:.3f} M/s (fastest pass {:.3f})\n", paths / seconds * 1e-6,
                    paths / fastest * 1e-6) +
        fmt::format("rays            {:.3f} M/s, {:.2f} a path\n", rays / seconds * 1e-6, rays / paths) +
        fmt::format("one ray         {:.1f} ns of one thread, shading included\n", raySeconds * 1e9) +
        fmt::format("relative error  {:.4f} after {} passes\n", relativeError, options.passes + 1);
    report.json = {{"scene", options.scene.empty() ? "cornell" : options.scene},
                   {"kernel", kernel},
                   {"threads", options.threads},
                   {"passes", options.passes},
                   {"paths_per_pass", paths},
                   {"mpaths_per_s", paths / seconds * 1e-6},
                   {"mpaths_per_s_fastest", paths / fastest * 1e-6},
                   {"mrays_per_s", rays / seconds * 1e-6},
                   {"rays_per_path", rays / paths},
                   {"ns_per_ray_and_thread", raySeconds * 1e9},
                   {"relative_error", relativeError}};
    return report;
}

}  // namespace

Benchmark pathsBenchmark() {
    return {
        .name = "paths",
        .about = "Camera paths and rays per second, on a Cornell box or a scene",
        .defaults = {.size = 512, .passes = 16},
        .options = {{"scene", &BenchOptions::scene, "A scene file at its own size; a Cornell box by default"},
                    threadsOption(),
                    passesOption(),
                    sizeOption("The Cornell box's width and height")},
        .scene = pathsScene,
        .measure = measurePaths};
}

}  // namespace glint
