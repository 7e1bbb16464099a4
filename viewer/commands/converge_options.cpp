#include "viewer/commands/converge_options.h"

#include <algorithm>

#include <fmt/format.h>

#include "engine/io/importer.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/json_output.h"
#include "viewer/commands/render_options.h"

namespace glint {
namespace {

constexpr const char* kConvergeFooter =
    R"(A variant is path, sppm, ao or raycast, then settings that differ from the scene's own, each after a colon:
{}
Examples:
  glint converge scenes/cornell.json --make-reference 60 --time 10 --out cornell
  glint converge scenes/cornell.json --reference cornell/reference.exr --out samplers
      --integrators path:sampler=sobol,path:sampler=independent
  glint converge scenes/sppm_ring.json --make-reference 120 --reference-variant sppm --out radii
      --integrators sppm:radius=auto:1,sppm:radius=auto:4,sppm:radius=auto:16
  glint converge scenes/cornell.json --make-reference 60 --out kernels
      --integrators path,path:kernel=full,path:threads=1
  glint converge scenes/cornell.json --make-reference 60 --out denoised
      --passes 64 --integrators path,path:denoise=on
Seconds are render seconds: evaluating, saving and building take none. OUT gets index.html, plot.svg, plot.png,
curve.csv, summary.csv, summary.json, reference.exr and pictures/. Ctrl-C writes them with what has been measured.)";

void addReferenceOptions(const Command& command, ConvergeOptions* o) {
    const std::string group = "What errors are measured against";
    command.option("--reference", &o->reference, "An EXR picture of this scene, with its standard error")
        .typeName("REF.exr")
        .group(group);
    command
        .option("--make-reference", &o->makeReference,
                "Render one until its standard error is a tenth of the smallest error to be reported, "
                "but at most for "
                "SECONDS, and say how far it came; OUT/reference.exr is used again by the next run")
        .aboveZero()
        .typeName("SECONDS")
        .group(group);
    command
        .option("--reference-variant", &o->referenceVariant,
                "What --make-reference renders with; the scene's own integrator by default")
        .typeName("VARIANT")
        .group(group);
    command
        .flag("--any-reference", &o->anyReference,
              "Take a reference that says it shows another scene, and warn in all outputs")
        .group(group);
    command
        .flag("--subtract-reference", &o->subtractReference,
              "Fits and times without the reference's own error: sqrt(MSE - its MSE)")
        .group(group);
}

void addMeasuringOptions(const Command& command, ConvergeOptions* o) {
    const std::string group = "What is measured";
    command.option("--integrators", &o->integrators, "The variants to compare, see below")
        .typeName("VARIANT,...")
        .showDefault()
        .group(group);
    command
        .option(
            "--time", &o->seconds,
            fmt::format("Render seconds of each variant and seed; {:g} by default", kDefaultConvergeSeconds))
        .aboveZero()
        .typeName("SECONDS")
        .group(group);
    command.option("--passes", &o->passes, "Passes instead of seconds")
        .range(1u, 1u << 30)
        .typeName("N")
        .group(group);
    command.option("--seeds", &o->seeds, "Independent renders of each variant: mean and spread are over them")
        .range(1, 1000)
        .showDefault()
        .group(group);
    command.option("--points", &o->points, "Measurements of each render, evenly on a logarithmic scale")
        .range(2, 200)
        .showDefault()
        .group(group);
    command.option("--pictures", &o->images, "Pictures of each variant: of the end, a tenth, a hundredth ...")
        .range(0, 8)
        .showDefault()
        .group(group);
    command
        .option("--picture-times", &o->imageTimes,
                "Pictures at these seconds (with --passes: passes) instead, and at the end")
        .commaSeparated(1, 32)
        .aboveZero()
        .typeName("T,...")
        .excludes("--pictures")
        .group(group);
    command.option("--exposure", &o->exposure, "Stops at which pictures are shown and SSIM and FLIP look")
        .between(-60.0, 60.0)
        .group(group);
}

/// The seed is the first one; a reference's own seeds are left out.
void addSceneOptions(const Command& command, ConvergeOptions* o) {
    addSceneOverrides(command, &o->overrides,
                      [](std::string_view option) { return option == "--depth" || option == "--seed"; });
}

}  // namespace

void addConvergeOptions(const Command& command, ConvergeOptions* o) {
    command.option("scene", &o->scene, "The scene: " + listImporters()).required().typeName("SCENE");
    command.option("-o,--out", &o->out, "The folder for everything that is written")
        .required()
        .typeName("DIR");
    addReferenceOptions(command, o);
    addMeasuringOptions(command, o);
    addSceneOptions(command, o);
    command.option("--threads", &o->threads, "Render threads; all by default").range(1, 1024);
    command.option("--backend", &o->backend, "cpu or cuda").oneOf({"cpu", "cuda"});
    command.flag("--overwrite", &o->overwrite, "Replace an earlier run's files in DIR");
    addLoadOptions(command, &o->load);
    addJsonOption(command, &o->json);
    command.footer(fmt::format(fmt::runtime(kConvergeFooter), variantHelp()));
}

std::string commandAsWritten(const Command& command) {
    std::string text = "glint converge";
    for (const GivenOption& option : command.given()) {
        if (option.name.starts_with("-")) { text += " " + option.name; }
        if (option.takesValue) { text += " " + quotedForShell(option.value); }
    }
    return text;
}

Status checkConvergeOptions(const ConvergeOptions& o) {
    if (o.reference.empty() && o.makeReference == 0.0) {
        return Error{
            "nothing to measure errors against; expected --reference REF.exr or --make-reference SECONDS",
            {}};
    }
    if (!o.reference.empty() && o.makeReference > 0.0) {
        return Error{"--reference and --make-reference exclude each other; expected one of them", {}};
    }
    if (!o.referenceVariant.empty() && o.makeReference == 0.0) {
        return Error{"--reference-variant needs --make-reference SECONDS", {}};
    }
    if (o.seconds > 0.0 && o.passes > 0) {
        return Error{"--time and --passes exclude each other; expected one of them", {}};
    }
    return {};
}

Result<ConvergencePlan> planOf(const ConvergeOptions& o, const SceneDescription& scene) {
    Result<std::vector<ConvergenceVariant>> variants = parseVariants(o.integrators);
    if (!variants) { return variants.error(); }
    ConvergencePlan plan;
    plan.variants = std::move(*variants);
    plan.defaults.options = scene.options;
    plan.defaults.sppm = scene.sppm;
    plan.defaults.threads = o.threads;
    plan.defaults.backend = o.backend;
    plan.passes = o.passes;
    plan.seconds = o.passes > 0 ? 0.0 : o.seconds > 0.0 ? o.seconds : kDefaultConvergeSeconds;
    plan.points = o.points;
    plan.images = o.images;
    plan.imageMoments = o.imageTimes;
    std::ranges::sort(plan.imageMoments);
    if (const double whole = plan.seconds > 0.0 ? plan.seconds : plan.passes;
        !o.imageTimes.empty() && plan.imageMoments.back() > whole) {
        return Error{
            fmt::format("--picture-times: {:g} lies beyond the end at {:g}", plan.imageMoments.back(), whole),
            {}};
    }
    plan.exposureStops = static_cast<double>(o.exposure);
    return plan;
}

}  // namespace glint
