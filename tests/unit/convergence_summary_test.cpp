// What a convergence run's summary makes of given curves: where it fits, what it leaves out, what it marks.
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/report/convergence_charts.h"
#include "engine/report/convergence_report.h"

namespace glint {
namespace {

/// A grey reference of mean 1 whose own mse is `mse`.
ReferenceImage reference(double mse) {
    ReferenceImage out;
    out.image = {2, 2, std::vector<float>(12, 1.0f)};
    out.variance.assign(12, static_cast<float>(mse));
    out.method = "path";
    out.integrator = IntegratorKind::PathTracing;
    out.summarize();
    return out;
}

/// Seeds whose mse at `seconds` is errorAt(seconds)^2 plus the reference's.
template <class ErrorAt>
MeasuredVariant variant(const char* text, const ReferenceImage& against, int seeds, ErrorAt errorAt) {
    MeasuredVariant out;
    out.variant = *parseVariant(text);
    out.settings = out.variant.applyTo({});
    for (int k = 0; k < seeds; ++k) {
        MeasuredCurve curve{static_cast<uint32_t>(k), {}};
        for (int i = 0; i <= 12; ++i) {
            const double seconds = 0.01 * std::pow(2.0, i);
            const double error = errorAt(seconds) * (1.0 + 0.01 * k);
            MeasuredPoint point{1u << i, seconds, {}};
            at(point.errors, ErrorMeasure::Mse) = error * error + against.mse;
            at(point.errors, ErrorMeasure::Rmse) = std::sqrt(error * error + against.mse);
            at(point.errors, ErrorMeasure::RelativeError) = std::sqrt(error * error + against.mse);
            at(point.errors, ErrorMeasure::MseWithoutReference) = error * error;
            curve.points.push_back(point);
        }
        out.curves.push_back(std::move(curve));
    }
    return out;
}

double rootLaw(double seconds) { return 0.1 / std::sqrt(seconds); }

TEST(ConvergenceSummary, FitsTheLastTenfoldOfTime) {
    const ReferenceImage against = reference(0.0);
    ConvergenceResult result;
    // Steeper until 4 s, which is before a tenth of the last point's 41 s.
    result.variants.push_back(variant("sppm", against, 3, [](double seconds) {
        return seconds < 4.0 ? rootLaw(4.0) * 4.0 / seconds : rootLaw(seconds);
    }));
    const VariantSummary summary = summarizeConvergence(result, against, false).variants[0];
    ASSERT_TRUE(summary.fit);
    EXPECT_NEAR(summary.fitFromSeconds, 4.096, 1e-9);
    EXPECT_NEAR(summary.fit->slope, -0.5, 1e-9);
    EXPECT_EQ(summary.fit->points, 3 * 4);
    EXPECT_FALSE(summary.sameMethodAsReference);
}

TEST(ConvergenceSummary, PointsNearTheReferencesOwnErrorAreNoPartOfTheFit) {
    const ReferenceImage against = reference(1e-4);
    ConvergenceResult result;
    result.variants.push_back(variant("path", against, 3, rootLaw));
    const ConvergenceSummary plain = summarizeConvergence(result, against, false);
    const VariantSummary& summary = plain.variants[0];
    EXPECT_TRUE(summary.sameMethodAsReference);
    EXPECT_NEAR(plain.floor, 0.01, 1e-6);
    // 0.1 / sqrt(41) is 0.0156: every point beyond 12 s has less than 9 times the reference's mse.
    EXPECT_GT(summary.leftOutOfFit, 0);
    const ConvergenceSummary corrected = summarizeConvergence(result, against, true);
    EXPECT_NEAR(corrected.variants[0].curve.back().error, 1.01 * rootLaw(40.96), 1e-6);
    EXPECT_LT(corrected.variants[0].curve.back().error, summary.curve.back().error);
    EXPECT_NEAR(plain.floorRatio, plain.floor / plain.smallestError, 1e-12);
}

TEST(ConvergenceSummary, TargetsAreMeasuredOrPredicted) {
    const ReferenceImage against = reference(0.0);
    ConvergenceResult result;
    result.variants.push_back(variant("sppm", against, 2, rootLaw));
    const VariantSummary summary = summarizeConvergence(result, against, false).variants[0];
    const double mean = 1.005;  // of the two seeds' factors
    EXPECT_EQ(summary.targets[1].kind, TimeToReach::Kind::Measured);
    EXPECT_NEAR(summary.targets[1].seconds, std::pow(mean * 0.1 / 0.05, 2.0), 1e-6);
    EXPECT_EQ(summary.targets[3].kind, TimeToReach::Kind::Predicted);
    EXPECT_NEAR(summary.targets[3].seconds, std::pow(mean * 0.1 / 0.01, 2.0), 1e-4);
}

TEST(ConvergenceSummary, EveryOutputCarriesTheMarks) {
    const ReferenceImage against = reference(1e-4);
    ConvergenceResult result;
    result.variants.push_back(variant("path", against, 2, rootLaw));
    result.variants.push_back(variant("sppm:clamp=3", against, 2, rootLaw));
    result.variants[1].problem = "the disk <was> \"full\"";
    result.interrupted = true;
    const ConvergenceSummary summary = summarizeConvergence(result, against, false);
    ConvergencePlan plan;
    plan.seeds = {0, 1};
    plan.passes = 4096;
    SceneDescription scene;
    scene.resolution = {2, 2};
    ConvergenceContext context;
    context.scene = "a & b.json";
    context.warnings = {"busy"};
    const ConvergenceReport report{context, plan, scene, against, result, summary};
    const std::vector<std::string> warnings = reportWarnings(report);
    EXPECT_EQ(warnings.size(), 6u) << "busy, interrupted, failed, clamped, same method, floor";
    const auto json = nlohmann::json::parse(summaryJson(report));
    EXPECT_EQ(json["warnings"].size(), warnings.size());
    EXPECT_TRUE(json["variants"][0]["same_method_as_reference"].get<bool>());
    EXPECT_EQ(json["variants"][1]["problem"], result.variants[1].problem);
    const LogLogChart chart = errorChart(report, ErrorMeasure::RelativeError);
    ASSERT_EQ(chart.series.size(), 2u);
    EXPECT_EQ(chart.series[0].name, "path *");
    ASSERT_EQ(chart.levels.size(), 1u);
    EXPECT_NEAR(chart.levels[0].y, 1.0, 1e-6) << "per cent";
    EXPECT_NE(chart.series[0].points[0].tip.find("over 2 seeds"), std::string::npos);
    EXPECT_NE(chartSvg(chart).find("<title>path *: relative error"), std::string::npos);
}

}  // namespace
}  // namespace glint
