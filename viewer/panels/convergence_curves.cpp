#include "viewer/panels/convergence_curves.h"

#include <fmt/format.h>

#include "viewer/panels/units.h"

namespace glint {
namespace {

// Orange and sky blue: told apart with any common colour blindness (Okabe and Ito 2002).
const std::array<Vec3, 2> kColors{Vec3(0.902f, 0.624f, 0.0f), Vec3(0.337f, 0.706f, 0.914f)};

const std::vector<ReferencePoint>& measuredBy(const ViewerModel& model, const CurveSource& source) {
    const IntegratorKind kind = kBothIntegrators[source.kind];
    return source.isBefore ? model.reference.pointsBefore(kind) : model.reference.points(kind);
}

const std::vector<ConvergencePoint>& estimatedBy(const ViewerModel& model, const CurveSource& source) {
    const IntegratorKind kind = kBothIntegrators[source.kind];
    return (source.isBefore ? model.curveBefore(kind) : model.curve(kind))->points();
}

PlotCurve curveOf(const ViewerModel& model, const CurveSource& source) {
    PlotCurve curve{.name = kIntegratorNames[source.kind], .color = kColors[source.kind]};
    curve.isFaint = source.isBefore || source.isMeasured != hasReference(model);
    curve.isDashed = source.isBefore;
    curve.hasMarkers = source.isMeasured && !source.isBefore;
    if (source.isMeasured) {
        for (const ReferencePoint& p : measuredBy(model, source)) {
            curve.points.push_back({p.renderSeconds, p.error(model.convergence.metric) * 100.0});
        }
        return curve;
    }
    const double band = source.isBefore ? 0.0 : 100.0;
    for (const ConvergencePoint& p : estimatedBy(model, source)) {
        curve.points.push_back({p.renderSeconds, p.relativeError * 100.0, p.relativeErrorLow * band,
                                p.relativeErrorHigh * band});
    }
    return curve;
}

std::string bandText(double low, double high) {
    return fmt::format("90 %: {} – {}", percent(low), percent(high));
}

}  // namespace

bool hasReference(const ViewerModel& model) { return model.usableReference() != nullptr; }

double targetOf(const ViewerModel& model) {
    return model.limits.relativeError > 0.0 ? model.limits.relativeError : model.convergence.targetError;
}

std::vector<CurveSource> curveSources(const ViewerModel& model) {
    const bool isMeasured = hasReference(model);
    std::vector<CurveSource> sources;
    const auto addBoth = [&](bool measured, bool before) {
        for (size_t kind = 0; kind < kBothIntegrators.size(); ++kind) {
            sources.push_back({kind, measured, before});
        }
    };
    addBoth(isMeasured, false);
    if (isMeasured && model.convergence.metric == ReferenceMetric::RmseOverMean) { addBoth(false, false); }
    addBoth(isMeasured, true);
    return sources;
}

LogLogPlot convergencePlot(const ViewerModel& model, const std::vector<CurveSource>& sources) {
    LogLogPlot plot{.targetY = targetOf(model) * 100.0, .xTitle = "render time, s"};
    const bool reference = hasReference(model);
    for (const CurveSource& source : sources) {
        plot.curves.push_back(curveOf(model, source));
    }
    plot.yTitle = reference ? "error, %" : "estimated error, %";
    if (model.reference.image() && !reference) { plot.warning = "the reference does not fit: see below"; }
    const bool isMeasured = !plot.curves[0].points.empty() || !plot.curves[1].points.empty();
    plot.nothing = !reference   ? "from the second pass on"
                   : isMeasured ? "the same as the reference"
                                : "measuring…";
    return plot;
}

std::string passesText(uint32_t passes) {
    return fmt::format("{} {}", grouped(passes), passes == 1 ? "pass" : "passes");
}

std::string pointText(const ViewerModel& model, const CurveSource& source, size_t point) {
    const std::string name =
        fmt::format("{}{}", kIntegratorNames[source.kind], source.isBefore ? " before the last restart" : "");
    if (source.isMeasured) {
        const ReferencePoint& p = measuredBy(model, source)[point];
        return fmt::format("{}: {} after {}, {}", name, percent(p.error(model.convergence.metric)),
                           duration(p.renderSeconds), passesText(p.passes));
    }
    const ConvergencePoint& p = estimatedBy(model, source)[point];
    std::string text = fmt::format("{}{}: {} after {}, {}", name, hasReference(model) ? ", estimated" : "",
                                   percent(p.relativeError), duration(p.renderSeconds), passesText(p.passes));
    if (source.isBefore) { return text; }
    text += "\n    " + bandText(p.relativeErrorLow, p.relativeErrorHigh);
    if (p.relativeBias > 0.0) { text += fmt::format(", bias {}", percent(p.relativeBias)); }
    return text;
}

}  // namespace glint
