#include "engine/report/convergence_charts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/render/integrator.h"

namespace glint {
namespace {

/// The reference's own share of a measure; NaN: not known.
double floorOf(const ConvergenceReport& report, ErrorMeasure measure) {
    const ReferenceImage& reference = report.reference;
    if (!reference.knowsItsError()) { return std::nan(""); }
    switch (measure) {
        case ErrorMeasure::RelativeError:
            return report.summary.floor;
        case ErrorMeasure::Mse:
            return reference.mse;
        case ErrorMeasure::Rmse:
            return reference.rmse();
        case ErrorMeasure::RelMse:
            return reference.relMse;
        default:
            return std::nan("");
    }
}

/// Shares are shown in per cent, as in the tables.
bool isShare(ErrorMeasure measure) {
    return measure == ErrorMeasure::RelativeError || measure == ErrorMeasure::Mape ||
           measure == ErrorMeasure::RelativeBias || measure == ErrorMeasure::PictureError;
}

double unitOf(ErrorMeasure measure) { return isShare(measure) ? 100.0 : 1.0; }

ChartSeries seriesOf(const ConvergenceReport& report, size_t index, ErrorMeasure measure) {
    const VariantSummary& summary = report.summary.variants[index];
    ChartSeries series;
    series.name = report.result.variants[index].variant.name + (summary.sameMethodAsReference ? " *" : "");
    for (size_t i = 0; i < summary.points.size(); ++i) {
        const SummaryPoint& point = summary.points[i];
        const Spread& spread = point.errors[static_cast<size_t>(measure)];
        const bool corrected = measure == ErrorMeasure::RelativeError && report.summary.withoutReference;
        const double value = corrected ? summary.curve[i].error : spread.mean;
        const double unit = unitOf(measure);
        ChartPoint mark{point.seconds.mean, unit * value, unit * (value - spread.deviation),
                        unit * (value + spread.deviation)};
        mark.tip = fmt::format("{}: {} {} after {:.3g} s, {} passes", series.name,
                               kMeasureNames[static_cast<size_t>(measure)].title, measureText(measure, value),
                               point.seconds.mean, point.passes);
        if (point.seeds > 1) {
            mark.tip +=
                fmt::format(" (± {} over {} seeds)", measureText(measure, spread.deviation), point.seeds);
        }
        series.points.push_back(std::move(mark));
    }
    return series;
}

}  // namespace

std::string measureText(ErrorMeasure measure, double value) {
    if (!std::isfinite(value)) { return "–"; }
    return isShare(measure) ? fmt::format("{:.3g} %", 100.0 * value) : fmt::format("{:.4g}", value);
}

LogLogChart errorChart(const ConvergenceReport& report, ErrorMeasure measure) {
    const MeasureName& name = kMeasureNames[static_cast<size_t>(measure)];
    const ConvergenceContext& context = report.context;
    LogLogChart chart;
    const std::string scene = context.title.empty() ? context.scene : context.title;
    chart.title = fmt::format("Error against render time: {}", scene);
    chart.subtitle = fmt::format("{}x{} pixels, {} seed{}, {} thread{}, {}", report.scene.resolution.width,
                                 report.scene.resolution.height, report.plan.seeds.size(),
                                 report.plan.seeds.size() == 1 ? "" : "s", context.threads,
                                 context.threads == 1 ? "" : "s", context.processor);
    chart.xTitle = "render time, seconds";
    chart.yTitle = measure == ErrorMeasure::RelativeError
                       ? std::string(report.summary.withoutReference
                                         ? "relative error, %, the reference's own subtracted"
                                         : "relative error, % (RMSE over the picture's mean)")
                   : isShare(measure) ? fmt::format("{}, %", name.title)
                                      : fmt::format("{}{}", name.title,
                                                    name.unit.empty() ? "" : fmt::format(", {}", name.unit));
    chart.note =
        "Seconds of rendering alone: building, evaluating and saving are not in them. Bands: one standard "
        "deviation.";
    bool marked = false;
    for (size_t i = 0; i < report.result.variants.size(); ++i) {
        chart.series.push_back(seriesOf(report, i, measure));
        marked = marked || report.summary.variants[i].sameMethodAsReference;
    }
    if (marked) { chart.note += " * Reference by the same method."; }
    if (const double floor = floorOf(report, measure); floor > 0.0) {
        const bool biased =
            report.reference.integrator && integratorType(*report.reference.integrator).hasBias();
        chart.levels.push_back(
            {unitOf(measure) * floor,
             fmt::format("reference's own {}{}{}", biased ? "noise (bias unknown)" : "error",
                         report.summary.withoutReference ? ", subtracted" : "",
                         isShare(measure) ? ", %" : "")});
    }
    return chart;
}

}  // namespace glint
