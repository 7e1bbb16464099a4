// A convergence report as one HTML page that needs nothing else: charts inside as SVG, pictures as data.
#pragma once

#include <string>

#include "engine/report/convergence_images.h"
#include "engine/report/convergence_report.h"

namespace glint {

/// `folder` holds the pictures that saveImages() wrote; larger ones than kMostPagePixels wide go into the
/// page reduced. Pictures that cannot be read are left out.
std::string convergencePage(const ConvergenceReport& report, const std::string& folder,
                            const ImageLegend& legend);

constexpr int kMostPagePixels = 360;

}  // namespace glint
