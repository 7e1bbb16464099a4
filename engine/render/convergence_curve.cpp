// Points by pass count, and a straight line through the curve's tail on log-log axes.
#include "engine/render/convergence_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/check.h"
#include "engine/math/inverse_erf.h"

namespace glint {
namespace {

/// The tail is what lies within this factor of the last point's passes: older points say little about how the
/// error falls now.
constexpr double kTailFactor = 8.0;
constexpr double kLeastTailFactor = 2.0;
constexpr size_t kLeastTailPoints = 5;

bool isUsable(const ConvergencePoint& point) {
    return std::isfinite(point.relativeError) && point.relativeError > 0.0 && point.renderSeconds > 0.0;
}

std::vector<ConvergencePoint> tailOf(const ConvergenceCurve& curve) {
    std::vector<ConvergencePoint> tail;
    const double first = curve.points().back().passes / kTailFactor;
    for (const ConvergencePoint& point : curve.points()) {
        if (point.passes >= first && point.passes >= kLeastPassesForError && isUsable(point)) {
            tail.push_back(point);
        }
    }
    return tail;
}

struct Slope {
    double value = 0.0;
    double uncertainty = 0.0;  ///< half of a 90 % band
};

/// Least squares of log error over log passes. Neighbouring points share most of their samples, so their
/// scatter says too little: the uncertainty is that of the tail's two ends, from their own bands.
Slope fitSlope(const std::vector<ConvergencePoint>& tail) {
    double meanX = 0.0, meanY = 0.0;
    for (const ConvergencePoint& point : tail) {
        meanX += std::log(point.passes) / static_cast<double>(tail.size());
        meanY += std::log(point.relativeError) / static_cast<double>(tail.size());
    }
    double xx = 0.0, xy = 0.0, residual = 0.0;
    for (const ConvergencePoint& point : tail) {
        const double x = std::log(point.passes) - meanX;
        xx += x * x;
        xy += x * (std::log(point.relativeError) - meanY);
    }
    const double slope = xy / xx;
    for (const ConvergencePoint& point : tail) {
        const double x = std::log(point.passes) - meanX;
        residual += std::pow(std::log(point.relativeError) - meanY - slope * x, 2.0);
    }
    const double scatter = std::sqrt(residual / static_cast<double>(tail.size() - 2));
    const double length = std::log(tail.back().passes) - std::log(tail.front().passes);
    return {slope, 2.0 * kNormal95 * scatter / length};
}

/// Seconds until the error has fallen from `from` to `target` along the slope; infinite if it does not fall.
double secondsAlong(double slope, double from, double target, const ConvergencePoint& now) {
    if (from <= target) { return 0.0; }
    if (slope >= 0.0) { return std::numeric_limits<double>::infinity(); }
    const double growth = std::pow(target / from, 1.0 / slope);
    return (growth - 1.0) * now.renderSeconds;
}

}  // namespace

bool ConvergenceCurve::isDue(uint32_t passes) const {
    if (passes < 2) { return false; }
    return points_.empty() ||
           (points_.size() < kMaxPoints &&
            passes - points_.back().passes >= std::max(1u, points_.back().passes / kPointsPerFactor));
}

void ConvergenceCurve::add(const ConvergencePoint& point) {
    GLINT_CHECK(points_.empty() || point.passes > points_.back().passes);
    points_.push_back(point);
}

std::optional<ErrorForecast> forecastError(const ConvergenceCurve& curve, double target) {
    if (curve.empty() || !(target > 0.0)) { return std::nullopt; }
    const ConvergencePoint& now = curve.points().back();
    if (hasReached(curve, target)) { return ErrorForecast{}; }
    const std::vector<ConvergencePoint> tail = tailOf(curve);
    if (tail.size() < kLeastTailPoints || tail.back().passes < kLeastTailFactor * tail.front().passes) {
        return std::nullopt;
    }
    const Slope slope = fitSlope(tail);
    if (slope.value >= 0.0) { return std::nullopt; }
    ErrorForecast forecast;
    forecast.slope = slope.value;
    forecast.secondsLeft = secondsAlong(slope.value, now.relativeErrorHigh, target, now);
    forecast.secondsLow = secondsAlong(slope.value - slope.uncertainty, now.relativeError, target, now);
    const double worst = now.relativeErrorHigh * now.relativeErrorHigh / now.relativeError;
    forecast.secondsHigh = secondsAlong(slope.value + slope.uncertainty, worst, target, now);
    return forecast;
}

bool hasReached(const ConvergenceCurve& curve, double target) {
    const std::vector<ConvergencePoint>& points = curve.points();
    if (points.size() < 2 || points[points.size() - 2].passes < kLeastPassesForError) { return false; }
    return points.back().relativeErrorHigh <= target && points[points.size() - 2].relativeErrorHigh <= target;
}

}  // namespace glint
