// `glint bench variants`: the kernels compiled for what a scene needs beside the ones that do everything,
// pass by pass in turn on the same threads, and whether their pictures agree. Passes alone, without the film.
//
// The ratio is of processor time: kernels never wait, and what else the machine does hardly counts.
#include <atomic>
#include <chrono>
#include <ctime>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/base/parallel.h"
#include "engine/builders/scene_builder.h"
#include "engine/io/scene_loader.h"
#include "engine/render/backend.h"
#include "engine/render/cpu_variants.h"
#include "engine/render/pass_params.h"
#include "engine/render/sppm_kernel.h"
#include "viewer/commands/bench_pairs.h"
#include "viewer/commands/bench_scenes.h"
#include "viewer/commands/bench_statistics.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/json_output.h"

namespace glint {
namespace {

constexpr uint32_t kMeshTriangles = 100'000;
constexpr int kDefaultSize = 512;

struct VariantsOptions {
    std::string scene;
    std::string integrator;
    int threads = 0;
    int turns = 15;
    int size = 0;
    std::string json;
};

/// Processor time of all threads of this process.
double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// One backend with a picture of its own.
class KernelRun {
  public:
    KernelRun(const SceneDescription& scene, std::shared_ptr<const BuiltScene> built,
              IntegratorKind integrator, int threads, KernelChoice choice)
        : backend_(makeCpuBackend(threads, choice)),
          params_(sppmParamsOf(scene)),
          integrator_(integrator),
          threads_(threads),
          film_(scene.resolution.width, scene.resolution.height) {
        (void)backend_->setScene(std::move(built));
        if (integrator == IntegratorKind::Sppm) {
            sppm_ = SppmState(scene.resolution.width, scene.resolution.height);
        }
    }

    /// Renders and commits a pass; processor time of rendering.
    double renderPass(uint32_t pass) {
        static const std::atomic<bool> never{false};
        params_.pass.pass = pass;
        const auto began = std::chrono::steady_clock::now();
        const double processorBefore = processorSeconds();
        const auto done = integrator_ == IntegratorKind::Sppm
                              ? backend_->renderSppmPass(params_, never, &sppm_, &samples_)
                              : backend_->renderPass(params_.pass, never, &samples_);
        const double processor = processorSeconds() - processorBefore;
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
        if (pass > 0) { wallSeconds_.push_back(took.count()); }
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

    const char* name() const { return integrator == IntegratorKind::Sppm ? "sppm" : "path"; }
};

/// The scene at the asked-for width, in its own shape.
Result<std::shared_ptr<SceneDescription>> sceneOf(const VariantsOptions& options) {
    if (options.scene.empty()) {
        const int size = options.size > 0 ? options.size : kDefaultSize;
        return benchMesh(kMeshTriangles, size, size);
    }
    Result<SceneDescription> loaded = loadScene(options.scene, {});
    if (!loaded) { return loaded.error(); }
    auto scene = std::make_shared<SceneDescription>(std::move(*loaded));
    if (options.size > 0) {
        Resolution& image = scene->resolution;
        image.height = std::max(1, image.height * options.size / image.width);
        image.width = options.size;
    }
    return scene;
}

Result<VariantsRow> measure(const SceneDescription& scene, const std::shared_ptr<const BuiltScene>& built,
                            IntegratorKind integrator, int threads, int turns) {
    KernelRun specialised(scene, built, integrator, threads, KernelChoice::Specialised);
    KernelRun full(scene, built, integrator, threads, KernelChoice::Full);
    const PairTimes times = measureByTurns(
        turns, [&](uint32_t pass) { return specialised.renderPass(pass); },
        [&](uint32_t pass) { return full.renderPass(pass); });
    for (const KernelRun* run : {&specialised, &full}) {
        if (!run->status()) { return run->status().error(); }
    }
    VariantsRow row;
    row.integrator = integrator;
    row.kernel = integrator == IntegratorKind::Sppm ? chooseSppmVariant(built->features).name
                                                    : chooseVariant(built->features).name;
    row.specialisedSeconds = percentilesOf(specialised.wallSeconds()).median;
    row.fullSeconds = percentilesOf(full.wallSeconds()).median;
    row.ratio = ratioOf(times.second, times.first);
    row.wallRatio = ratioOf(full.wallSeconds(), specialised.wallSeconds());
    row.difference = compareImages(specialised.film(), full.film(), specialised.sppm(), full.sppm());
    return row;
}

void print(const std::vector<VariantsRow>& rows) {
    fmt::print("{:<6}{:<24}{:>12}{:>12}   {:<24}{}\n", "", "kernel", "passes/s", "full", "ratio", "pictures");
    for (const VariantsRow& row : rows) {
        fmt::print("{:<6}{:<24}{:>12.2f}{:>12.2f}   {:<24}{}\n", row.name(), row.kernel,
                   1.0 / row.specialisedSeconds, 1.0 / row.fullSeconds, ratioText(row.ratio),
                   differenceText(row.difference));
    }
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

int runVariants(const VariantsOptions& options) {
    const auto scene = sceneOf(options);
    if (!scene) { return reportError(scene.error(), kExitBadInput); }
    const int threads = options.threads > 0 ? options.threads : defaultThreadCount();
    const auto built = buildScene({*scene, EditKind::Everything}, nullptr, threads, nullptr, nullptr);
    if (!built) { return reportError(built.error(), kExitBadInput); }
    std::vector<VariantsRow> rows;
    for (const IntegratorKind integrator : {IntegratorKind::PathTracing, IntegratorKind::Sppm}) {
        const char* name = integrator == IntegratorKind::Sppm ? "sppm" : "path";
        if (!options.integrator.empty() && options.integrator != name) { continue; }
        const auto row = measure(**scene, *built, integrator, threads, options.turns);
        if (!row) { return reportError(row.error(), kExitFailed); }
        rows.push_back(*row);
    }
    if (!jsonTakesOutput(options.json)) { print(rows); }
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const VariantsRow& row : rows) {
        list.push_back(jsonOf(row));
    }
    const Status written = writeJson(options.json, {{"scene", options.scene.empty() ? "mesh" : options.scene},
                                                    {"width", (*scene)->resolution.width},
                                                    {"height", (*scene)->resolution.height},
                                                    {"threads", threads},
                                                    {"turns", options.turns},
                                                    {"rows", list}});
    return written ? kExitDone : reportError(written.error(), kExitFailed);
}

}  // namespace

void addBenchVariants(CLI::App& bench, int* exitCode) {
    CLI::App* command = bench.add_subcommand(
        "variants", "The kernels compiled for what a scene needs beside the ones that do everything");
    const auto options = std::make_shared<VariantsOptions>();
    command->add_option("scene", options->scene,
                        "A scene file; a diffuse mesh of 100,000 triangles by default");
    command->add_option("--integrator", options->integrator, "One of the two; both by default")
        ->check(CLI::IsMember({"path", "sppm"}));
    command->add_option("--threads", options->threads, "All by default")->check(CLI::Range(1, 1024));
    command->add_option("--turns", options->turns, "Passes of each")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--size", options->size, "Width of the picture; the scene's own by default")
        ->check(CLI::Range(16, 8192));
    addJsonOption(*command, &options->json);
    command->callback([options, exitCode] { *exitCode = runVariants(*options); });
}

}  // namespace glint
