// `glint bench`: one subcommand per figure. A new benchmark adds its line to kBenchmarks.
#include <fmt/format.h>

#include "engine/base/console.h"
#include "engine/base/parallel.h"
#include "engine/builders/scene_builder.h"
#include "viewer/bench/bench.h"
#include "viewer/bench/measuring.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/json_output.h"
#include "viewer/commands/measuring_program.h"

namespace glint {
namespace {

constexpr Benchmark (*kBenchmarks[])() = {
    raysBenchmark, revolveBenchmark, pathsBenchmark,    passesBenchmark, latencyBenchmark,
    loadBenchmark, threadsBenchmark, variantsBenchmark, accelBenchmark,
};

/// The options of a run, and where its report goes.
struct BenchRun {
    Benchmark benchmark;
    BenchOptions options;
    std::string json;
};

Option declare(const Command& command, const BenchOption& option, BenchOptions* values) {
    return std::visit(
        [&](auto member) {
            auto& value = values->*member;
            const Option declared = command.option(option.name, &value, option.help);
            return value != std::decay_t<decltype(value)>() ? declared.showDefault() : declared;
        },
        option.member);
}

/// Null without a scene.
Result<std::shared_ptr<SceneDescription>> sceneOf(const BenchRun& run) {
    if (run.benchmark.scene == nullptr) { return std::shared_ptr<SceneDescription>(); }
    return run.benchmark.scene(run.options);
}

int runBenchmark(BenchRun run) {
    if (run.options.threads == 0) { run.options.threads = defaultThreadCount(); }
    BenchSubject subject{run.options, nullptr, nullptr};
    const auto scene = sceneOf(run);
    if (!scene) { return reportError(scene.error(), kExitBadInput); }
    if (*scene) {
        subject.scene = *scene;
        const auto built =
            buildScene({subject.scene, EditKind::Everything}, nullptr, run.options.threads, nullptr, nullptr);
        if (!built) { return reportError(built.error(), kExitBadInput); }
        subject.built = *built;
    }
    const auto report = run.benchmark.measure(subject);
    if (!report) { return reportError(report.error(), run.benchmark.onError); }
    if (!jsonTakesOutput(run.json)) { put("{}", report->text); }
    const Status written = writeJson(run.json, fmt::format("bench {}", run.benchmark.name), report->json);
    if (!written) { return reportError(written.error(), kExitFailed); }
    return report->isWrong ? kExitFailed : kExitDone;
}

void addBenchmark(const Command& bench, Benchmark benchmark) {
    const auto run = std::make_shared<BenchRun>(BenchRun{std::move(benchmark), {}, ""});
    run->options = run->benchmark.defaults;
    const Command command = bench.subcommand(run->benchmark.name, run->benchmark.about);
    for (const BenchOption& option : run->benchmark.options) {
        const Option declared = declare(command, option, &run->options);
        if (option.least < option.most) { declared.range(option.least, option.most); }
        if (!option.choices.empty()) { declared.oneOf(option.choices); }
    }
    addJsonOption(command, &run->json);
    command.onRun([run] { return runBenchmark(*run); });
}

}  // namespace

BenchOption threadsOption(const char* help, int least) {
    return {"--threads", &BenchOptions::threads, help, least, 1024};
}

BenchOption sizeOption(const char* help) { return {"--size", &BenchOptions::size, help, 16, 8192}; }

BenchOption passesOption() { return {"--passes", &BenchOptions::passes, "Measured passes", 1, 100000}; }

BenchOption turnsOption(const char* help) { return {"--turns", &BenchOptions::turns, help, 1, 1000}; }

BenchOption trianglesOption() {
    return {"--triangles", &BenchOptions::triangles, "Of the mesh", 100, 50'000'000};
}

void addBenchCommand(const Command& program) {
    const Command bench = program.subcommand(kBench.name, kBench.about);
    bench.needsSubcommand();
    bench.footer("Figures are only worth something on a machine that does nothing else.");
    for (const auto& benchmark : kBenchmarks) {
        addBenchmark(bench, benchmark());
    }
}

void addMeasuringCommands(const Command& program) {
    addStressCommand(program);
    addBenchCommand(program);
}

}  // namespace glint
