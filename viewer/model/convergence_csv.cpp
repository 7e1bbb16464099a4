#include "viewer/model/convergence_csv.h"

#include <fmt/format.h>

namespace glint {

std::string convergenceCsv(const std::vector<IntegratorCurves>& curves) {
    std::string csv =
        "integrator,source,passes,render_seconds,relative_error,low_90,high_90,estimated_bias,relative_rmse,"
        "rmse_over_mean,mape,relative_bias\n";
    for (const IntegratorCurves& each : curves) {
        const char* name = integratorInfo(each.integrator).key;
        for (const ConvergencePoint& point : each.estimate.points()) {
            csv += fmt::format("{},estimate,{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},,,,\n", name, point.passes,
                               point.renderSeconds, point.relativeError, point.relativeErrorLow,
                               point.relativeErrorHigh, point.relativeBias);
        }
        for (const ReferencePoint& point : each.reference) {
            csv += fmt::format("{},reference,{},{:.6g},{:.6g},,,,{:.6g},{:.6g},{:.6g},{:.6g}\n", name,
                               point.passes, point.renderSeconds, point.pictureError, point.relativeRmse,
                               point.rmseOverMean, point.mape, point.relativeBias);
        }
    }
    return csv;
}

}  // namespace glint
