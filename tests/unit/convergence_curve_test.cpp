// The curve of the error over passes: where its points lie, what it foretells, and when it says stop.
#include "engine/render/convergence_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace glint {
namespace {

/// A curve up to `passes` at a second a pass, with error(passes) and a band of +- 5 %.
template <class Error>
ConvergenceCurve curveOf(uint32_t passes, Error error) {
    ConvergenceCurve curve;
    for (uint32_t n = 1; n <= passes; ++n) {
        if (curve.isDue(n)) {
            const double value = error(n);
            curve.add({.passes = n,
                       .renderSeconds = double(n),
                       .relativeError = value,
                       .relativeErrorLow = 0.95 * value,
                       .relativeErrorHigh = 1.05 * value});
        }
    }
    return curve;
}

TEST(ConvergenceCurve, PointsAreEvenOnALogarithmicScale) {
    const ConvergenceCurve curve = curveOf(100000, [](uint32_t n) { return 1.0 / n; });
    EXPECT_EQ(curve.points().front().passes, 2u);
    EXPECT_EQ(curve.points()[10].passes, 12u);
    for (size_t i = 60; i < curve.points().size(); ++i) {
        const double factor = double(curve.points()[i].passes) / curve.points()[i - 1].passes;
        EXPECT_GT(factor, 1.012);
        EXPECT_LT(factor, 1.03);
    }
    EXPECT_LT(curve.points().size(), 400u);
}

TEST(ConvergenceCurve, StaysSmallForAnyNumberOfPasses) {
    ConvergenceCurve curve;
    for (uint64_t n = 2; n <= 0xffffffffull;) {
        ASSERT_TRUE(curve.isDue(static_cast<uint32_t>(n)));
        curve.add({.passes = static_cast<uint32_t>(n)});
        n += std::max<uint64_t>(1, n / ConvergenceCurve::kPointsPerFactor);
    }
    EXPECT_LT(curve.points().size(), ConvergenceCurve::kMaxPoints);
}

TEST(ConvergenceCurve, ForetellsAPowerLawWithItsOwnSlope) {
    for (const double slope : {-0.5, -0.75, -1.0 / 3.0}) {
        const ConvergenceCurve curve = curveOf(200, [&](uint32_t n) { return std::pow(double(n), slope); });
        const double now = curve.points().back().passes;
        const double target =
            std::pow(2.0 * now, slope) * 1.05;  // its upper end comes down to it at twice the passes
        const auto forecast = forecastError(curve, target);
        ASSERT_TRUE(forecast.has_value()) << slope;
        EXPECT_NEAR(forecast->slope, slope, 1e-6);
        EXPECT_NEAR(forecast->secondsLeft, now, 1e-3 * now);
        EXPECT_LE(forecast->secondsLow, forecast->secondsLeft);
        EXPECT_GE(forecast->secondsHigh, forecast->secondsLeft);
    }
}

TEST(ConvergenceCurve, ForetellsNothingWhileItCannotKnow) {
    const auto root = [](uint32_t n) { return 1.0 / std::sqrt(n); };
    EXPECT_FALSE(forecastError(ConvergenceCurve(), 0.01));
    EXPECT_FALSE(forecastError(curveOf(9, root), 0.01)) << "too few points";
    EXPECT_FALSE(forecastError(curveOf(100, root), 0.0)) << "no target";
    EXPECT_FALSE(forecastError(curveOf(100, [](uint32_t n) { return 0.1 * std::sqrt(n); }), 0.01))
        << "it grows";
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(forecastError(curveOf(100, [&](uint32_t) { return infinity; }), 0.01));
}

TEST(ConvergenceCurve, ANoisyTailHasARange) {
    const ConvergenceCurve curve = curveOf(
        300, [](uint32_t n) { return std::exp(0.1 * std::sin(12.0 * std::log(double(n)))) / std::sqrt(n); });
    const auto forecast = forecastError(curve, 0.01);
    ASSERT_TRUE(forecast.has_value());
    EXPECT_GT(forecast->secondsHigh, 1.2 * forecast->secondsLow);
}

TEST(ConvergenceCurve, OneLuckyPointDoesNotStopARender) {
    const auto flatButFor = [](uint32_t lucky) {
        return [lucky](uint32_t n) { return n == lucky ? 0.001 : 0.1; };
    };
    EXPECT_FALSE(hasReached(curveOf(20, flatButFor(20)), 0.01));
    EXPECT_FALSE(hasReached(curveOf(21, flatButFor(20)), 0.01));
    EXPECT_TRUE(hasReached(curveOf(20, [](uint32_t) { return 0.009; }), 0.01));
    EXPECT_FALSE(hasReached(curveOf(20, [](uint32_t) { return 0.0097; }), 0.01))
        << "the band's upper end counts";
    EXPECT_FALSE(hasReached(curveOf(kLeastPassesForError, [](uint32_t) { return 0.0; }), 0.01))
        << "too early";
    EXPECT_FALSE(hasReached(ConvergenceCurve(), 0.01));
}

}  // namespace
}  // namespace glint
