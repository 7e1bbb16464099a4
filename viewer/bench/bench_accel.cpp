// `glint bench accel`: the acceleration structures beside each other on the same scenes, in turn in one run,
// all by the kernels that have all of them. Two published experiments are among it: one box around a mesh of
// 200 triangles (28.3 to 13.3 s), and a kd-tree over one of 1000 (213 to 94 s).
//
// A pass over a million triangles without a structure takes hours at full size. Each structure's picture is
// as large as it can be within a short pass, and seconds per camera path are compared.
#include <array>
#include <atomic>

#include <fmt/format.h>

#include "engine/builders/scene_builder.h"
#include "engine/render/backend.h"
#include "engine/render/pass_params.h"
#include "engine/render/path_pass.h"
#include "engine/scene/kind_names.h"
#include "viewer/bench/bench.h"
#include "viewer/bench/bench_pairs.h"
#include "viewer/bench/bench_scenes.h"
#include "viewer/bench/bench_statistics.h"

namespace glint {
namespace {

constexpr std::array kKinds{AcceleratorKind::None, AcceleratorKind::Aabb, AcceleratorKind::KdTree,
                            AcceleratorKind::Bvh};
constexpr std::array kStandIns{200u, 1000u, 1'000'000u};
constexpr int kSmallest = 16;
constexpr double kPassSeconds = 0.1;

using ScenePtr = std::shared_ptr<SceneDescription>;

/// One structure over a scene, and pictures of it.
class AcceleratorRun {
  public:
    AcceleratorRun(const SceneDescription& scene, AcceleratorKind kind, const BenchOptions& options)
        : scene_(std::make_shared<SceneDescription>(scene)),
          backend_(makeCpuBackend(options.threads, KernelChoice::Full)) {
        scene_->options.accelerator = kind;
        const Stopwatch stopwatch;
        const auto built =
            buildScene({scene_, EditKind::Everything}, nullptr, options.threads, nullptr, nullptr);
        buildSeconds_ = stopwatch.seconds();
        status_ = built ? backend_->setScene(*built) : Status(built.error());
        if (!status_) { return; }
        setSize(kSmallest);
        (void)secondsPerPath(0);
        first_ = samples_;
        countTests();
        while (secondsPerPath(0) * static_cast<double>(samples_.size()) < kPassSeconds &&
               2 * params_.width <= options.size) {
            setSize(2 * params_.width);
        }
    }

    const Status& status() const { return status_; }
    AcceleratorKind kind() const { return scene_->options.accelerator; }
    double buildSeconds() const { return buildSeconds_; }
    double boxes() const { return boxes_; }
    double primitives() const { return primitives_; }
    const std::vector<PixelSample>& first() const { return first_; }
    const std::vector<double>& times() const { return times_; }

    void measure(uint32_t pass) { times_.push_back(secondsPerPath(pass)); }

  private:
    void setSize(int size) {
        scene_->resolution = {size, size};
        params_ = passParamsOf(*scene_);
    }

    double secondsPerPath(uint32_t pass) {
        params_.pass = pass;
        const Stopwatch stopwatch;
        (void)renderPathPass(*backend_, params_, never_, &samples_);
        return stopwatch.seconds() / static_cast<double>(samples_.size());
    }

    /// Means over the camera rays of the first pass.
    void countTests() {
        std::vector<AovSample> hits;
        (void)backend_->renderAovPass(params_, never_, &hits);
        for (const AovSample& hit : hits) {
            boxes_ += static_cast<double>(hit.boxesTested) / static_cast<double>(hits.size());
            primitives_ += static_cast<double>(hit.primitivesTested) / static_cast<double>(hits.size());
        }
    }

    ScenePtr scene_;
    std::unique_ptr<Backend> backend_;
    std::atomic<bool> never_{false};
    PassParams params_;
    std::vector<PixelSample> samples_, first_;
    std::vector<double> times_;
    double buildSeconds_ = 0.0, boxes_ = 0.0, primitives_ = 0.0;
    Status status_;
};

size_t countDifferent(const std::vector<PixelSample>& a, const std::vector<PixelSample>& b) {
    size_t different = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        different += a[i].radiance == b[i].radiance ? 0 : 1;
    }
    return different;
}

/// The report on one scene, added to both.
Status measureScene(const std::string& name, const SceneDescription& scene, const BenchOptions& options,
                    BenchReport* report) {
    std::vector<std::unique_ptr<AcceleratorRun>> runs;
    for (const AcceleratorKind kind : kKinds) {
        runs.push_back(std::make_unique<AcceleratorRun>(scene, kind, options));
        if (!runs.back()->status()) { return runs.back()->status(); }
    }
    for (uint32_t turn = 0; turn < static_cast<uint32_t>(options.turns); ++turn) {
        for (const auto& run : runs) {
            run->measure(turn);
        }
    }
    report->text += fmt::format("{}\n{:<8}{:>9}{:>14}   {:<28}{:>10}{:>12}{:>9}\n", name, "", "build s",
                                "paths/s", "times as fast as none", "boxes", "triangles", "differ");
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const auto& run : runs) {
        const double pathsPerS = 1.0 / percentilesOf(run->times()).median;
        const RatioInterval ratio = ratioOf(runs[0]->times(), run->times());
        const size_t different = countDifferent(run->first(), runs[0]->first());
        report->text += fmt::format("{:<8}{:>9.3f}{:>14.0f}   {:<28}{:>10.1f}{:>12.1f}{:>9}\n",
                                    nameOf(run->kind()), run->buildSeconds(), pathsPerS, ratioText(ratio),
                                    run->boxes(), run->primitives(), different);
        rows.push_back({{"accelerator", nameOf(run->kind())},
                        {"build_seconds", run->buildSeconds()},
                        {"paths_per_s", pathsPerS},
                        {"ratio_to_none", ratioJson(ratio)},
                        {"boxes_per_camera_ray", run->boxes()},
                        {"triangles_per_camera_ray", run->primitives()},
                        {"pixels_different", different}});
    }
    report->json["scenes"].push_back({{"scene", name}, {"rows", rows}});
    return {};
}

Result<BenchReport> measureAcceleration(const BenchSubject& subject) {
    const BenchOptions& options = subject.options;
    BenchReport report;
    report.json = {
        {"threads", options.threads}, {"turns", options.turns}, {"scenes", nlohmann::ordered_json::array()}};
    std::vector<std::pair<std::string, ScenePtr>> scenes;
    for (const std::string& file : options.scenes) {
        const Result<ScenePtr> scene = benchFile(file);
        if (!scene) { return scene.error(); }
        scenes.emplace_back(file, *scene);
    }
    for (const uint32_t triangles : kStandIns) {
        if (!options.scenes.empty() || triangles > options.triangles) { continue; }
        const Result<ScenePtr> scene = benchMesh(triangles, kSmallest, kSmallest);
        if (!scene) { return scene.error(); }
        scenes.emplace_back(fmt::format("{} triangles", (*scene)->meshes[0].data->triangleCount()), *scene);
    }
    for (const auto& [name, scene] : scenes) {
        if (Status done = measureScene(name, *scene, options, &report); !done) { return done.error(); }
    }
    report.text +=
        "boxes, triangles: tested by a camera ray. differ: pixels of 256, where two are met at once\n"
        "Published: 200 triangles, aabb 2.1 times as fast; 1000 triangles, kdtree 2.3 times.\n";
    return report;
}

}  // namespace

Benchmark accelBenchmark() {
    return {.name = "accel",
            .about = "No acceleration structure, boxes, kd-trees and hierarchies beside each other",
            .defaults = {.size = 256, .turns = 7, .triangles = kStandIns.back()},
            .options = {{"scenes", &BenchOptions::scenes,
                         "Scene files; generated meshes of 200, 1000 and 1000000 triangles by default"},
                        {"--triangles", &BenchOptions::triangles, "Leaves out larger generated meshes", 100,
                         50'000'000},
                        threadsOption(),
                        turnsOption("Passes of each"),
                        sizeOption("The pictures' largest width and height")},
            .scene = nullptr,
            .measure = measureAcceleration,
            .onError = kExitBadInput};
}

}  // namespace glint
