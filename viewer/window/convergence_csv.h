// The Convergence panel's curves as a table for other programs.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/render/convergence_curve.h"
#include "viewer/window/reference_errors.h"

namespace glint {

/// For each integrator, in IntegratorKind's order.
struct CurvesOfBoth {
    std::array<ConvergenceCurve, 2> estimates;
    std::array<std::vector<ReferencePoint>, 2> references;
};

/// A header line, then a line for each point: integrator, source (estimate or reference), passes,
/// render_seconds, and what this source knows; its other columns are empty. Errors are fractions, not
/// per cent.
std::string convergenceCsv(const CurvesOfBoth& curves);

}  // namespace glint
