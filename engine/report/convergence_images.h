// The pictures of a convergence report as PNG files: what the renderers saw on the way, and where it
// was wrong.
#pragma once

#include <string>

#include "engine/report/convergence_report.h"

namespace glint {

/// Of relative squared error; one range for all maps of a report, so that they can be compared.
struct ImageLegend {
    double low = 0.0;
    double high = 0.0;
};

/// Writes FOLDER/pictures/ VARIANT-PASSES.png and VARIANT-PASSES-error.png for each kept picture, whose names
/// it sets, and reference.png and reference-error.png. FOLDER must exist. Exposure is the plan's.
Result<ImageLegend> saveImages(const std::string& folder, const ConvergencePlan& plan,
                               const ReferenceImage& reference, ConvergenceResult* result);

}  // namespace glint
