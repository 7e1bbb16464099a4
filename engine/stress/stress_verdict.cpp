// Quantiles by bisection: a handful a case, so that plain beats fast.
#include "engine/stress/stress_verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace glint {
namespace {

/// Simpson's rule for the integral of cos^power over [from, pi/2].
double cosinePowerIntegral(double from, int power) {
    constexpr int kIntervals = 400;
    const double step = (0.5 * std::numbers::pi - from) / kIntervals;
    double sum = 0.0;
    for (int i = 0; i <= kIntervals; ++i) {
        const double weight = i == 0 || i == kIntervals ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        sum += weight * std::pow(std::max(0.0, std::cos(from + step * i)), power);
    }
    return sum * step / 3.0;
}

/// P(|X| > x). Student's t with x = sqrt(degrees) tan(angle) has the density cos^(degrees - 1) in the angle.
double twoSidedTail(double x, int degrees) {
    if (degrees <= 0) { return std::erfc(x / std::numbers::sqrt2); }
    const double angle = std::atan(x / std::sqrt(static_cast<double>(degrees)));
    return cosinePowerIntegral(angle, degrees - 1) / cosinePowerIntegral(0.0, degrees - 1);
}

double meanTruth(const StressOutcome& outcome) {
    double sum = 0.0;
    for (const StressValue& value : outcome.values) {
        sum += std::abs(value.truth);
    }
    return sum / static_cast<double>(outcome.values.size());
}

bool isNumber(const StressValue& value) {
    return std::isfinite(value.measured) && std::isfinite(value.truth) && std::isfinite(value.standardError);
}

/// Deviation and interval of one value.
struct Scaled {
    double deviation, halfWidth;
    double excess() const { return std::abs(deviation) - halfWidth; }
};

/// The farther beyond its interval; where neither is, the farther from the truth.
bool isWorse(const Scaled& a, const Scaled& b) {
    const double beyondA = std::max(a.excess(), 0.0);
    const double beyondB = std::max(b.excess(), 0.0);
    return beyondA != beyondB ? beyondA > beyondB : std::abs(a.deviation) > std::abs(b.deviation);
}

Scaled scaledDeviation(const StressValue& value, double leastScale, double probability) {
    const double scale = std::max({std::abs(value.truth), leastScale, std::numeric_limits<double>::min()});
    const double quantile = value.standardError > 0.0 ? twoSidedQuantile(probability, value.degrees) : 0.0;
    return {(value.measured - value.truth) / scale, quantile * value.standardError / scale};
}

StressJudgement broken(const char* reason) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    return {StressVerdict::Broken, kNan, kNan, 0, 0.0, reason};
}

void worsen(StressVerdict verdict, std::string reason, StressJudgement* judgement) {
    if (verdict <= judgement->verdict) { return; }
    judgement->verdict = verdict;
    judgement->reason = std::move(reason);
}

}  // namespace

double twoSidedQuantile(double probability, int degrees) {
    double lo = 0.0;
    double hi = 1.0;
    while (twoSidedTail(hi, degrees) > probability) {
        hi *= 2.0;
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (lo + hi);
        (twoSidedTail(middle, degrees) > probability ? lo : hi) = middle;
    }
    return 0.5 * (lo + hi);
}

StressJudgement judgeStress(const StressOutcome& outcome, double tolerance) {
    if (outcome.values.empty()) { return broken("nothing was measured"); }
    if (!std::ranges::all_of(outcome.values, isNumber)) { return broken("a value is not a number"); }
    StressJudgement judgement;
    double worstExcess = -std::numeric_limits<double>::infinity();
    double widest = 0.0;
    const double leastScale = 0.1 * meanTruth(outcome);
    const double probability = kStressSignificance / static_cast<double>(outcome.values.size());
    for (size_t i = 0; i < outcome.values.size(); ++i) {
        const Scaled scaled = scaledDeviation(outcome.values[i], leastScale, probability);
        widest = std::max(widest, scaled.halfWidth);
        worstExcess = std::max(worstExcess, scaled.excess());
        if (i > 0 && !isWorse(scaled, {judgement.deviation, judgement.halfWidth})) { continue; }
        judgement.deviation = scaled.deviation;
        judgement.halfWidth = scaled.halfWidth;
        judgement.worst = i;
    }
    if (outcome.samples > 0) {
        judgement.droppedShare =
            static_cast<double>(outcome.dropped()) / static_cast<double>(outcome.samples);
    }
    if (worstExcess > kStressBrokenDeviation) {
        worsen(StressVerdict::Broken, fmt::format("surely wrong by more than {:.3g} %", 100.0 * worstExcess),
               &judgement);
    }
    if (judgement.droppedShare > kStressBrokenDrops) {
        worsen(StressVerdict::Broken,
               fmt::format("{:.2g} % of all samples dropped", 100.0 * judgement.droppedShare), &judgement);
    }
    if (worstExcess > tolerance) {
        worsen(StressVerdict::Degraded,
               fmt::format("surely wrong by more than {:.3g} %", 100.0 * worstExcess), &judgement);
    }
    if (outcome.dropped() > 0) {
        worsen(StressVerdict::Degraded, fmt::format("{} samples dropped", outcome.dropped()), &judgement);
    }
    if (widest > kStressWidestInterval) {
        worsen(StressVerdict::Degraded, fmt::format("too noisy to tell: ±{:.2g} %", 100.0 * widest),
               &judgement);
    }
    return judgement;
}

}  // namespace glint
