#include "viewer/commands/render_report.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/base/log.h"
#include "viewer/commands/json_output.h"

namespace glint {
namespace {

bool isSppm(const RenderReport& r) { return r.capture.scene->options.integrator == IntegratorKind::Sppm; }

double pathCount(const Film& film) { return static_cast<double>(film.pixels().size()) * film.passes(); }

void printSummary(const RenderReport& r, double relativeError) {
    const Film& film = r.capture.film;
    const double seconds = r.capture.renderSeconds;
    fmt::print("{}: {}x{}, {} passes in {:.2f} s ({:.2f} Mpaths/s, {}, kernel {}), relative error {}\n",
               r.options.output, film.width(), film.height(), film.passes(), seconds,
               pathCount(film) / seconds * 1e-6, r.status.backend, r.status.kernel,
               std::isfinite(relativeError) ? fmt::format("{:.2f} %", 100.0 * relativeError) : "unknown");
    if (isSppm(r)) {
        const auto emitted = static_cast<double>(r.capture.sppm.emittedPhotons);
        fmt::print("photons: {} a pass, {:.4g} in all ({:.3f} M/s)\n", r.photonsPerPass, emitted,
                   emitted / seconds * 1e-6);
    }
}

void reportFaults(const RenderReport& r) {
    const Film& film = r.capture.film;
    const auto& counts = film.faultCounts();
    const uint64_t dropped = counts[1] + counts[2] + counts[3];
    if (dropped == 0) {
        return;
    }
    fmt::print(stderr, "{} samples were dropped: {} not a number, {} infinite, {} negative\n", dropped,
               counts[1], counts[2], counts[3]);
    if (!film.faults().empty() && !isSppm(r)) {
        const FaultRecord& first = film.faults().front();
        fmt::print(stderr, "  look into the first with: glint render {}{} --pixel {},{} --pass {}\n",
                   quotedForShell(r.options.scene), r.options.sceneOptions, first.x, first.y, first.pass);
    }
}

nlohmann::ordered_json jsonReport(const RenderReport& r, double relativeError) {
    const Film& film = r.capture.film;
    nlohmann::ordered_json faults = nlohmann::ordered_json::array();
    for (const FaultRecord& fault : film.faults()) {
        faults.push_back(
            {{"x", fault.x}, {"y", fault.y}, {"pass", fault.pass}, {"cause", static_cast<int>(fault.fault)}});
    }
    nlohmann::ordered_json report = {{"scene", r.options.scene},
                                     {"output", r.options.output},
                                     {"integrator", isSppm(r) ? "sppm" : "path"},
                                     {"width", film.width()},
                                     {"height", film.height()},
                                     {"passes", film.passes()},
                                     {"load_seconds", r.loadSeconds},
                                     {"build_seconds", r.status.lastBuildSeconds},
                                     {"render_seconds", r.capture.renderSeconds},
                                     {"paths_per_second", pathCount(film) / r.capture.renderSeconds},
                                     {"rays", film.rays()},
                                     {"relative_error", relativeError},
                                     {"backend", r.status.backend},
                                     {"kernel", r.status.kernel},
                                     {"seed", r.capture.scene->options.seed},
                                     {"dropped",
                                      {{"not_a_number", film.faultCounts()[1]},
                                       {"infinite", film.faultCounts()[2]},
                                       {"negative", film.faultCounts()[3]}}},
                                     {"dropped_samples", faults},
                                     {"firefly_clamp", r.capture.scene->options.fireflyClamp}};
    if (isSppm(r)) {
        report["sppm"] = {{"photons_per_pass", r.photonsPerPass},
                          {"photons_asked", r.capture.scene->sppm.photonsPerPass},
                          {"emitted_photons", r.capture.sppm.emittedPhotons},
                          {"bytes", r.capture.sppm.bytes()}};
    }
    return report;
}

}  // namespace

Status reportRender(const RenderReport& r) {
    const double relativeError = isSppm(r) ? r.capture.sppm.relativeErrorEstimate(r.capture.film)
                                           : r.capture.film.relativeErrorEstimate(r.options.threads);
    if (!jsonTakesOutput(r.options.json)) {
        printSummary(r, relativeError);
    }
    reportFaults(r);
    if (const float clamp = r.capture.scene->options.fireflyClamp; clamp > 0.0f) {
        logWarning("samples were clamped to {} (firefly clamp): the picture is biased", clamp);
    }
    return writeJson(r.options.json, jsonReport(r, relativeError));
}

}  // namespace glint
