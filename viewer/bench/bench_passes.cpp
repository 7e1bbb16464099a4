// `glint bench passes`: SPPM passes per second and where their time goes, by default on a Cornell box with a
// mirror and a glass sphere. Whole passes, film included, after two that warm up; medians.
#include <atomic>

#include <fmt/format.h>

#include "engine/builders/power_distribution.h"
#include "engine/render/cpu_sppm.h"
#include "engine/render/film.h"
#include "engine/render/pass_params.h"
#include "viewer/bench/bench.h"
#include "viewer/bench/bench_scenes.h"
#include "viewer/bench/bench_statistics.h"

namespace glint {
namespace {

constexpr int kWarmUpPasses = 2;

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

Result<std::shared_ptr<SceneDescription>> passesScene(const BenchOptions& options) {
    auto scene =
        options.scene.empty() ? benchGlassAndMirror(options.size, options.size) : benchFile(options.scene);
    if (!scene) { return scene.error(); }
    (*scene)->options.integrator = IntegratorKind::Sppm;
    if (options.photons > 0) { (*scene)->sppm.photonsPerPass = options.photons; }
    if (!options.lookup.empty()) {
        (*scene)->sppm.lookup = options.lookup == "tree" ? PhotonLookupKind::Tree : PhotonLookupKind::Grid;
    }
    return scene;
}

Result<PassesResult> renderPasses(const BuiltScene& built, SppmParams params, const BenchOptions& options) {
    const std::atomic<bool> never{false};
    const SceneView view = built.view();
    const PowerDistribution power = buildPowerDistribution(view);
    CpuSppm sppm(options.threads);
    SppmState state(params.pass.width, params.pass.height);
    Film film(params.pass.width, params.pass.height);
    std::vector<PixelSample> direct;
    PassesResult result;
    std::vector<double> seconds;
    for (int pass = 0; pass < options.passes + kWarmUpPasses; ++pass) {
        params.pass.pass = static_cast<uint32_t>(pass);
        const Stopwatch whole;
        const auto done = sppm.renderPass(view, built.features, power.view(), params, never, &state, &direct);
        if (!done) { return done.error(); }
        const Stopwatch committing;
        film.commit(direct, params.pass.pass, options.threads);
        if (pass < kWarmUpPasses) { continue; }
        const double commitSeconds = committing.seconds();
        seconds.push_back(whole.seconds());
        const SppmPassStats& s = sppm.stats();
        const double stages[] = {s.cameraSeconds, s.photonSeconds, s.sortSeconds, s.gatherSeconds,
                                 commitSeconds};
        for (size_t i = 0; i < result.stages.size(); ++i) {
            result.stages[i].seconds.push_back(stages[i]);
        }
    }
    for (Stage& stage : result.stages) {
        stage.median = percentilesOf(stage.seconds).median;
    }
    result.pass = percentilesOf(std::move(seconds));
    result.last = sppm.stats();
    result.kernel = chooseVariant(sppmVariants(), built.features, params.pass.sampler).name;
    result.pixelBytes = state.pixels.size() * kSppmBytesPerPixel;
    return result;
}

Result<BenchReport> measurePasses(const BenchSubject& subject) {
    const BenchOptions& options = subject.options;
    const SppmParams params = sppmParamsOf(*subject.scene);
    const auto result = renderPasses(*subject.built, params, options);
    if (!result) { return result.error(); }
    const PassesResult& r = *result;
    const char* lookup = params.lookup == PhotonLookupKind::Tree ? "tree" : "grid";
    BenchReport report;
    report.text =
        fmt::format("kernel          {}, {}\nthreads         {}\n", r.kernel, lookup, options.threads) +
        fmt::format("passes          {:.2f} /s, {}x{} pixels, {} photons a pass\n", 1.0 / r.pass.median,
                    params.pass.width, params.pass.height, params.photonsPerPass) +
        fmt::format("one pass        {}\n", percentilesText(r.pass));
    nlohmann::ordered_json stages = nlohmann::ordered_json::object();
    for (const Stage& stage : r.stages) {
        stages[stage.name] = stage.median * 1e3;
        report.text += fmt::format("  {:<14}{:8.1f} ms  {:4.1f} %\n", stage.name, stage.median * 1e3,
                                   100.0 * stage.median / r.stageSum());
    }
    report.text +=
        fmt::format("stored photons  {} in {:.1f} MB; {:.1f} MB for pixels\n", r.last.storedPhotons,
                    static_cast<double>(r.last.photonBytes) * 1e-6, static_cast<double>(r.pixelBytes) * 1e-6);
    report.json = {{"scene", options.scene.empty() ? "cornell, mirror and glass" : options.scene},
                   {"kernel", r.kernel},
                   {"lookup", lookup},
                   {"width", params.pass.width},
                   {"height", params.pass.height},
                   {"threads", options.threads},
                   {"passes", options.passes},
                   {"photons_per_pass", params.photonsPerPass},
                   {"passes_per_s", 1.0 / r.pass.median},
                   {"pass", percentilesJson(r.pass)},
                   {"stages_ms", stages},
                   {"gather_share", r.stages[3].median / r.stageSum()},
                   {"stored_photons", r.last.storedPhotons},
                   {"photon_bytes", r.last.photonBytes},
                   {"pixel_bytes", r.pixelBytes}};
    return report;
}

}  // namespace

Benchmark passesBenchmark() {
    return {.name = "passes",
            .about = "Photon mapping: passes per second and the time of each stage",
            .defaults = {.size = 512, .passes = 20},
            .options = {{"scene", &BenchOptions::scene,
                         "A scene file at its own size; a Cornell box with mirror and glass by default"},
                        threadsOption(),
                        passesOption(),
                        sizeOption("The Cornell box's width and height"),
                        {"--photons", &BenchOptions::photons,
                         "Photons a pass; the scene's own number by default", 1, 1 << 30},
                        {.name = "--lookup",
                         .member = &BenchOptions::lookup,
                         .help = "How photons are found",
                         .choices = {"grid", "tree"}}},
            .scene = passesScene,
            .measure = measurePasses};
}

}  // namespace glint
