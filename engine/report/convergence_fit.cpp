#include "engine/report/convergence_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace glint {
namespace {

constexpr double kInfinityD = std::numeric_limits<double>::infinity();
constexpr double kLevel = 0.975;  // two sides of 95 %

/// P(|T| <= t) for `degrees` degrees of freedom.
double studentMass(double t, int degrees) {
    const double theta = std::atan(t / std::sqrt(static_cast<double>(degrees)));
    const double cosine = std::cos(theta);
    double sum = 0.0;
    if (degrees % 2 == 1) {
        double term = cosine;
        for (int i = 1; i < degrees - 1; i += 2) {
            sum += term;
            term *= cosine * cosine * static_cast<double>(i + 1) / static_cast<double>(i + 2);
        }
        return 2.0 / std::numbers::pi * (theta + std::sin(theta) * sum);
    }
    double term = 1.0;
    for (int i = 0; i < degrees - 1; i += 2) {
        sum += term;
        term *= cosine * cosine * static_cast<double>(i + 1) / static_cast<double>(i + 2);
    }
    return std::sin(theta) * sum;
}

struct Line {
    double slope = 0.0;
    double intercept = 0.0;
    double slopeError = kInfinityD;  ///< standard error by the regression
    int points = 0;
};

std::optional<Line> leastSquares(const std::vector<CurvePoint>& curve) {
    std::vector<std::pair<double, double>> logs;
    double meanX = 0.0, meanY = 0.0;
    for (const CurvePoint& p : curve) {
        if (p.seconds > 0.0 && p.error > 0.0 && std::isfinite(p.seconds) && std::isfinite(p.error)) {
            logs.emplace_back(std::log(p.seconds), std::log(p.error));
            meanX += logs.back().first;
            meanY += logs.back().second;
        }
    }
    if (logs.size() < 3) { return std::nullopt; }
    const double n = static_cast<double>(logs.size());
    meanX /= n;
    meanY /= n;
    double xx = 0.0, xy = 0.0;
    for (const auto& [x, y] : logs) {
        xx += (x - meanX) * (x - meanX);
        xy += (x - meanX) * (y - meanY);
    }
    if (!(xx > 1e-12)) { return std::nullopt; }
    Line line{
        .slope = xy / xx, .intercept = meanY - xy / xx * meanX, .points = static_cast<int>(logs.size())};
    double residual = 0.0;
    for (const auto& [x, y] : logs) {
        const double miss = y - line.intercept - line.slope * x;
        residual += miss * miss;
    }
    line.slopeError = std::sqrt(residual / (n - 2.0) / xx);
    return line;
}

}  // namespace

double studentQuantile(double probability, int degrees) {
    const double mass = 2.0 * probability - 1.0;
    double low = 0.0, high = 1.0;
    while (studentMass(high, degrees) < mass && high < 1e12) {
        high *= 2.0;
    }
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (studentMass(middle, degrees) < mass ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

std::optional<LogLogFit> fitLogLog(std::span<const std::vector<CurvePoint>> curves) {
    std::vector<Line> lines;
    LogLogFit fit;
    for (const std::vector<CurvePoint>& curve : curves) {
        if (const auto line = leastSquares(curve)) {
            lines.push_back(*line);
            fit.slope += line->slope;
            fit.intercept += line->intercept;
            fit.points += line->points;
        }
    }
    if (lines.empty()) { return std::nullopt; }
    const double n = static_cast<double>(lines.size());
    fit.curves = static_cast<int>(lines.size());
    fit.slope /= n;
    fit.intercept /= n;
    fit.fromSeeds = fit.curves > 1;
    double halfWidth = 0.0;
    if (fit.fromSeeds) {
        double squares = 0.0;
        for (const Line& line : lines) {
            squares += (line.slope - fit.slope) * (line.slope - fit.slope);
        }
        halfWidth = studentQuantile(kLevel, fit.curves - 1) * std::sqrt(squares / (n - 1.0) / n);
    } else {
        halfWidth = studentQuantile(kLevel, lines[0].points - 2) * lines[0].slopeError;
    }
    fit.slopeLow = fit.slope - halfWidth;
    fit.slopeHigh = fit.slope + halfWidth;
    return fit;
}

TimeToReach timeToReach(std::span<const CurvePoint> curve, double target,
                        const std::optional<LogLogFit>& fit) {
    if (curve.empty()) { return {}; }
    size_t firstBelow = curve.size();
    while (firstBelow > 0 && curve[firstBelow - 1].error <= target) {
        --firstBelow;
    }
    if (firstBelow == 0) { return {TimeToReach::Kind::Before, curve[0].seconds}; }
    if (firstBelow < curve.size()) {
        const CurvePoint& above = curve[firstBelow - 1];
        const CurvePoint& below = curve[firstBelow];
        // An error of 0 is below everything on log axes: the step is then taken at its end.
        const double fall = below.error > 0.0 ? std::log(above.error / below.error) : kInfinityD;
        const double share = std::isfinite(fall) && fall > 0.0 ? std::log(above.error / target) / fall : 1.0;
        return {TimeToReach::Kind::Measured,
                above.seconds * std::pow(below.seconds / above.seconds, std::clamp(share, 0.0, 1.0))};
    }
    const CurvePoint& last = curve.back();
    if (!fit || !(fit->slopeHigh < 0.0) || !std::isfinite(last.error)) { return {}; }
    const auto at = [&](double slope) { return last.seconds * std::pow(last.error / target, -1.0 / slope); };
    return {TimeToReach::Kind::Predicted, at(fit->slope), at(fit->slopeLow), at(fit->slopeHigh)};
}

}  // namespace glint
