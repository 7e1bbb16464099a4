// How fast an error falls: the slope of error against time on log-log axes, with its confidence interval, and
// when the error reaches a value.
//
// Plain numbers in and out: it knows nothing of pictures or renderers.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace glint {

struct CurvePoint {
    double seconds = 0.0;
    double error = 0.0;
};

/// ln(error) = intercept + slope ln(seconds).
struct LogLogFit {
    double slope = 0.0;
    double slopeLow = 0.0;  ///< the 95 % confidence interval; infinite when it cannot be known
    double slopeHigh = 0.0;
    double intercept = 0.0;
    int curves = 0;
    int points = 0;          ///< of all curves
    bool fromSeeds = false;  ///< how the interval was found: see fitLogLog()
};

/// Least squares through each curve (one for each seed) by itself; the slope and intercept are the means over
/// the curves. With two or more curves the interval is Student's, mean +- t(0.975, curves - 1) s /
/// sqrt(curves): the seeds are independent, whereas the points of one curve are not, because each film holds
/// the ones before. With one curve it is that of the regression (fromSeeds false), which takes the points as
/// independent and is therefore too narrow. Points that are not positive and finite are left out; curves with
/// fewer than three of them, or with all at one time, do not count. Nothing: no curve is left.
std::optional<LogLogFit> fitLogLog(std::span<const std::vector<CurvePoint>> curves);

/// The value that a Student variable with `degrees` >= 1 degrees of freedom exceeds with probability
/// 1 - probability, for probability in (0.5, 1). By bisection of the finite sums of Abramowitz and Stegun
/// (1964), equations 26.7.3 and 26.7.4.
double studentQuantile(double probability, int degrees);

/// When an error is reached for good.
struct TimeToReach {
    enum class Kind {
        Never,      ///< not reached, and there is no fit whose whole interval falls, to predict with
        Before,     ///< already at the first point: at most `seconds`
        Measured,   ///< interpolated
        Predicted,  ///< beyond the last point, by the fit's slope from there
    } kind = Kind::Never;
    double seconds = 0.0;
    double low = 0.0;  ///< Predicted: with the ends of the slope's interval
    double high = 0.0;
};

/// `curve` in order of time. Measured: linear on log-log axes between the last point above `target` and the
/// next one. Predicted: seconds = t (e / target)^(-1 / slope) from the last point (t, e).
TimeToReach timeToReach(std::span<const CurvePoint> curve, double target,
                        const std::optional<LogLogFit>& fit);

}  // namespace glint
