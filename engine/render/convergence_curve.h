// The picture error over passes and render time, as a render went: for the live plot, the time forecast,
// `--error` and the checkpoint.
//
// The render session records one for each integrator's film. Points lie evenly on a logarithmic scale of
// passes, so that a curve of 2^32 passes still has fewer than kMaxPoints of them. Knows nothing of films.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace glint {

/// The estimate of error_estimate.h at one moment. Errors are those of picture_error.h: 0.01 is 1 %.
struct ConvergencePoint {
    uint32_t passes = 0;
    double renderSeconds = 0.0;     ///< spent in passes since the film's restart, resumed time included
    double relativeError = 0.0;     ///< noise and bias together
    double relativeErrorLow = 0.0;  ///< 90 % band of relativeError
    double relativeErrorHigh = 0.0;
    double relativeBias = 0.0;  ///< the bias' share, of SPPM; 0 for path tracing
};

class ConvergenceCurve {
  public:
    /// Whether a film with so many passes is due for a point: from the second pass on, when passes have grown
    /// by a 40th since the last point. Depends on pass counts alone, so that a resumed curve goes on alike.
    bool isDue(uint32_t passes) const;
    /// `point` must have more passes than the last one.
    void add(const ConvergencePoint& point);
    void clear() { points_.clear(); }

    bool empty() const { return points_.empty(); }
    const std::vector<ConvergencePoint>& points() const { return points_; }

    static constexpr uint32_t kPointsPerFactor = 40;  ///< about so many for a factor e of passes
    static constexpr size_t kMaxPoints = 1024;

  private:
    std::vector<ConvergencePoint> points_;
};

/// When the error will have fallen to a target: render seconds from the curve's last point, with a 90 % band.
struct ErrorForecast {
    double secondsLeft = 0.0;
    double secondsLow = 0.0;
    double secondsHigh = 0.0;  ///< infinite: it may never get there at this rate
    double slope = 0.0;        ///< measured: the error falls like passes^slope, about -0.5 for path tracing
};

/// Fits the curve's tail. Nothing: too few points to know a slope, or the error does not fall, or `target` is
/// not positive. Zeros when the last point is already at the target.
std::optional<ErrorForecast> forecastError(const ConvergenceCurve& curve, double target);

/// Whether the upper end of the band stayed at or below `target` in the last two points: one alone may be
/// luck. False for a curve shorter than that, or before kLeastPassesForError.
bool hasReached(const ConvergenceCurve& curve, double target);

/// No estimate of fewer passes than these ends a render.
constexpr uint32_t kLeastPassesForError = 8;

}  // namespace glint
