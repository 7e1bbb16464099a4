// The rule that turns what a stability case measured into ok, degraded or broken.
//
// A deviation counts only as far as it lies beyond its confidence interval: noise is never called an error,
// and an interval too wide to see an error is never called ok.
#pragma once

#include "engine/stress/stress_case.h"

namespace glint {

/// Each case errs with this probability, shared out among its values (Bonferroni).
constexpr double kStressSignificance = 1e-6;
/// Broken: wrong by surely more than this, relative to the truth.
constexpr double kStressBrokenDeviation = 0.05;
/// An interval of more than this (relative half width) could hide a broken picture.
constexpr double kStressWidestInterval = 0.05;
/// Broken: more than this share of all samples was not finite or negative.
constexpr double kStressBrokenDrops = 1e-3;

struct StressJudgement {
    StressVerdict verdict = StressVerdict::Ok;
    /// of the value farthest beyond its interval, or from its truth: (measured - truth) / scale
    double deviation = 0.0;
    double halfWidth = 0.0;  ///< of that value's confidence interval, on the same scale
    size_t worst = 0;        ///< its index
    double droppedShare = 0.0;
    std::string reason;  ///< why it is not ok, in words; empty where it is
};

/// ok: every value lies within its interval widened by `tolerance`, no interval is wider than
/// kStressWidestInterval, and no sample was dropped. broken: a value is surely wrong by more than
/// kStressBrokenDeviation, or not a number, or there is none; or more than kStressBrokenDrops were dropped.
/// degraded: everything between. Deviations are relative to the value's truth, or to a tenth of the mean
/// truth where that is larger: dark corners are no reason for alarm.
StressJudgement judgeStress(const StressOutcome& outcome, double tolerance);

/// The z or t that a standard normal (degrees 0) or Student variable exceeds in absolute value with the given
/// probability in (0, 1).
double twoSidedQuantile(double probability, int degrees);

}  // namespace glint
