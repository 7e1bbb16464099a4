#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/report/convergence_report.h"
#include "engine/scene/kind_names.h"

namespace glint {
namespace {

using Json = nlohmann::ordered_json;

std::string number(double value) { return std::isfinite(value) ? fmt::to_string(value) : std::string(); }

Json json(const Spread& spread) { return {{"mean", spread.mean}, {"sd", spread.deviation}}; }

Json pointJson(const SummaryPoint& point) {
    Json out = {{"passes", point.passes}, {"seeds", point.seeds}, {"seconds", json(point.seconds)}};
    for (size_t m = 0; m < kErrorMeasureCount; ++m) {
        out[std::string(kMeasureNames[m].key)] = json(point.errors[m]);
    }
    return out;
}

Json fitJson(const VariantSummary& variant) {
    if (!variant.fit) { return nullptr; }
    const LogLogFit& fit = *variant.fit;
    return {{"slope", fit.slope},
            {"slope_low", fit.slopeLow},
            {"slope_high", fit.slopeHigh},
            {"confidence", 0.95},
            {"interval_method", fit.fromSeeds ? "student_over_seeds" : "regression_residuals"},
            {"curves", fit.curves},
            {"points", fit.points},
            {"from_seconds", variant.fitFromSeconds},
            {"points_near_reference_left_out", variant.leftOutOfFit}};
}

Json targetsJson(const ConvergenceReport& report, const VariantSummary& variant) {
    Json out = Json::array();
    for (size_t i = 0; i < kTargetErrors.size(); ++i) {
        const TimeToReach& time = variant.targets[i];
        Json target = {{"relative_error", kTargetErrors[i]}, {"status", nameOf(time.kind)}};
        target["seconds"] = time.kind == TimeToReach::Kind::Never ? Json() : Json(time.seconds);
        if (time.kind == TimeToReach::Kind::Predicted) {
            target["seconds_low"] = time.low;
            target["seconds_high"] = time.high;
        }
        target["below_reference_error"] = kTargetErrors[i] < report.summary.floor;
        out.push_back(target);
    }
    return out;
}

Json settingsJson(const ConvergenceReport& report, const VariantSettings& settings) {
    Json out = {{"threads", settings.threads > 0 ? settings.threads : report.context.threads},
                {"sampler", nameOf(settings.options.sampler)},
                {"max_depth", settings.options.maxDepth},
                {"roulette_start_depth", settings.options.rouletteStartDepth},
                {"firefly_clamp", settings.options.fireflyClamp},
                {"kernel", settings.fullKernel ? "full" : "specialised"}};
    if (settings.options.integrator == IntegratorKind::Sppm) {
        const SppmOptions& sppm = settings.sppm;
        out["photons_per_pass"] = sppm.photonsPerPass;
        out["alpha"] = sppm.alpha;
        out["radius"] = sppm.radiusWorld;
        out["radius_footprints"] = sppm.radiusFootprints;
        out["lookup"] = nameOf(sppm.lookup);
        out["direct"] = sppm.sampleDirectLight ? "sampled" : "photons";
    }
    return out;
}

Json variantJson(const ConvergenceReport& report, size_t index) {
    const MeasuredVariant& measured = report.result.variants[index];
    const VariantSummary& summary = report.summary.variants[index];
    Json curve = Json::array();
    for (const SummaryPoint& point : summary.points) {
        curve.push_back(pointJson(point));
    }
    Json images = Json::array();
    for (const KeptImage& image : measured.images) {
        const MeasuredPoint& point = measured.curves.front().points[image.point];
        images.push_back({{"passes", point.passes},
                          {"seconds", point.seconds},
                          {"file", image.file},
                          {"error_file", image.errorFile}});
    }
    return {{"name", measured.variant.name},
            {"text", measured.variant.text},
            {"integrator", integratorInfo(measured.variant.integrator).key},
            {"backend", measured.backend},
            {"kernel", measured.kernel},
            {"settings", settingsJson(report, measured.settings)},
            {"same_method_as_reference", summary.sameMethodAsReference},
            {"problem", measured.problem.empty() ? Json() : Json(measured.problem)},
            {"dropped_samples", measured.droppedSamples},
            {"curve", curve},
            {"fit", fitJson(summary)},
            {"time_to", targetsJson(report, summary)},
            {"final",
             {{"seeds", measured.finalSeeds},
              {"variance", summary.variance},
              {"bias_squared", summary.biasSquared},
              {"efficiency", summary.efficiency},
              {"relative_efficiency", summary.relativeEfficiency}}},
            {"pictures", images}};
}

Json referenceJson(const ConvergenceReport& report) {
    const ReferenceImage& reference = report.reference;
    const bool known = reference.knowsItsError();
    return {{"file", reference.path},
            {"method", reference.method.empty() ? Json() : Json(reference.method)},
            {"seeds", reference.seeds},
            {"render_seconds", reference.renderSeconds},
            {"passes", reference.passes},
            {"ended_by", reference.endedBy.empty() ? Json() : Json(reference.endedBy)},
            {"cached", reference.cached},
            {"mean", reference.mean},
            {"standard_error", known ? Json(reference.rmse()) : Json()},
            {"mse", known ? Json(reference.mse) : Json()},
            {"rel_mse", known ? Json(reference.relMse) : Json()},
            {"relative_error", report.summary.floor},
            {"smallest_error_reported", report.summary.smallestError},
            {"ratio_to_smallest_error", report.summary.floorRatio},
            {"subtracted", report.summary.withoutReference},
            {"remarks", reference.remarks}};
}

}  // namespace

const char* nameOf(TimeToReach::Kind kind) {
    switch (kind) {
        case TimeToReach::Kind::Never:
            return "not_reached";
        case TimeToReach::Kind::Before:
            return "before_first_measurement";
        case TimeToReach::Kind::Measured:
            return "measured";
        case TimeToReach::Kind::Predicted:
            return "predicted";
    }
    return "";
}

std::string secondsText(double seconds) {
    return seconds < 1000.0 ? fmt::format("{:.3g}", seconds) : fmt::format("{:.0f}", seconds);
}

std::vector<std::string> reportWarnings(const ConvergenceReport& report) {
    std::vector<std::string> out = report.context.warnings;
    out.insert(out.end(), report.reference.remarks.begin(), report.reference.remarks.end());
    if (report.result.interrupted) {
        out.emplace_back("The run was interrupted: some seeds or points are missing.");
    }
    bool same = false;
    for (size_t i = 0; i < report.result.variants.size(); ++i) {
        const MeasuredVariant& variant = report.result.variants[i];
        same = same || report.summary.variants[i].sameMethodAsReference;
        if (!variant.problem.empty()) {
            out.push_back(fmt::format("{}: {}", variant.variant.name, variant.problem));
        }
        if (variant.droppedSamples > 0) {
            out.push_back(fmt::format("{}: {} samples were not finite or negative and were dropped.",
                                      variant.variant.name, variant.droppedSamples));
        }
        if (variant.settings.options.fireflyClamp > 0.0f) {
            out.push_back(fmt::format("{}: samples were clamped to {}: it converges to a darker picture.",
                                      variant.variant.name, variant.settings.options.fireflyClamp));
        }
    }
    if (same) {
        out.push_back(fmt::format(
            "The reference was made by {}: variants of the same method are marked *. What that method cannot "
            "find is missing on both sides, and counts as no error.",
            report.reference.method));
    }
    if (report.summary.floorRatio > 0.1) {
        const double times = std::pow(10.0 * report.summary.floorRatio, 2.0);
        const double needed = times * report.reference.renderSeconds;
        out.push_back(fmt::format(
            "The reference's own error is {:.0f} % of the smallest error measured, more than a tenth: small "
            "errors are "
            "overstated.{}",
            100.0 * report.summary.floorRatio,
            needed > 0.0 ? fmt::format(" A tenth would take one of about {} s.", secondsText(needed)) : ""));
    }
    return out;
}

std::string curveCsv(const ConvergenceReport& report) {
    std::string out = "variant,seed,point,passes,seconds";
    for (const MeasureName& name : kMeasureNames) {
        out += fmt::format(",{}", name.key);
    }
    out += "\n";
    for (const MeasuredVariant& variant : report.result.variants) {
        for (const MeasuredCurve& curve : variant.curves) {
            for (size_t i = 0; i < curve.points.size(); ++i) {
                const MeasuredPoint& point = curve.points[i];
                out += fmt::format("{},{},{},{},{}", variant.variant.name, curve.seed, i, point.passes,
                                   point.seconds);
                for (const double value : point.errors) {
                    out += "," + number(value);
                }
                out += "\n";
            }
        }
    }
    return out;
}

std::string summaryCsv(const ConvergenceReport& report) {
    std::string out = "variant,point,passes,seeds,seconds_mean,seconds_sd";
    for (const MeasureName& name : kMeasureNames) {
        out += fmt::format(",{0}_mean,{0}_sd", name.key);
    }
    out += "\n";
    for (size_t v = 0; v < report.result.variants.size(); ++v) {
        const std::vector<SummaryPoint>& points = report.summary.variants[v].points;
        for (size_t i = 0; i < points.size(); ++i) {
            out += fmt::format("{},{},{},{},{},{}", report.result.variants[v].variant.name, i,
                               points[i].passes, points[i].seeds, number(points[i].seconds.mean),
                               number(points[i].seconds.deviation));
            for (const Spread& spread : points[i].errors) {
                out += fmt::format(",{},{}", number(spread.mean), number(spread.deviation));
            }
            out += "\n";
        }
    }
    return out;
}

std::string summaryJson(const ConvergenceReport& report) {
    Json variants = Json::array();
    for (size_t i = 0; i < report.result.variants.size(); ++i) {
        variants.push_back(variantJson(report, i));
    }
    const ConvergenceContext& context = report.context;
    const ConvergencePlan& plan = report.plan;
    const Json out = {{"program", "glint converge"},
                      {"version", GLINT_VERSION},
                      {"command", context.command},
                      {"date", context.date},
                      {"scene", context.scene},
                      {"title", context.title},
                      {"width", report.scene.resolution.width},
                      {"height", report.scene.resolution.height},
                      {"machine",
                       {{"processor", context.processor},
                        {"processors", context.processors},
                        {"threads", context.threads}}},
                      {"plan",
                       {{"seconds", plan.seconds > 0.0 ? Json(plan.seconds) : Json()},
                        {"passes", plan.passes > 0 ? Json(plan.passes) : Json()},
                        {"points", plan.points},
                        {"seeds", plan.seeds}}},
                      {"seconds_meaning", kSecondsMeaning},
                      {"interrupted", report.result.interrupted},
                      {"warnings", reportWarnings(report)},
                      {"reference", referenceJson(report)},
                      {"variants", variants}};
    return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace glint
