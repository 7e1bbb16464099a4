// `glint bench passes`: SPPM passes per second and where their time goes, by default on a Cornell box with a
// mirror and a glass sphere. Whole passes, film included, after two that warm up; medians.
#include <atomic>
#include <chrono>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/base/parallel.h"
#include "engine/builders/power_distribution.h"
#include "engine/builders/scene_builder.h"
#include "engine/io/scene_loader.h"
#include "engine/render/cpu_sppm.h"
#include "engine/render/pass_params.h"
#include "viewer/commands/bench_scenes.h"
#include "viewer/commands/bench_statistics.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/json_output.h"

namespace glint {
namespace {

constexpr int kWarmUpPasses = 2;

struct PassesOptions {
    std::string scene;
    int threads = 0;
    int passes = 20;
    int size = 512;
    uint32_t photons = 0;
    std::string lookup;
    std::string json;
};

struct Stage {
    const char* name;
    std::vector<double> seconds;
    double median = 0.0;
};

struct PassesResult {
    Percentiles pass;
    std::array<Stage, 5> stages{
        {{"camera", {}}, {"photons", {}}, {"sort", {}}, {"gather", {}}, {"commit", {}}}};
    SppmPassStats last;
    const char* kernel = "";
    size_t pixelBytes = 0;

    double stageSum() const {
        double sum = 0.0;
        for (const Stage& stage : stages) {
            sum += stage.median;
        }
        return sum;
    }
};

Result<std::shared_ptr<SceneDescription>> sceneOf(const PassesOptions& options) {
    std::shared_ptr<SceneDescription> scene;
    if (options.scene.empty()) {
        scene = benchGlassAndMirror(options.size, options.size);
    } else {
        Result<SceneDescription> loaded = loadScene(options.scene, {});
        if (!loaded) { return loaded.error(); }
        scene = std::make_shared<SceneDescription>(std::move(*loaded));
    }
    scene->options.integrator = IntegratorKind::Sppm;
    if (options.photons > 0) { scene->sppm.photonsPerPass = options.photons; }
    if (!options.lookup.empty()) {
        scene->sppm.lookup = options.lookup == "tree" ? PhotonLookupKind::Tree : PhotonLookupKind::Grid;
    }
    return scene;
}

Result<PassesResult> measure(const BuiltScene& built, SppmParams params, const PassesOptions& options,
                             int threads) {
    using Clock = std::chrono::steady_clock;
    const auto since = [](Clock::time_point t) {
        return std::chrono::duration<double>(Clock::now() - t).count();
    };
    const std::atomic<bool> never{false};
    const SceneView view = built.view();
    const PowerDistribution power = buildPowerDistribution(view);
    CpuSppm sppm(threads);
    SppmState state(params.pass.width, params.pass.height);
    Film film(params.pass.width, params.pass.height);
    std::vector<PixelSample> direct;
    PassesResult result;
    std::vector<double> seconds;
    for (int pass = 0; pass < options.passes + kWarmUpPasses; ++pass) {
        params.pass.pass = static_cast<uint32_t>(pass);
        const auto began = Clock::now();
        const auto done = sppm.renderPass(view, built.features, power.view(), params, never, &state, &direct);
        if (!done) { return done.error(); }
        const auto rendered = Clock::now();
        film.commit(direct, params.pass.pass, threads);
        if (pass < kWarmUpPasses) { continue; }
        seconds.push_back(since(began));
        const SppmPassStats& s = sppm.stats();
        const double stages[] = {s.cameraSeconds, s.photonSeconds, s.sortSeconds, s.gatherSeconds,
                                 since(rendered)};
        for (size_t i = 0; i < result.stages.size(); ++i) {
            result.stages[i].seconds.push_back(stages[i]);
        }
    }
    for (Stage& stage : result.stages) {
        stage.median = percentilesOf(stage.seconds).median;
    }
    result.pass = percentilesOf(std::move(seconds));
    result.last = sppm.stats();
    result.kernel = sppm.variant(params, built.features).name;
    result.pixelBytes = state.pixels.size() * kSppmBytesPerPixel;
    return result;
}

Status report(const PassesOptions& options, const SppmParams& params, const PassesResult& r, int threads) {
    const double share = r.stages[3].median / r.stageSum();
    const char* lookup = params.lookup == PhotonLookupKind::Tree ? "tree" : "grid";
    nlohmann::ordered_json stages = nlohmann::ordered_json::object();
    for (const Stage& stage : r.stages) {
        stages[stage.name] = stage.median * 1e3;
    }
    if (!jsonTakesOutput(options.json)) {
        fmt::print("kernel          {}, {}\nthreads         {}\n", r.kernel, lookup, threads);
        fmt::print("passes          {:.2f} /s, {}x{} pixels, {} photons a pass\n", 1.0 / r.pass.median,
                   params.pass.width, params.pass.height, params.photonsPerPass);
        fmt::print("one pass        {}\n", percentilesText(r.pass));
        for (const Stage& stage : r.stages) {
            fmt::print("  {:<14}{:8.1f} ms  {:4.1f} %\n", stage.name, stage.median * 1e3,
                       100.0 * stage.median / r.stageSum());
        }
        fmt::print("stored photons  {} in {:.1f} MB; {:.1f} MB for pixels\n", r.last.storedPhotons,
                   static_cast<double>(r.last.photonBytes) * 1e-6, static_cast<double>(r.pixelBytes) * 1e-6);
    }
    return writeJson(options.json,
                     {{"scene", options.scene.empty() ? "cornell, mirror and glass" : options.scene},
                      {"kernel", r.kernel},
                      {"lookup", lookup},
                      {"width", params.pass.width},
                      {"height", params.pass.height},
                      {"threads", threads},
                      {"passes", options.passes},
                      {"photons_per_pass", params.photonsPerPass},
                      {"passes_per_s", 1.0 / r.pass.median},
                      {"pass", percentilesJson(r.pass)},
                      {"stages_ms", stages},
                      {"gather_share", share},
                      {"stored_photons", r.last.storedPhotons},
                      {"photon_bytes", r.last.photonBytes},
                      {"pixel_bytes", r.pixelBytes}});
}

int runPasses(const PassesOptions& options) {
    const auto scene = sceneOf(options);
    if (!scene) { return reportError(scene.error(), kExitBadInput); }
    const int threads = options.threads > 0 ? options.threads : defaultThreadCount();
    const auto built = buildScene({*scene, EditKind::Everything}, nullptr, threads, nullptr, nullptr);
    if (!built) { return reportError(built.error(), kExitBadInput); }
    const SppmParams params = sppmParamsOf(**scene);
    const auto result = measure(**built, params, options, threads);
    if (!result) { return reportError(result.error(), kExitFailed); }
    const Status written = report(options, params, *result, threads);
    return written ? kExitDone : reportError(written.error(), kExitFailed);
}

}  // namespace

void addBenchPasses(CLI::App& bench, int* exitCode) {
    CLI::App* command =
        bench.add_subcommand("passes", "Photon mapping: passes per second and the time of each stage");
    const auto options = std::make_shared<PassesOptions>();
    command->add_option("scene", options->scene,
                        "A scene file at its own size; a Cornell box with mirror and glass by default");
    command->add_option("--threads", options->threads, "All by default")->check(CLI::Range(1, 1024));
    command->add_option("--passes", options->passes, "Measured passes")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->add_option("--size", options->size, "The Cornell box's width and height")
        ->check(CLI::Range(16, 8192))
        ->capture_default_str();
    command->add_option("--photons", options->photons, "Photons a pass; the scene's own number by default")
        ->check(CLI::Range(1, 1 << 30));
    command->add_option("--lookup", options->lookup, "How photons are found")
        ->check(CLI::IsMember({"grid", "tree"}));
    addJsonOption(*command, &options->json);
    command->callback([options, exitCode] { *exitCode = runPasses(*options); });
}

}  // namespace glint
