// `glint bench threads`: passes per second with one thread beside more, by turns in one run, so that a
// machine that slows down slows both. Medians over the turns.
#include <chrono>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/base/parallel.h"
#include "engine/builders/scene_builder.h"
#include "engine/render/backend.h"
#include "engine/render/pass_params.h"
#include "viewer/commands/bench_pairs.h"
#include "viewer/commands/bench_scenes.h"
#include "viewer/commands/bench_statistics.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/json_output.h"

namespace glint {
namespace {

struct ThreadsOptions {
    int threads = 0;
    int turns = 9;
    int size = 512;
    std::string json;
};

/// Seconds of one pass and its commit.
double passSeconds(Backend& backend, const PassParams& params, Film* film, int threads) {
    static const std::atomic<bool> never{false};
    std::vector<PixelSample> samples;
    const auto began = std::chrono::steady_clock::now();
    (void)backend.renderPass(params, never, &samples);
    film->commit(samples, params.pass, threads);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

int runThreads(const ThreadsOptions& options) {
    const int many = options.threads > 0 ? options.threads : defaultThreadCount();
    const auto scene = benchCornell(options.size, options.size);
    const auto built = buildScene({scene, EditKind::Everything}, nullptr, many, nullptr, nullptr);
    if (!built) {
        fmt::print(stderr, "error: {}\n", built.error().format());
        return kExitFailed;
    }
    const auto single = makeCpuBackend(1), parallel = makeCpuBackend(many);
    (void)single->setScene(*built);
    (void)parallel->setScene(*built);
    Film filmOne(options.size, options.size), filmMany(options.size, options.size);
    PassParams params = passParamsOf(*scene);
    const auto passOf = [&](Backend& backend, Film* film, int threads) {
        return [&, film, threads](uint32_t turn) {
            params.pass = turn;
            return passSeconds(backend, params, film, threads);
        };
    };
    const PairTimes times =
        measureByTurns(options.turns, passOf(*single, &filmOne, 1), passOf(*parallel, &filmMany, many));
    const double oneSeconds = percentilesOf(times.first).median;
    const double manySeconds = percentilesOf(times.second).median;
    const RatioInterval ratio = ratioOf(times.first, times.second);
    const bool same = compareImages(filmOne, filmMany).identical();
    if (!jsonTakesOutput(options.json)) {
        fmt::print("1 thread   {:.2f} passes/s\n{} threads  {:.2f} passes/s\nratio      {}\nfilms are {}\n",
                   1.0 / oneSeconds, many, 1.0 / manySeconds, ratioText(ratio),
                   same ? "identical" : "DIFFERENT");
    }
    const Status written = writeJson(options.json, {{"size", options.size},
                                                    {"threads", many},
                                                    {"turns", options.turns},
                                                    {"one_passes_per_s", 1.0 / oneSeconds},
                                                    {"many_passes_per_s", 1.0 / manySeconds},
                                                    {"ratio", ratio.median},
                                                    {"ratio_low", ratio.low},
                                                    {"ratio_high", ratio.high},
                                                    {"films_identical", same}});
    if (!written) { fmt::print(stderr, "error: {}\n", written.error().format()); }
    return same && written ? kExitDone : kExitFailed;
}

}  // namespace

void addBenchThreads(CLI::App& bench, int* exitCode) {
    CLI::App* command = bench.add_subcommand("threads", "One thread beside all of them, on the Cornell box");
    const auto options = std::make_shared<ThreadsOptions>();
    command->add_option("--threads", options->threads, "Beside one; all by default")
        ->check(CLI::Range(2, 1024));
    command->add_option("--turns", options->turns, "Passes of each")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--size", options->size, "Picture width and height")
        ->check(CLI::Range(16, 8192))
        ->capture_default_str();
    addJsonOption(*command, &options->json);
    command->callback([options, exitCode] { *exitCode = runThreads(*options); });
}

}  // namespace glint
