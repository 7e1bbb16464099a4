#include "viewer/panels/convergence_curves.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "viewer/base/units.h"

namespace glint {
namespace {

// Orange, sky blue, bluish green, yellow, vermilion: told apart with any common colour blindness (Okabe and
// Ito 2002).
const std::array<Vec3, 5> kColors{Vec3(0.902f, 0.624f, 0.0f), Vec3(0.337f, 0.706f, 0.914f),
                                  Vec3(0.0f, 0.620f, 0.451f), Vec3(0.941f, 0.894f, 0.259f),
                                  Vec3(0.835f, 0.369f, 0.0f)};

const std::vector<ReferencePoint>& measuredBy(const ConvergenceWatch& convergence,
                                              const CurveSource& source) {
    const ReferenceErrors& errors = convergence.reference;
    return source.isBefore ? errors.pointsBefore(source.integrator) : errors.points(source.integrator);
}

const std::vector<ConvergencePoint>& estimatedBy(const ConvergenceWatch& convergence,
                                                 const CurveSource& source) {
    return (source.isBefore ? convergence.curveBefore(source.integrator)
                            : convergence.curve(source.integrator))
        ->points();
}

PlotCurve curveOf(const ConvergenceWatch& convergence, const CurveSource& source) {
    PlotCurve curve{.name = integratorInfo(source.integrator).displayName,
                    .color = kColors[static_cast<size_t>(source.integrator) % kColors.size()]};
    curve.isFaint = source.isBefore || source.isMeasured != hasReference(convergence);
    curve.isDashed = source.isBefore;
    curve.hasMarkers = source.isMeasured && !source.isBefore;
    if (source.isMeasured) {
        for (const ReferencePoint& p : measuredBy(convergence, source)) {
            curve.points.push_back({p.renderSeconds, p.error(convergence.metric) * 100.0});
        }
        return curve;
    }
    const double band = source.isBefore ? 0.0 : 100.0;
    for (const ConvergencePoint& p : estimatedBy(convergence, source)) {
        curve.points.push_back({p.renderSeconds, p.relativeError * 100.0, p.relativeErrorLow * band,
                                p.relativeErrorHigh * band});
    }
    return curve;
}

std::string bandText(double low, double high) {
    return fmt::format("90 %: {} – {}", percent(low), percent(high));
}

}  // namespace

bool hasReference(const ConvergenceWatch& convergence) { return convergence.usableReference() != nullptr; }

std::vector<CurveSource> curveSources(const ConvergenceWatch& convergence) {
    const bool isMeasured = hasReference(convergence);
    std::vector<CurveSource> sources;
    const auto addAll = [&](bool measured, bool before) {
        for (const IntegratorKind integrator : convergence.integrators()) {
            sources.push_back({integrator, measured, before});
        }
    };
    addAll(isMeasured, false);
    if (isMeasured && convergence.metric == ReferenceMetric::PictureError) { addAll(false, false); }
    addAll(isMeasured, true);
    return sources;
}

LogLogPlot convergencePlot(const ConvergenceWatch& convergence, const std::vector<CurveSource>& sources,
                           double target) {
    LogLogPlot plot{.targetY = target * 100.0, .xTitle = "render time, s"};
    const bool reference = hasReference(convergence);
    for (const CurveSource& source : sources) {
        plot.curves.push_back(curveOf(convergence, source));
    }
    plot.yTitle = reference ? "error, %" : "estimated error, %";
    if (convergence.reference.loaded() && !reference) {
        plot.warning = "the reference does not fit: see below";
    }
    const bool isMeasured = std::ranges::any_of(
        plot.curves, [](const PlotCurve& curve) { return !curve.isFaint && !curve.points.empty(); });
    plot.nothing = !reference   ? "from the second pass on"
                   : isMeasured ? "the same as the reference"
                                : "measuring…";
    return plot;
}

std::string pointText(const ConvergenceWatch& convergence, const CurveSource& source, size_t point) {
    const std::string name = fmt::format("{}{}", integratorInfo(source.integrator).displayName,
                                         source.isBefore ? " before the last restart" : "");
    if (source.isMeasured) {
        const ReferencePoint& p = measuredBy(convergence, source)[point];
        return fmt::format("{}: {} after {}, {}", name, percent(p.error(convergence.metric)),
                           duration(p.renderSeconds), passCount(p.passes));
    }
    const ConvergencePoint& p = estimatedBy(convergence, source)[point];
    std::string text =
        fmt::format("{}{}: {} after {}, {}", name, hasReference(convergence) ? ", estimated" : "",
                    percent(p.relativeError), duration(p.renderSeconds), passCount(p.passes));
    if (source.isBefore) { return text; }
    text += "\n    " + bandText(p.relativeErrorLow, p.relativeErrorHigh);
    if (p.relativeBias > 0.0) { text += fmt::format(", bias {}", percent(p.relativeBias)); }
    return text;
}

}  // namespace glint
