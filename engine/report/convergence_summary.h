// What the measured curves say: mean and spread over the seeds, how fast the error falls, when it reaches
// round values, and how efficient each variant is.
//
// Between convergence_run, which measures, and convergence_files and convergence_page, which write.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/report/convergence_fit.h"
#include "engine/report/convergence_run.h"

namespace glint {

struct Spread {
    double mean = 0.0;
    double deviation = 0.0;  ///< of one seed, unbiased variance's root; NaN with fewer than two seeds
};

struct SummaryPoint {
    uint32_t passes = 0;
    int seeds = 0;
    Spread seconds;
    std::array<Spread, kErrorMeasureCount> errors{};  ///< by ErrorMeasure
};

/// Relative errors that a summary looks for.
constexpr std::array<double, 4> kTargetErrors{0.10, 0.05, 0.02, 0.01};

struct VariantSummary {
    std::vector<SummaryPoint> points;
    std::vector<CurvePoint> curve;  ///< mean seconds and the error that fit and targets go by
    std::optional<LogLogFit> fit;
    double fitFromSeconds = 0.0;  ///< where the fitted part begins
    int leftOutOfFit = 0;         ///< points too near to the reference's own error
    std::array<TimeToReach, kTargetErrors.size()> targets{};  ///< by kTargetErrors
    bool sameMethodAsReference = false;
    /// At the last point; NaN where it cannot be known.
    double variance = 0.0;     ///< mean over pixels of the variance between seeds
    double biasSquared = 0.0;  ///< what of the MSE the variance does not explain, without the reference's
    double efficiency = 0.0;   ///< 1 / (variance seconds)
    double relativeEfficiency = 0.0;  ///< to the first variant's
};

struct ConvergenceSummary {
    std::vector<VariantSummary> variants;  ///< in the result's order
    bool withoutReference = false;         ///< see summarizeConvergence()
    double floor = 0.0;                    ///< the reference's relative error; NaN: not known
    double smallestError = 0.0;            ///< mean relative error of the best point; NaN: none
    double floorRatio = 0.0;               ///< floor over smallestError
};

/// withoutReference: fits and targets use sqrt(mse - reference mse) / mean instead of rmse / mean, which is
/// what the error against a perfect reference would be: for a picture x and an independent reference r of the
/// truth t, E (x - r)^2 = E (x - t)^2 + E (r - t)^2. A point enters the fit when its mse is at least
/// kFitMargin times the reference's and it lies in the last tenfold of time, or anywhere when these are fewer
/// than kFewestFitPoints: what comes before is often a different slope (photon maps' first radii, a light
/// found late), and predictions go by where the curve is heading.
ConvergenceSummary summarizeConvergence(const ConvergenceResult& result, const ReferenceImage& reference,
                                        bool withoutReference);

/// With mse 9 times the floor, the floor makes the rmse 5 % too large.
constexpr double kFitMargin = 9.0;
constexpr double kFitTimeRange = 10.0;
constexpr int kFewestFitPoints = 4;

}  // namespace glint
