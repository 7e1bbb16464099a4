// `glint bench paths`: camera paths and rays per second of the path tracer, by default on a small Cornell box
// where nothing but the kernels counts. Whole passes, film included, after one that warms up; the median over
// passes and the fastest.
#include <algorithm>
#include <atomic>
#include <chrono>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/base/parallel.h"
#include "engine/builders/scene_builder.h"
#include "engine/io/scene_loader.h"
#include "engine/render/backend.h"
#include "engine/render/cpu_variants.h"
#include "engine/render/pass_params.h"
#include "viewer/commands/bench_scenes.h"
#include "viewer/commands/bench_statistics.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/json_output.h"

namespace glint {
namespace {

struct PathsOptions {
    std::string scene;
    int threads = 0;
    int passes = 16;
    int size = 512;
    std::string json;
};

struct PathsResult {
    Percentiles passSeconds;
    double fastestPassSeconds = 0.0;
    double paths = 0.0;  ///< a pass
    double rays = 0.0;   ///< a pass, on average
    double relativeError = 0.0;
};

Result<std::shared_ptr<const SceneDescription>> sceneOf(const PathsOptions& options) {
    if (options.scene.empty()) {
        return std::shared_ptr<const SceneDescription>(benchCornell(options.size, options.size));
    }
    Result<SceneDescription> loaded = loadScene(options.scene, {});
    if (!loaded) { return loaded.error(); }
    return std::shared_ptr<const SceneDescription>(std::make_shared<SceneDescription>(std::move(*loaded)));
}

PathsResult measure(const SceneDescription& scene, Backend& backend, const PathsOptions& options) {
    const std::atomic<bool> never{false};
    PassParams params = passParamsOf(scene);
    Film film(params.width, params.height);
    std::vector<PixelSample> samples;
    std::vector<double> seconds;
    for (int pass = 0; pass <= options.passes; ++pass) {
        params.pass = static_cast<uint32_t>(pass);
        const auto began = std::chrono::steady_clock::now();
        (void)backend.renderPass(params, never, &samples);
        film.commit(samples, params.pass, options.threads);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
        if (pass > 0) { seconds.push_back(took.count()); }
    }
    PathsResult result;
    result.fastestPassSeconds = *std::min_element(seconds.begin(), seconds.end());
    result.passSeconds = percentilesOf(std::move(seconds));
    result.paths = static_cast<double>(params.width) * static_cast<double>(params.height);
    result.rays = static_cast<double>(film.rays()) / static_cast<double>(film.passes());
    result.relativeError = film.relativeErrorEstimate();
    return result;
}

Status report(const PathsOptions& options, const PathsResult& r, int threads, const char* kernel) {
    const double seconds = r.passSeconds.median;
    const double raySeconds = seconds * threads / r.rays;
    if (!jsonTakesOutput(options.json)) {
        fmt::print("kernel          {}\nthreads         {}\n", kernel, threads);
        fmt::print("camera paths    {:.3f} M/s (fastest pass {:.3f})\n", r.paths / seconds * 1e-6,
                   r.paths / r.fastestPassSeconds * 1e-6);
        fmt::print("rays            {:.3f} M/s, {:.2f} a path\n", r.rays / seconds * 1e-6, r.rays / r.paths);
        fmt::print("one ray         {:.1f} ns of one thread, shading included\n", raySeconds * 1e9);
        fmt::print("relative error  {:.4f} after {} passes\n", r.relativeError, options.passes + 1);
    }
    return writeJson(options.json, {{"scene", options.scene.empty() ? "cornell" : options.scene},
                                    {"kernel", kernel},
                                    {"threads", threads},
                                    {"passes", options.passes},
                                    {"paths_per_pass", r.paths},
                                    {"mpaths_per_s", r.paths / seconds * 1e-6},
                                    {"mpaths_per_s_fastest", r.paths / r.fastestPassSeconds * 1e-6},
                                    {"mrays_per_s", r.rays / seconds * 1e-6},
                                    {"rays_per_path", r.rays / r.paths},
                                    {"ns_per_ray_and_thread", raySeconds * 1e9},
                                    {"relative_error", r.relativeError}});
}

int runPaths(const PathsOptions& options) {
    const auto scene = sceneOf(options);
    if (!scene) { return reportError(scene.error(), kExitBadInput); }
    const int threads = options.threads > 0 ? options.threads : defaultThreadCount();
    const auto built = buildScene({*scene, EditKind::Everything}, nullptr, threads, nullptr, nullptr);
    if (!built) { return reportError(built.error(), kExitBadInput); }
    const auto backend = makeCpuBackend(threads);
    const Status set = backend->setScene(*built);
    if (!set) { return reportError(set.error(), kExitFailed); }
    const PathsResult result = measure(**scene, *backend, options);
    const Status written = report(options, result, threads, chooseVariant((*built)->features).name);
    return written ? kExitDone : reportError(written.error(), kExitFailed);
}

}  // namespace

void addBenchPaths(CLI::App& bench, int* exitCode) {
    CLI::App* command =
        bench.add_subcommand("paths", "Camera paths and rays per second, on a Cornell box or a scene");
    const auto options = std::make_shared<PathsOptions>();
    command->add_option("scene", options->scene, "A scene file at its own size; a Cornell box by default");
    command->add_option("--threads", options->threads, "All by default")->check(CLI::Range(1, 1024));
    command->add_option("--passes", options->passes, "Measured passes")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->add_option("--size", options->size, "The Cornell box's width and height")
        ->check(CLI::Range(16, 8192))
        ->capture_default_str();
    addJsonOption(*command, &options->json);
    command->callback([options, exitCode] { *exitCode = runPaths(*options); });
}

}  // namespace glint
