// Which curves the Convergence panel draws, and what their points say: measured against the reference or
// estimated, of this film or of the one before.
#pragma once

#include <string>
#include <vector>

#include "viewer/model/convergence_watch.h"
#include "viewer/ui/loglog_plot.h"

namespace glint {

/// Where the points of one drawn curve come from.
struct CurveSource {
    IntegratorKind integrator = IntegratorKind::PathTracing;
    bool isMeasured = false;  ///< against the reference; otherwise estimated
    bool isBefore = false;    ///< of the film before the last restart, for comparison
};

/// Errors are measured against the reference.
bool hasReference(const ConvergenceWatch& convergence);

/// The first ones are what is shown of each integrator in use, in their order; fainter ones behind them
/// may follow.
std::vector<CurveSource> curveSources(const ConvergenceWatch& convergence);
/// A curve for each source, in per cent over seconds. `target`: the relative error to reach.
LogLogPlot convergencePlot(const ConvergenceWatch& convergence, const std::vector<CurveSource>& sources,
                           double target);
/// What one point of a curve says.
std::string pointText(const ConvergenceWatch& convergence, const CurveSource& source, size_t point);

}  // namespace glint
