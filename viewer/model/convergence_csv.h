// Curves of the error as a table for other programs.
#pragma once

#include <string>
#include <vector>

#include "engine/render/convergence_curve.h"
#include "viewer/model/reference_errors.h"

namespace glint {

struct IntegratorCurves {
    IntegratorKind integrator = IntegratorKind::PathTracing;
    ConvergenceCurve estimate{};
    std::vector<ReferencePoint> reference{};
};

/// A header line, then a line for each point: integrator, source (estimate or reference), passes,
/// render_seconds, and what this source knows; its other columns are empty. Errors are fractions, not
/// per cent.
std::string convergenceCsv(const std::vector<IntegratorCurves>& curves);

}  // namespace glint
