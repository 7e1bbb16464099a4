// Which curves the Convergence panel draws, and what their points say: measured against the reference or
// estimated, of this film or of the one before.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "viewer/window/loglog_plot.h"
#include "viewer/window/viewer_model.h"

namespace glint {

constexpr std::array<IntegratorKind, 2> kBothIntegrators{IntegratorKind::PathTracing, IntegratorKind::Sppm};
constexpr std::array<const char*, 2> kIntegratorNames{"Path tracing", "SPPM"};

/// Where the points of one drawn curve come from.
struct CurveSource {
    size_t kind = 0;          ///< index into kBothIntegrators
    bool isMeasured = false;  ///< against the reference; otherwise estimated
    bool isBefore = false;    ///< of the film before the last restart, for comparison
};

/// Errors are measured against the reference.
bool hasReference(const ViewerModel& model);
/// The relative error to reach.
double targetOf(const ViewerModel& model);

/// Those at 0 and 1 are what is shown of path tracing and of SPPM; fainter ones behind them may follow.
std::vector<CurveSource> curveSources(const ViewerModel& model);
/// A curve for each source, in per cent over seconds.
LogLogPlot convergencePlot(const ViewerModel& model, const std::vector<CurveSource>& sources);
/// What one point of a curve says.
std::string pointText(const ViewerModel& model, const CurveSource& source, size_t point);

/// "3 passes"
std::string passesText(uint32_t passes);

}  // namespace glint
