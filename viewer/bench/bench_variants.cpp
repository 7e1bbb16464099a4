// `glint bench variants`: the kernels compiled for what a scene needs beside the ones that do everything,
// pass by pass in turn on the same threads, and whether their pictures agree. Passes alone, without the film.
//
// The ratio is of processor time: kernels kNever wait, and what else the machine does hardly counts.
#include <atomic>
#include <ctime>

#include <fmt/format.h>

#include "engine/render/backend.h"
#include "engine/render/cpu_variants.h"
#include "engine/render/pass_params.h"
#include "engine/render/path_pass.h"
#include "engine/render/sppm_integrator.h"
#include "engine/render/sppm_kernel.h"
#include "viewer/bench/bench.h"
#include "viewer/bench/bench_pairs.h"
#include "viewer/bench/bench_scenes.h"
#include "viewer/bench/bench_statistics.h"

namespace glint {
namespace {

constexpr uint32_t kMeshTriangles = 100'000;
constexpr int kDefaultSize = 512;

/// Processor time of all threads of this process.
double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// One backend with a picture of its own.
class KernelRun {
  public:
    KernelRun(const BenchSubject& subject, IntegratorKind integrator, KernelChoice choice)
        : backend_(makeCpuBackend(subject.options.threads, choice)),
          params_(sppmParamsOf(*subject.scene)),
          integrator_(integrator),
          threads_(subject.options.threads),
          film_(params_.pass.width, params_.pass.height) {
        (void)backend_->setScene(subject.built);
        if (integrator == IntegratorKind::Sppm) {
            sppm_ = SppmState(params_.pass.width, params_.pass.height);
        }
    }

    /// Renders and commits a pass; processor time of rendering.
    double renderPass(uint32_t pass) {
        static const std::atomic<bool> kNever{false};
        params_.pass.pass = pass;
        const Stopwatch stopwatch;
        const double processorBefore = processorSeconds();
        const auto done = integrator_ == IntegratorKind::Sppm
                              ? renderSppmPass(*backend_, params_, kNever, &sppm_, &samples_)
                              : renderPathPass(*backend_, params_.pass, kNever, &samples_);
        const double processor = processorSeconds() - processorBefore;
        const double wall = stopwatch.seconds();
        if (pass > 0) { wallSeconds_.push_back(wall); }
        if (!done && status_) { status_ = done.error(); }
        if (done) { film_.commit(samples_, pass, threads_); }
        return processor;
    }

    const Status& status() const { return status_; }
    const std::vector<double>& wallSeconds() const { return wallSeconds_; }
    const Film& film() const { return film_; }
    const SppmState& sppm() const { return sppm_; }

  private:
    std::unique_ptr<Backend> backend_;
    SppmParams params_;
    IntegratorKind integrator_;
    int threads_;
    Film film_;
    SppmState sppm_;
    std::vector<PixelSample> samples_;
    std::vector<double> wallSeconds_;
    Status status_;
};

struct VariantsRow {
    IntegratorKind integrator = IntegratorKind::PathTracing;
    const char* kernel = "";
    double specialisedSeconds = 0.0;  ///< of the median pass
    double fullSeconds = 0.0;
    RatioInterval ratio;  ///< the full kernel's processor time over the specialised one's
    RatioInterval wallRatio;
    ImageDifference difference;

    const char* name() const { return integratorInfo(integrator).key; }
};

/// The scene at the asked-for width, in its own shape.
Result<std::shared_ptr<SceneDescription>> variantsScene(const BenchOptions& options) {
    if (options.scene.empty()) {
        const int size = options.size > 0 ? options.size : kDefaultSize;
        return benchMesh(kMeshTriangles, size, size);
    }
    auto scene = benchFile(options.scene);
    if (scene && options.size > 0) {
        Resolution& image = (*scene)->resolution;
        image.height = std::max(1, image.height * options.size / image.width);
        image.width = options.size;
    }
    return scene;
}

Result<VariantsRow> measureRow(const BenchSubject& subject, IntegratorKind integrator) {
    KernelRun specialised(subject, integrator, KernelChoice::Specialised);
    KernelRun full(subject, integrator, KernelChoice::Full);
    const PairTimes times = measureByTurns(
        subject.options.turns, [&](uint32_t pass) { return specialised.renderPass(pass); },
        [&](uint32_t pass) { return full.renderPass(pass); });
    for (const KernelRun* run : {&specialised, &full}) {
        if (!run->status()) { return run->status().error(); }
    }
    VariantsRow row;
    row.integrator = integrator;
    const SamplerKind sampler = subject.scene->options.sampler;
    row.kernel = integrator == IntegratorKind::Sppm
                     ? chooseVariant(sppmVariants(), subject.built->features, sampler).name
                     : chooseVariant(kernelVariants(), subject.built->features, sampler).name;
    row.specialisedSeconds = percentilesOf(specialised.wallSeconds()).median;
    row.fullSeconds = percentilesOf(full.wallSeconds()).median;
    row.ratio = ratioOf(times.second, times.first);
    row.wallRatio = ratioOf(full.wallSeconds(), specialised.wallSeconds());
    row.difference = compareImages(specialised.film(), full.film(), specialised.sppm(), full.sppm());
    return row;
}

std::string textOf(const VariantsRow& row) {
    return fmt::format("{:<6}{:<24}{:>12.2f}{:>12.2f}   {:<24}{}\n", row.name(), row.kernel,
                       1.0 / row.specialisedSeconds, 1.0 / row.fullSeconds, ratioText(row.ratio),
                       differenceText(row.difference));
}

nlohmann::ordered_json jsonOf(const VariantsRow& row) {
    return {{"integrator", row.name()},
            {"kernel", row.kernel},
            {"passes_per_s", 1.0 / row.specialisedSeconds},
            {"full_passes_per_s", 1.0 / row.fullSeconds},
            {"ratio", ratioJson(row.ratio)},
            {"wall_ratio", ratioJson(row.wallRatio)},
            {"pixels", row.difference.pixels},
            {"pixels_different", row.difference.different},
            {"largest_difference", row.difference.largest},
            {"identical", row.difference.identical()}};
}

Result<BenchReport> measureVariants(const BenchSubject& subject) {
    const BenchOptions& options = subject.options;
    BenchReport report;
    report.text = fmt::format("{:<6}{:<24}{:>12}{:>12}   {:<24}{}\n", "", "kernel", "passes/s", "full",
                              "ratio", "pictures");
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const IntegratorKind integrator : {IntegratorKind::PathTracing, IntegratorKind::Sppm}) {
        const auto asked = integratorByName(options.integrator);
        if (asked && *asked != integrator) { continue; }
        const auto row = measureRow(subject, integrator);
        if (!row) { return row.error(); }
        report.text += textOf(*row);
        rows.push_back(jsonOf(*row));
    }
    report.json = {{"scene", options.scene.empty() ? "mesh" : options.scene},
                   {"width", subject.scene->resolution.width},
                   {"height", subject.scene->resolution.height},
                   {"threads", options.threads},
                   {"turns", options.turns},
                   {"rows", rows}};
    return report;
}

}  // namespace

Benchmark variantsBenchmark() {
    return {.name = "variants",
            .about = "The kernels compiled for what a scene needs beside the ones that do everything",
            .defaults = {.turns = 15},
            .options = {{"scene", &BenchOptions::scene,
                         "A scene file; a diffuse mesh of 100,000 triangles by default"},
                        {.name = "--integrator",
                         .member = &BenchOptions::integrator,
                         .help = "One of the two; both by default",
                         .choices = {"path", "pt", "sppm"}},
                        threadsOption(),
                        turnsOption("Passes of each"),
                        sizeOption("Width of the picture; the scene's own by default")},
            .scene = variantsScene,
            .measure = measureVariants};
}

}  // namespace glint
