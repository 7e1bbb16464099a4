// `glint converge`: error against run time. Reads and checks everything, gets a reference, runs, and writes
// the folder; the work itself is engine/report's.
#include <chrono>
#include <cmath>
#include <fstream>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "engine/base/console.h"
#include "engine/base/log.h"
#include "engine/base/parallel.h"
#include "engine/builders/scene_builder.h"
#include "viewer/base/interrupt.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/converge_options.h"
#include "viewer/commands/converge_output.h"
#include "viewer/commands/converge_print.h"
#include "viewer/commands/converge_reference.h"
#include "viewer/commands/json_output.h"

namespace glint {
namespace {

std::string processorName() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) { return line.substr(colon + 2); }
    }
    return "unknown processor";
}

ConvergenceContext contextOf(const ConvergeOptions& options, const SceneDescription& scene) {
    ConvergenceContext context;
    context.command = options.command;
    context.scene = options.scene;
    context.title = scene.title;
    context.processor = processorName();
    context.processors = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
    context.threads = options.threads > 0 ? options.threads : defaultThreadCount();
    context.date = fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)));
    double load = 0.0;
    if (getloadavg(&load, 1) == 1 && load > 0.5) {
        context.warnings.push_back(fmt::format(
            "The machine was busy when this began (load {:.1f} on {} processors): times are too long.", load,
            context.processors));
    }
    return context;
}

class ConvergeRun {
  public:
    explicit ConvergeRun(const ConvergeOptions& options) : options_(options), folder_(options.out) {
        host_.makeBackend = exactBackend;
        host_.stopWanted = [this] { return interrupt_.interrupted(); };
        host_.onPart = [this](const std::string& part) { line_.begin(part); };
        host_.onProgress = [this](const std::string& text) { line_.draw(text); };
    }

    int run() {
        if (const Status ready = prepare(); !ready) { return reportError(ready.error(), kExitBadInput); }
        context_ = contextOf(options_, scene_);
        ConvergeReference finder(options_, folder_, scene_, plan_, host_, &line_);
        Result<std::optional<ReferenceImage>> found = finder.find();
        line_.finish();
        if (!found) { return reportError(found.error(), finder.failureCode()); }
        if (!*found) {
            say("interrupted before there was a reference: nothing was measured\n");
            return kExitInterrupted;
        }
        reference_ = std::move(**found);
        plan_.seeds = seedsBeside(reference_.seeds, scene_.options.seed, options_.seeds);
        ConvergenceResult result = runConvergence(plan_, scene_, reference_, host_);
        line_.finish();
        return report(&result);
    }

  private:
    Status prepare() {
        if (Status consistent = checkConvergeOptions(options_); !consistent) { return consistent; }
        RunFiles files;
        files.reads("the scene", options_.scene);
        // The reference that lies in the folder stays there.
        const bool isFolders = isSameFile(options_.reference, folder_.reference());
        if (!isFolders) { files.reads("the reference", options_.reference); }
        if (Status writable = files.writes(options_.json); !writable) { return writable; }
        if (Status writable = folder_.check(options_.overwrite, files); !writable) { return writable; }
        Result<SceneDescription> loaded = openScene(options_.scene, options_.load);
        if (!loaded) { return loaded.error(); }
        scene_ = std::move(*loaded);
        files.readsScene(scene_);
        if (Status checked = files.check(); !checked) { return checked; }
        if (Status writable = folder_.check(options_.overwrite, files); !writable) { return writable; }
        if (Status applied = applyTo(options_.overrides, &scene_); !applied) { return applied; }
        Result<ConvergencePlan> plan = planOf(options_, scene_);
        if (!plan) { return plan.error(); }
        plan_ = std::move(*plan);
        return checkItCanRun();
    }

    /// Back ends and the scene, so that an hour's run does not end with what could be known before.
    Status checkItCanRun() {
        for (const ConvergenceVariant& variant : plan_.variants) {
            const auto backend = exactBackend(variant.applyTo(plan_.defaults));
            if (!backend) { return Error{fmt::format("{}: {}", variant.text, backend.error().message), {}}; }
        }
        const auto built = buildScene({std::make_shared<SceneDescription>(scene_), EditKind::Everything},
                                      nullptr, options_.threads, nullptr, nullptr);
        return built ? Status() : Status(built.error());
    }

    int report(ConvergenceResult* result) {
        const ConvergenceSummary summary =
            summarizeConvergence(*result, reference_, options_.subtractReference);
        const ConvergenceReport report{context_, plan_, scene_, reference_, *result, summary};
        Status written = folder_.make();
        if (written) { written = folder_.write(report, result); }
        // Also when the disk is full: what was measured must not be lost.
        if (!jsonTakesOutput(options_.json)) { printReport(report); }
        const Status json =
            options_.json.empty()
                ? Status()
                : writeJson(options_.json, "converge", nlohmann::ordered_json::parse(summaryJson(report)));
        const Status& all = written ? json : written;
        if (!all) { return reportError(all.error(), kExitFailed); }
        const bool failed = std::ranges::any_of(result->variants,
                                                [](const MeasuredVariant& v) { return !v.problem.empty(); });
        return result->interrupted ? kExitInterrupted : failed ? kExitFailed : kExitDone;
    }

    const ConvergeOptions& options_;
    ConvergeFolder folder_;
    SceneDescription scene_;
    ConvergencePlan plan_;
    ConvergenceContext context_;
    ReferenceImage reference_;
    ConvergenceHost host_;
    PartLine line_;
    InterruptGuard interrupt_;
};

}  // namespace

void addConvergeCommand(const Command& program) {
    const Command command = program.subcommand(
        "converge", "Error against run time for path tracing, photon mapping and variants");
    const auto options = std::make_shared<ConvergeOptions>();
    addConvergeOptions(command, options.get());
    command.onRun([command, options] {
        options->command = commandAsWritten(command);
        return ConvergeRun(*options).run();
    });
}

}  // namespace glint
