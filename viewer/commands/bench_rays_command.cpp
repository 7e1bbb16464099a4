// `glint bench rays` on the command line.
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "viewer/commands/bench_rays.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/json_output.h"

namespace glint {
namespace {

int runRays(const BenchRaysOptions& options, const std::string& json) {
    const auto report = measureRays(options);
    if (!report) {
        fmt::print(stderr, "error: {}\n", report.error().format());
        return kExitBadInput;
    }
    if (!jsonTakesOutput(json)) { fmt::print("{}", benchRaysText(*report)); }
    const Status written = writeJson(json, benchRaysJson(*report));
    if (written) { return kExitDone; }
    fmt::print(stderr, "error: {}\n", written.error().format());
    return kExitFailed;
}

}  // namespace

void addBenchRays(CLI::App& bench, int* exitCode) {
    CLI::App* command = bench.add_subcommand("rays", "Rays per second on a generated mesh, beside Embree's");
    const auto options = std::make_shared<BenchRaysOptions>();
    const auto json = std::make_shared<std::string>();
    command->add_option("--mesh", options->generator, "A closed generated mesh around the origin")
        ->capture_default_str();
    command->add_option("--triangles", options->triangles, "About how many")->capture_default_str();
    command->add_option("--size", options->width, "Primary rays are the square of this")
        ->check(CLI::Range(1, 8192))
        ->capture_default_str();
    command->add_option("--turns", options->turns, "Measurements of each; the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--threads", options->threads, "All by default")->check(CLI::Range(1, 1024));
    addJsonOption(*command, json.get());
    command->callback([options, json, exitCode] { *exitCode = runRays(*options, *json); });
}

}  // namespace glint
