#include "viewer/commands/converge_reference.h"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "engine/base/console.h"
#include "engine/io/atomic_file.h"
#include "engine/report/convergence_pilot.h"
#include "viewer/base/make_backend.h"

namespace glint {
namespace {

/// The reference's error should be this share of the smallest one that is reported.
constexpr double kReferenceShare = 0.1;
/// Of the reference's time, that a pilot of each variant may take to find out how small that one will be.
constexpr double kPilotShare = 0.1;
/// How much pilots of the same plan may differ by chance.
constexpr double kPilotMargin = 1.5;
/// Seeds of references lie apart from those of pictures.
constexpr uint32_t kReferenceSeedOffset = 1u << 20;

}  // namespace

Result<std::unique_ptr<Backend>> exactBackend(const VariantSettings& settings) {
    if (settings.backend == "cpu") {
        return makeCpuBackend(settings.threads,
                              settings.fullKernel ? KernelChoice::Full : KernelChoice::Specialised);
    }
    if (settings.fullKernel) { return Error{"kernel=full is for the CPU; expected backend=cpu", {}}; }
    auto backend = makeBackend(settings.backend, settings.threads);
    if (backend && (*backend)->name().starts_with("CPU")) {
        return Error{"CUDA cannot be used here; a comparison needs the back end it names", {}};
    }
    return backend;
}

ConvergeReference::Found ConvergeReference::find() {
    if (!options_.reference.empty()) { return takeGiven(); }
    const char* own = integratorInfo(scene_.options.integrator).key;
    const auto variant = parseVariant(options_.referenceVariant.empty() ? own : options_.referenceVariant);
    if (!variant) { return variant.error(); }
    ReferencePlan wanted{*variant, plan_.defaults, options_.makeReference};
    wanted.settings.options.fireflyClamp = 0.0f;
    wanted.settings = variant->applyTo(wanted.settings);
    if (const auto backend = exactBackend(wanted.settings); !backend) {
        return Error{fmt::format("--reference-variant: {}", backend.error().message), {}};
    }
    wanted.firstSeed = scene_.options.seed + kReferenceSeedOffset;
    Found cached = takeCached(&wanted);
    return cached && !*cached ? makeNew(wanted) : std::move(cached);
}

/// Sets how precise the reference has to be. False: interrupted.
bool ConvergeReference::findPrecision(ReferencePlan* wanted) const {
    if (wanted->relativeError == 0.0) {
        ConvergencePlan pilot = plan_;
        pilot.seeds = {scene_.options.seed};
        wanted->relativeError =
            kReferenceShare * predictSmallestError(pilot, scene_, kPilotShare * wanted->renderSeconds, host_);
    }
    return !host_.mustStop();
}

ConvergeReference::Found ConvergeReference::takeGiven() {
    Result<ReferenceImage> loaded = loadReference(options_.reference, scene_, options_.anyReference);
    if (!loaded) { return loaded.error(); }
    Found given = std::optional(std::move(*loaded));
    std::error_code ignored;
    if (std::filesystem::equivalent(options_.reference, folder_.reference(), ignored)) { return given; }
    if (std::filesystem::exists(folder_.reference(), ignored) && !options_.overwrite) {
        return Error{fmt::format("{} is another reference; expected another folder, or --overwrite",
                                 folder_.reference()),
                     {}};
    }
    const Result<std::string> bytes = readFile(options_.reference);
    if (!bytes) { return bytes.error(); }
    if (const Status made = folder_.make(); !made) { return made.error(); }
    const Status copied = writeFileAtomically(folder_.reference(), *bytes);
    return copied ? std::move(given) : Found(copied.error());
}

/// The reference of an earlier run in this folder, where it is as good as the one asked for.
ConvergeReference::Found ConvergeReference::takeCached(ReferencePlan* wanted) {
    std::error_code ignored;
    if (!std::filesystem::exists(folder_.reference(), ignored)) { return std::optional<ReferenceImage>(); }
    Result<ReferenceImage> old = loadReference(folder_.reference(), scene_, false);
    if (!old && options_.overwrite) { return std::optional<ReferenceImage>(); }
    if (!old) {
        return Error{fmt::format("{}; expected another folder, or --overwrite", old.error().format()), {}};
    }
    const bool same = old->method == wanted->variant.text && old->knowsItsError();
    bool enough = old->timeLimitSeconds >= wanted->renderSeconds;
    // Precise enough for an earlier plan is not for a longer one.
    if (same && enough && old->endedBy == "precision" && findPrecision(wanted)) {
        enough = old->relativeError() <= kPilotMargin * wanted->relativeError || wanted->relativeError == 0.0;
    }
    line_.finish();
    if (!same || !enough) {
        say("{} is replaced: made by {} with a limit of {:.3g} s, its own error is {:.3g} %\n",
            folder_.reference(), old->method.empty() ? "something else" : old->method, old->timeLimitSeconds,
            100.0 * old->relativeError());
        return std::optional<ReferenceImage>();
    }
    say("{} is used again ({:.3g} s by {})\n", folder_.reference(), old->renderSeconds, old->method);
    old->cached = true;
    return std::optional(std::move(*old));
}

ConvergeReference::Found ConvergeReference::makeNew(ReferencePlan wanted) {
    // Now, and not after an hour: some folders can only be refused by trying.
    if (const Status folder = folder_.make(); !folder) { return folder.error(); }
    failureCode_ = kExitFailed;
    Found made = findPrecision(&wanted) ? makeReference(wanted, scene_, host_)
                                        : Found(std::optional<ReferenceImage>());
    if (!made || !*made) {
        folder_.removeIfEmpty();
        return made;
    }
    std::error_code ignored;
    if ((*made)->endedBy == "interrupt" && std::filesystem::exists(folder_.reference(), ignored)) {
        return std::optional<ReferenceImage>();  // An earlier one may be better.
    }
    (*made)->path = folder_.reference();
    if (const Status saved = saveReference(folder_.reference(), **made, scene_, wanted.settings); !saved) {
        folder_.removeIfEmpty();
        return saved.error();
    }
    announce(wanted, **made);
    return made;
}

/// Before hours are spent on comparing with it.
void ConvergeReference::announce(const ReferencePlan& wanted, const ReferenceImage& made) const {
    line_.finish();
    const double own = made.relativeError();
    say("the reference's own error is {:.3g} % after {} s", 100.0 * own, secondsText(made.renderSeconds));
    if (wanted.relativeError > 0.0 && own > wanted.relativeError) {
        const double times = std::pow(own / wanted.relativeError, 2.0);
        say("; a tenth of the smallest error expected is {:.3g} %, which would take about {} s",
            100.0 * wanted.relativeError, secondsText(times * made.renderSeconds));
    }
    say("\n");
}

}  // namespace glint
