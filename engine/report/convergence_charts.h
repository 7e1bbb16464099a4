// A convergence report as log-log charts: plot.svg, plot.png and those of the page.
#pragma once

#include "engine/report/convergence_report.h"
#include "engine/report/plot.h"

namespace glint {

/// Mean over the seeds against mean render seconds, a series for each variant with a band of one standard
/// deviation, and the reference's own error as a level where it is known (of mse, rmse, relMSE and the
/// relative error). Markers say their numbers.
LogLogChart errorChart(const ConvergenceReport& report, ErrorMeasure measure);

/// "3.1 %" for the relative error, else four digits.
std::string measureText(ErrorMeasure measure, double value);

}  // namespace glint
