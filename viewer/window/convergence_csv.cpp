#include "viewer/window/convergence_csv.h"

#include <fmt/format.h>

#include "viewer/window/frame_stats.h"

namespace glint {

std::string convergenceCsv(const CurvesOfBoth& curves) {
    std::string csv =
        "integrator,source,passes,render_seconds,relative_error,low_90,high_90,estimated_bias,relative_rmse,"
        "rmse_over_mean,mape,relative_bias\n";
    for (size_t kind = 0; kind < curves.estimates.size(); ++kind) {
        const char* name = integratorName(static_cast<IntegratorKind>(kind));
        for (const ConvergencePoint& point : curves.estimates[kind].points()) {
            csv += fmt::format("{},estimate,{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},,,,\n", name, point.passes,
                               point.renderSeconds, point.relativeError, point.relativeErrorLow,
                               point.relativeErrorHigh, point.relativeBias);
        }
        for (const ReferencePoint& point : curves.references[kind]) {
            csv += fmt::format("{},reference,{},{:.6g},,,,,{:.6g},{:.6g},{:.6g},{:.6g}\n", name, point.passes,
                               point.renderSeconds, point.relativeRmse, point.rmseOverMean, point.mape,
                               point.relativeBias);
        }
    }
    return csv;
}

}  // namespace glint
