#include "viewer/commands/render_report.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/base/console.h"
#include "engine/base/log.h"
#include "engine/io/file_path.h"
#include "engine/render/error_estimate.h"
#include "engine/render/sppm_state.h"
#include "viewer/commands/json_output.h"

namespace glint {
namespace {

IntegratorKind integratorOf(const RenderReport& r) { return r.capture.scene->options.integrator; }

double pathCount(const Film& film) { return static_cast<double>(film.pixels().size()) * film.passes(); }

std::string describe(const ErrorEstimate& error) {
    if (!std::isfinite(error.relative)) { return "unknown"; }
    return fmt::format("{:.2f} % ({:.2f} to {:.2f})", 100.0 * error.relative, 100.0 * error.low,
                       100.0 * error.high);
}

void printSummary(const RenderReport& r, const ErrorEstimate& error) {
    const Film& film = r.capture.film;
    const double seconds = r.capture.renderSeconds;
    put("{}: {}x{}, {} passes in {:.2f} s ({:.2f} Mpaths/s, {}, kernel {}), picture error {}\n",
        r.options.output, film.width(), film.height(), film.passes(), seconds,
        pathCount(film) / seconds * 1e-6, r.status.backend, r.status.kernel, describe(error));
    if (hasExtension(r.options.output, ".png") && !statedExposure(r.options) && r.exposureStops != 0.0f) {
        put("exposure {:+.2f} stops: the picture is {} without (--exposure, --no-auto-exposure)\n",
            r.exposureStops, r.exposureStops < 0.0f ? "white" : "black");
    }
    if (r.denoiseSeconds) {
        put("denoised in {:.2f} s; the picture error is that of the film\n", *r.denoiseSeconds);
    }
    if (const SppmState* photons = asSppm(r.capture.statistics.get())) {
        const auto emitted = static_cast<double>(photons->emittedPhotons);
        put("photons: {} a pass, {:.4g} in all ({:.3f} M/s)\n", r.photonsPerPass, emitted,
            emitted / seconds * 1e-6);
    }
}

void reportFaults(const RenderReport& r) {
    const Film& film = r.capture.film;
    const auto& counts = film.faultCounts();
    const uint64_t dropped = counts[1] + counts[2] + counts[3];
    if (dropped == 0) { return; }
    say("{} samples were dropped: {} not a number, {} infinite, {} negative\n", dropped, counts[1], counts[2],
        counts[3]);
    if (!film.faults().empty() && integratorOf(r) == IntegratorKind::PathTracing) {
        const FaultRecord& first = film.faults().front();
        say("  look into the first with: glint render {}{} --pixel {},{} --pass {}\n",
            quotedForShell(r.options.scene), r.options.sceneOptions, first.x, first.y, first.pass);
    }
}

/// What --error would have taken, where another limit or Ctrl-C came first.
void printTimeToError(const RenderReport& r, const ErrorEstimate& error) {
    const double target = r.options.limits.relativeError;
    if (!(target > 0.0) || hasReached(r.capture.curve, target)) { return; }
    if (error.high <= target) {
        put("an error below {:g} % is confirmed by more passes only\n", 100.0 * target);
    } else if (const auto ahead = forecastError(r.capture.curve, target)) {
        put("an error below {:g} % would take about {:.3g} s more ({:.3g} to {:.3g})\n", 100.0 * target,
            ahead->secondsLeft, ahead->secondsLow, ahead->secondsHigh);
    } else {
        put("how long an error below {:g} % would take is not known yet\n", 100.0 * target);
    }
}

/// Null without --error, and while it cannot be known.
nlohmann::ordered_json timeToError(const RenderReport& r) {
    const auto ahead = forecastError(r.capture.curve, r.options.limits.relativeError);
    if (!ahead) { return nullptr; }
    return {{"target", r.options.limits.relativeError},
            {"seconds_left", ahead->secondsLeft},
            {"seconds_low", ahead->secondsLow},
            {"seconds_high", ahead->secondsHigh},
            {"slope", ahead->slope}};
}

nlohmann::ordered_json convergence(const ConvergenceCurve& curve) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    for (const ConvergencePoint& point : curve.points()) {
        points.push_back({{"passes", point.passes},
                          {"render_seconds", point.renderSeconds},
                          {"relative_error", point.relativeError},
                          {"relative_error_low", point.relativeErrorLow},
                          {"relative_error_high", point.relativeErrorHigh},
                          {"relative_bias", point.relativeBias}});
    }
    return points;
}

nlohmann::ordered_json jsonReport(const RenderReport& r, const ErrorEstimate& error) {
    const Film& film = r.capture.film;
    nlohmann::ordered_json faults = nlohmann::ordered_json::array();
    for (const FaultRecord& fault : film.faults()) {
        faults.push_back(
            {{"x", fault.x}, {"y", fault.y}, {"pass", fault.pass}, {"cause", static_cast<int>(fault.fault)}});
    }
    nlohmann::ordered_json report = {{"scene", r.options.scene},
                                     {"output", r.options.output},
                                     {"integrator", integratorInfo(integratorOf(r)).key},
                                     {"width", film.width()},
                                     {"height", film.height()},
                                     {"passes", film.passes()},
                                     {"load_seconds", r.loadSeconds},
                                     {"build_seconds", r.status.lastBuildSeconds},
                                     {"render_seconds", r.capture.renderSeconds},
                                     {"paths_per_second", pathCount(film) / r.capture.renderSeconds},
                                     {"rays", film.rays()},
                                     {"relative_error", error.relative},
                                     {"relative_error_low", error.low},
                                     {"relative_error_high", error.high},
                                     {"wholly_wrong", error.whollyWrong},
                                     {"relative_bias", error.bias},
                                     {"time_to_error", timeToError(r)},
                                     {"convergence", convergence(r.capture.curve)},
                                     {"backend", r.status.backend},
                                     {"kernel", r.status.kernel},
                                     {"seed", r.capture.scene->options.seed},
                                     {"exposure_stops", r.exposureStops},
                                     {"dropped",
                                      {{"not_a_number", film.faultCounts()[1]},
                                       {"infinite", film.faultCounts()[2]},
                                       {"negative", film.faultCounts()[3]}}},
                                     {"dropped_samples", faults},
                                     {"firefly_clamp", r.capture.scene->options.fireflyClamp}};
    if (r.denoiseSeconds) { report["denoise_seconds"] = *r.denoiseSeconds; }
    if (const SppmState* photons = asSppm(r.capture.statistics.get())) {
        report["sppm"] = {{"photons_per_pass", r.photonsPerPass},
                          {"photons_asked", r.capture.scene->sppm.photonsPerPass},
                          {"emitted_photons", photons->emittedPhotons},
                          {"bytes", photons->bytes()}};
    }
    return report;
}

}  // namespace

Status reportRender(const RenderReport& r) {
    const ErrorEstimate error = estimateError(r.capture.film, r.capture.statistics.get(), r.options.threads);
    if (!jsonTakesOutput(r.options.json)) {
        printSummary(r, error);
        printTimeToError(r, error);
    }
    reportFaults(r);
    if (const float clamp = r.capture.scene->options.fireflyClamp; clamp > 0.0f) {
        logWarning("samples were clamped to {} (firefly clamp): the picture is biased", clamp);
    }
    return r.options.json.empty() ? Status() : writeJson(r.options.json, "render", jsonReport(r, error));
}

}  // namespace glint
