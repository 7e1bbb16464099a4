// `glint converge`: error against run time. Reads and checks everything, gets a reference, runs, and writes
// the folder; the work itself is engine/report's.
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <CLI/CLI.hpp>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "engine/base/log.h"
#include "engine/base/parallel.h"
#include "engine/build/scene_builder.h"
#include "engine/io/atomic_file.h"
#include "engine/io/scene_loader.h"
#include "engine/report/convergence_pilot.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/converge_options.h"
#include "viewer/commands/converge_output.h"
#include "viewer/commands/converge_print.h"
#include "viewer/commands/interrupt.h"
#include "viewer/commands/json_output.h"
#include "viewer/make_backend.h"

namespace glint {
namespace {

/// The reference's error should be this share of the smallest one that is reported.
constexpr double kReferenceShare = 0.1;
/// Of the reference's time, that a pilot of each variant may take to find out how small that one will be.
constexpr double kPilotShare = 0.1;
/// Seeds of references lie apart from those of pictures.
constexpr uint32_t kReferenceSeedOffset = 1u << 20;

/// Unlike makeBackend(), refuses what would run on something else.
Result<std::unique_ptr<Backend>> exactBackend(const VariantSettings& settings) {
    if (settings.backend == "cpu") {
        return makeCpuBackend(settings.threads,
                              settings.fullKernel ? KernelChoice::Full : KernelChoice::Specialised);
    }
    if (settings.fullKernel) {
        return Error{"kernel=full is for the CPU; expected backend=cpu", {}};
    }
    auto backend = makeBackend(settings.backend, settings.threads);
    if (backend && (*backend)->name().starts_with("CPU")) {
        return Error{"CUDA cannot be used here; a comparison needs the back end it names", {}};
    }
    return backend;
}

std::string processorName() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
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
        if (const Status ready = prepare(); !ready) {
            return complain(ready.error(), kExitBadInput);
        }
        context_ = contextOf(options_, scene_);
        const Result<bool> has = getReference();
        line_.finish();
        if (!has) {
            return complain(has.error(), failureCode_);
        }
        if (!*has) {
            fmt::print(stderr, "interrupted before there was a reference: nothing was measured\n");
            return kExitInterrupted;
        }
        plan_.seeds = seedsBeside(reference_.seeds, scene_.options.seed, options_.seeds);
        ConvergenceResult result = runConvergence(plan_, scene_, reference_, host_);
        line_.finish();
        return report(&result);
    }

  private:
    Status prepare() {
        if (Status consistent = checkConvergeOptions(options_); !consistent) {
            return consistent;
        }
        if (Status writable = folder_.check(options_.overwrite); !writable) {
            return writable;
        }
        Result<SceneDescription> loaded = loadScene(options_.scene, {.allowMissing = options_.allowMissing});
        if (!loaded) {
            return loaded.error();
        }
        scene_ = std::move(*loaded);
        for (const std::string& warning : scene_.warnings) {
            logWarning("{}", warning);
        }
        if (Status applied = applyTo(options_, &scene_); !applied) {
            return applied;
        }
        Result<ConvergencePlan> plan = planOf(options_, scene_);
        if (!plan) {
            return plan.error();
        }
        plan_ = std::move(*plan);
        return checkItCanRun();
    }

    /// Back ends and the scene, so that an hour's run does not end with what could be known before.
    Status checkItCanRun() {
        for (const ConvergenceVariant& variant : plan_.variants) {
            const auto backend = exactBackend(variant.applyTo(plan_.defaults));
            if (!backend) {
                return Error{fmt::format("{}: {}", variant.text, backend.error().message), {}};
            }
        }
        const auto built = buildScene({std::make_shared<SceneDescription>(scene_), EditKind::Everything},
                                      nullptr, options_.threads, nullptr, nullptr);
        return built ? Status() : Status(built.error());
    }

    /// False: interrupted.
    Result<bool> getReference() {
        if (!options_.reference.empty()) {
            return takeReference();
        }
        const char* own = scene_.options.integrator == IntegratorKind::Sppm ? "sppm" : "pt";
        const auto variant =
            parseVariant(options_.referenceVariant.empty() ? own : options_.referenceVariant);
        if (!variant) {
            return variant.error();
        }
        ReferencePlan wanted{*variant, plan_.defaults, options_.makeReference};
        wanted.settings.options.fireflyClamp = 0.0f;
        wanted.settings = variant->applyTo(wanted.settings);
        if (const auto backend = exactBackend(wanted.settings); !backend) {
            return Error{fmt::format("--reference-variant: {}", backend.error().message), {}};
        }
        wanted.firstSeed = scene_.options.seed + kReferenceSeedOffset;
        if (const Result<bool> cached = takeCached(&wanted); !cached || *cached) {
            return cached;
        }
        return makeNew(wanted);
    }

    /// Sets how precise the reference has to be. False: interrupted.
    bool findPrecision(ReferencePlan* wanted) {
        if (wanted->relativeError == 0.0) {
            plan_.seeds = {scene_.options.seed};
            wanted->relativeError =
                kReferenceShare *
                predictSmallestError(plan_, scene_, kPilotShare * wanted->renderSeconds, host_);
        }
        return !interrupt_.interrupted();
    }

    Result<bool> takeReference() {
        Result<ReferencePicture> loaded = loadReference(options_.reference, scene_, options_.anyReference);
        if (!loaded) {
            return loaded.error();
        }
        reference_ = std::move(*loaded);
        std::error_code ignored;
        if (std::filesystem::equivalent(options_.reference, folder_.reference(), ignored)) {
            return true;
        }
        if (std::filesystem::exists(folder_.reference(), ignored) && !options_.overwrite) {
            return Error{fmt::format("{} is another reference; expected another folder, or --overwrite",
                                     folder_.reference()),
                         {}};
        }
        const Result<std::string> bytes = readFile(options_.reference);
        if (!bytes) {
            return bytes.error();
        }
        if (const Status made = folder_.make(); !made) {
            return made.error();
        }
        const Status copied = writeFileAtomically(folder_.reference(), *bytes);
        return copied ? Result<bool>(true) : Result<bool>(copied.error());
    }

    /// The reference of an earlier run in this folder, where it is as good as the one asked for.
    Result<bool> takeCached(ReferencePlan* wanted) {
        std::error_code ignored;
        if (!std::filesystem::exists(folder_.reference(), ignored)) {
            return false;
        }
        Result<ReferencePicture> old = loadReference(folder_.reference(), scene_, false);
        if (!old && options_.overwrite) {
            return false;
        }
        if (!old) {
            return Error{fmt::format("{}; expected another folder, or --overwrite", old.error().format()),
                         {}};
        }
        const bool same = old->method == wanted->variant.text && old->knowsItsError();
        bool enough = old->timeLimitSeconds >= wanted->renderSeconds;
        // Precise enough for an earlier plan is not for a longer one. The margin is the pilot's own
        // randomness.
        if (same && enough && old->endedBy == "precision" && findPrecision(wanted)) {
            enough = old->relativeError() <= 1.5 * wanted->relativeError || wanted->relativeError == 0.0;
        }
        if (!same || !enough) {
            line_.finish();
            fmt::print(stderr,
                       "{} is replaced: made by {} with a limit of {:.3g} s, its own error is {:.3g} %\n",
                       folder_.reference(), old->method.empty() ? "something else" : old->method,
                       old->timeLimitSeconds, 100.0 * old->relativeError());
            return false;
        }
        fmt::print(stderr, "{} is used again ({:.3g} s by {})\n", folder_.reference(), old->renderSeconds,
                   old->method);
        reference_ = std::move(*old);
        reference_.cached = true;
        return true;
    }

    Result<bool> makeNew(ReferencePlan wanted) {
        // Now, and not after an hour: some folders can only be refused by trying.
        if (const Status folder = folder_.make(); !folder) {
            return folder.error();
        }
        failureCode_ = kExitFailed;
        if (!findPrecision(&wanted)) {
            folder_.removeIfEmpty();
            return false;
        }
        auto made = makeReference(wanted, scene_, host_);
        if (!made || !*made) {
            folder_.removeIfEmpty();
            return made ? Result<bool>(false) : Result<bool>(made.error());
        }
        reference_ = std::move(**made);
        reference_.path = folder_.reference();
        if (const Status saved = saveReference(folder_.reference(), reference_, scene_, wanted.settings);
            !saved) {
            folder_.removeIfEmpty();
            return saved.error();
        }
        announce(wanted);
        return true;
    }

    /// Before hours are spent on comparing with it.
    void announce(const ReferencePlan& wanted) {
        line_.finish();
        const double own = reference_.relativeError();
        fmt::print(stderr, "the reference's own error is {:.3g} % after {} s", 100.0 * own,
                   secondsText(reference_.renderSeconds));
        if (wanted.relativeError > 0.0 && own > wanted.relativeError) {
            const double times = std::pow(own / wanted.relativeError, 2.0);
            fmt::print(stderr,
                       "; a tenth of the smallest error expected is {:.3g} %, which would take about {} s",
                       100.0 * wanted.relativeError, secondsText(times * reference_.renderSeconds));
        }
        fmt::print(stderr, "\n");
    }

    int report(ConvergenceResult* result) {
        const ConvergenceSummary summary =
            summarizeConvergence(*result, reference_, options_.subtractReference);
        const ConvergenceReport report{context_, plan_, scene_, reference_, *result, summary};
        Status written = folder_.make();
        if (written) {
            written = folder_.write(report, result);
        }
        // Also when the disk is full: what was measured must not be lost.
        if (!jsonTakesOutput(options_.json)) {
            printReport(report);
        }
        if (!written) {
            return complain(written.error(), kExitFailed);
        }
        if (!options_.json.empty()) {
            written = writeJson(options_.json, nlohmann::ordered_json::parse(summaryJson(report)));
            if (!written) {
                return complain(written.error(), kExitFailed);
            }
        }
        const bool failed = std::ranges::any_of(result->variants,
                                                [](const MeasuredVariant& v) { return !v.problem.empty(); });
        return result->interrupted ? kExitInterrupted : failed ? kExitFailed : kExitDone;
    }

    const ConvergeOptions& options_;
    ConvergeFolder folder_;
    SceneDescription scene_;
    ConvergencePlan plan_;
    ConvergenceContext context_;
    ReferencePicture reference_;
    ConvergenceHost host_;
    PartLine line_;
    InterruptGuard interrupt_;
    ExitCode failureCode_ = kExitBadInput;  ///< of a reference: until it is rendered, the input is at fault
};

}  // namespace

void addConvergeCommand(CLI::App& app, int* exitCode) {
    CLI::App* command = app.add_subcommand(
        "converge", "Error against run time for path tracing, photon mapping and variants");
    const auto options = std::make_shared<ConvergeOptions>();
    addConvergeOptions(*command, options.get());
    command->callback([command, options, exitCode] {
        options->command = commandAsWritten(*command);
        *exitCode = ConvergeRun(*options).run();
    });
}

}  // namespace glint
