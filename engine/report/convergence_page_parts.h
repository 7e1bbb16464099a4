// Parts of convergence_page, each HTML of its own.
#pragma once

#include <string>

#include "engine/report/convergence_page.h"

namespace glint {

/// Passes, seconds, error, slope and times to round errors.
std::string pageSpeedTable(const ConvergenceReport& report);
/// Measures down, variants across: there are always more of the former.
std::string pageMetricsTable(const ConvergenceReport& report);
std::string pageImages(const ConvergenceReport& report, const std::string& folder, const ImageLegend& legend);

/// The variant's name, with the mark of the reference's own method.
std::string pageName(const ConvergenceReport& report, size_t variant);
/// "3.2 %"; a dash for what is not finite.
std::string pagePercent(double share);

}  // namespace glint
