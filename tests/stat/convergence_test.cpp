// Convergence runs and references on a scene whose picture is known: each pixel of a floor of albedo a under
// a sky of radiance 1 is a, found with noise by light sampling. Work is counted in passes, so that no result
// depends on the machine. Significance as in support/statistics.h.
#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/report/convergence_run.h"
#include "engine/report/convergence_summary.h"
#include "tests/support/fake_backend.h"
#include "tests/support/light_scene.h"
#include "tests/support/render_scene.h"
#include "tests/support/statistics.h"

namespace glint {
namespace {

constexpr int kSize = 24;
constexpr float kAlbedo = 0.5f;
constexpr float kTruth = 1.0f / (1.0f - kAlbedo);

/// Russian roulette from the first vertex on makes it noisy.
SceneDescription glowingRoom() {
    SceneDescription scene = emptyScene({0.2f, -0.3f, 0.1f}, {1, 0, 0}, 60, kSize);
    Material material = emissiveMaterial(Vec3(1.0f), true);
    material.color.value = Vec3(kAlbedo);
    addObject(&scene, ShapeKind::Sphere, scale(Vec3(2.0f)), material);
    scene.options.maxDepth = 64;
    scene.options.rouletteStartDepth = 0;
    scene.options.sampler = SamplerKind::Independent;
    return scene;
}

ReferenceImage truth() {
    ReferenceImage reference;
    reference.image = {kSize, kSize, std::vector<float>(3 * kSize * kSize, kTruth)};
    reference.variance.assign(3 * kSize * kSize, 0.0f);
    reference.method = "analytic";
    reference.summarize();
    return reference;
}

ConvergenceHost host() {
    ConvergenceHost host;
    host.makeBackend = [](const VariantSettings& settings) {
        return Result<std::unique_ptr<Backend>>(makeCpuBackend(settings.threads));
    };
    return host;
}

ConvergencePlan planOf(const SceneDescription& scene, const char* variants, uint32_t passes, int seeds) {
    ConvergencePlan plan;
    plan.variants = *parseVariants(variants);
    plan.defaults.options = scene.options;
    plan.defaults.sppm = scene.sppm;
    plan.passes = passes;
    plan.points = 8;
    plan.seeds = seedsBeside({}, 11, seeds);
    return plan;
}

double rmse(const MeasuredPoint& point) { return at(point.errors, ErrorMeasure::Rmse); }

TEST(Convergence, TheErrorFallsWithTheRootOfThePasses) {
    const SceneDescription scene = glowingRoom();
    const ConvergenceResult result = runConvergence(planOf(scene, "pt", 256, 8), scene, truth(), host());
    ASSERT_EQ(result.variants.size(), 1u);
    ASSERT_EQ(result.variants[0].curves.size(), 8u);
    test::RunningMean slopes;
    for (const MeasuredCurve& curve : result.variants[0].curves) {
        std::vector<CurvePoint> byPasses;
        for (const MeasuredPoint& point : curve.points) {
            byPasses.push_back({static_cast<double>(point.passes), rmse(point)});
        }
        slopes.add(fitLogLog(std::vector<std::vector<CurvePoint>>(1, byPasses))->slope);
    }
    ASSERT_GT(rmse(result.variants[0].curves[0].points[0]), 0.01) << "there must be noise to measure";
    EXPECT_NEAR(slopes.mean(), -0.5, test::kNormalQuantile * slopes.standardError());
    EXPECT_LT(slopes.standardError(), 0.02) << "a wide interval would accept anything";
}

TEST(Convergence, VarianceBiasAndEfficiencyAreThoseOfTheMethod) {
    const SceneDescription scene = glowingRoom();
    const ReferenceImage reference = truth();
    const ConvergenceResult result = runConvergence(planOf(scene, "pt", 16, 6), scene, reference, host());
    const ConvergenceSummary summary = summarizeConvergence(result, reference, false);
    const VariantSummary& pt = summary.variants[0];
    const double mse = pt.points.back().errors[static_cast<size_t>(ErrorMeasure::Mse)].mean;
    // Without bias the mean squared error is the variance: 6 seeds of 576 grey pixels know it to 2.5 %.
    EXPECT_NEAR(pt.variance / mse, 1.0, 0.15);
    EXPECT_LT(std::fabs(pt.biasSquared), 0.1 * mse);
    EXPECT_NEAR(pt.efficiency * pt.variance * pt.points.back().seconds.mean, 1.0, 1e-9);
    EXPECT_EQ(pt.relativeEfficiency, 1.0);
    EXPECT_FALSE(pt.sameMethodAsReference);
}

TEST(Convergence, ABiasIsToldFromNoise) {
    const SceneDescription scene = glowingRoom();
    ReferenceImage wrong = truth();
    for (float& value : wrong.image.rgb) {
        value += 0.1f;
    }
    wrong.summarize();
    const ConvergenceResult result = runConvergence(planOf(scene, "pt", 16, 4), scene, wrong, host());
    const VariantSummary pt = summarizeConvergence(result, wrong, false).variants[0];
    EXPECT_NEAR(pt.biasSquared, 0.01, 0.005);
    EXPECT_NEAR(pt.points.back().errors[static_cast<size_t>(ErrorMeasure::Bias)].mean, -0.1, 0.02);
}

TEST(Convergence, EverySeedHasTheSamePassesAndItsOwnNoise) {
    const SceneDescription scene = glowingRoom();
    const ConvergenceResult result =
        runConvergence(planOf(scene, "pt,sppm:photons=2000", 9, 3), scene, truth(), host());
    ASSERT_EQ(result.variants.size(), 2u);
    for (const MeasuredVariant& variant : result.variants) {
        ASSERT_EQ(variant.curves.size(), 3u);
        for (const MeasuredCurve& curve : variant.curves) {
            ASSERT_EQ(curve.points.size(), variant.curves[0].points.size());
            EXPECT_EQ(curve.points.back().passes, 9u);
            for (size_t i = 0; i < curve.points.size(); ++i) {
                EXPECT_EQ(curve.points[i].passes, variant.curves[0].points[i].passes);
                EXPECT_TRUE(i == 0 || curve.points[i].seconds > curve.points[i - 1].seconds);
            }
        }
        EXPECT_NE(rmse(variant.curves[0].points[0]), rmse(variant.curves[1].points[0]));
        ASSERT_EQ(variant.images.size(), 2u) << "of a tenth (the first pass) and of the end";
        EXPECT_EQ(variant.images.back().point, variant.curves[0].points.size() - 1);
        EXPECT_TRUE(variant.problem.empty());
    }
}

TEST(Convergence, TimeEndsARunOfAnySpeed) {
    const SceneDescription scene = glowingRoom();
    ConvergencePlan plan = planOf(scene, "pt", 0, 2);
    plan.seconds = 1e-6;  // far less than a pass
    const ConvergenceResult result = runConvergence(plan, scene, truth(), host());
    ASSERT_EQ(result.variants[0].curves.size(), 2u);
    ASSERT_EQ(result.variants[0].curves[0].points.size(), 1u);
    EXPECT_EQ(result.variants[0].curves[0].points[0].passes, 1u);
}

/// Passes that cost nothing, beside evaluations that cost much: SSIM and FLIP of pictures of a
/// quarter megapixel.
TEST(Convergence, SecondsAreThoseOfThePassesAlone) {
    SceneDescription scene = glowingRoom();
    scene.resolution = {256, 256};
    ReferenceImage reference = truth();
    reference.image = {256, 256, std::vector<float>(3 * 256 * 256, 0.5f)};
    reference.variance.clear();
    reference.summarize();
    const auto control = std::make_shared<test::FakeControl>();
    ConvergenceHost fake = host();
    fake.makeBackend = [&](const VariantSettings&) {
        return Result<std::unique_ptr<Backend>>(test::makeFakeBackend(control));
    };
    const auto begin = std::chrono::steady_clock::now();
    const ConvergenceResult result = runConvergence(planOf(scene, "pt", 8, 1), scene, reference, fake);
    const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - begin;
    ASSERT_EQ(result.variants[0].curves[0].points.back().passes, 8u);
    EXPECT_LT(result.variants[0].curves[0].points.back().seconds, 0.5 * whole.count());
    // And what a pass takes is in them.
    control->secondsPerPass = 0.02;
    const ConvergenceResult slow = runConvergence(planOf(scene, "pt", 8, 1), scene, reference, fake);
    EXPECT_GE(slow.variants[0].curves[0].points.back().seconds, 8 * 0.02);
}

/// Each variant and seed begins with a back end and a scene of its own, with the same threads and the
/// first pass.
TEST(Convergence, EachRenderStartsColdOnTheSameThreads) {
    const SceneDescription scene = glowingRoom();
    const auto control = std::make_shared<test::FakeControl>();
    std::vector<int> threads;
    ConvergenceHost fake = host();
    fake.makeBackend = [&](const VariantSettings& settings) {
        threads.push_back(settings.threads);
        return Result<std::unique_ptr<Backend>>(test::makeFakeBackend(control));
    };
    ConvergencePlan plan = planOf(scene, "pt,pt:sampler=sobol", 3, 2);
    plan.defaults.threads = 2;
    (void)runConvergence(plan, scene, truth(), fake);
    EXPECT_EQ(threads, (std::vector<int>{2, 2, 2, 2}));
    EXPECT_EQ(control->scenes, 4);
    const std::vector<PassParams> begun = control->begunPasses();
    ASSERT_EQ(begun.size(), 4u * 3u) << "no pass that is not measured warms anything";
    for (size_t i = 0; i < begun.size(); ++i) {
        EXPECT_EQ(begun[i].pass, i % 3);
    }
}

TEST(Convergence, AnInterruptedRunKeepsWhatItHas) {
    const SceneDescription scene = glowingRoom();
    ConvergenceHost stopping = host();
    int parts = 0;
    stopping.onPart = [&](const std::string&) { ++parts; };
    stopping.stopWanted = [&] { return parts >= 2; };
    ConvergencePlan plan = planOf(scene, "pt", 4, 3);
    plan.passes = 100000000;
    plan.points = 200;
    // The first seed would take for ever too: it is stopped while it measures.
    parts = 2;
    const ConvergenceResult result = runConvergence(plan, scene, truth(), stopping);
    EXPECT_TRUE(result.interrupted);
    ASSERT_EQ(result.variants.size(), 1u);
    EXPECT_EQ(result.variants[0].finalSeeds, 0);
    (void)summarizeConvergence(result, truth(), false);
}

TEST(Convergence, AVariantThatFailsLeavesTheOthers) {
    const SceneDescription scene = glowingRoom();
    ConvergenceHost picky = host();
    picky.makeBackend = [](const VariantSettings& settings) -> Result<std::unique_ptr<Backend>> {
        if (settings.threads == 7) { return Error{"there are no seven threads", {}}; }
        return makeCpuBackend(settings.threads);
    };
    const ConvergenceResult result =
        runConvergence(planOf(scene, "pt:threads=7,pt", 2, 2), scene, truth(), picky);
    EXPECT_EQ(result.variants[0].problem, "there are no seven threads");
    EXPECT_TRUE(result.variants[0].curves.empty());
    EXPECT_EQ(result.variants[1].curves.size(), 2u);
    const ConvergenceSummary summary = summarizeConvergence(result, truth(), false);
    EXPECT_TRUE(summary.variants[0].points.empty());
}

ReferenceImage referenceOf(const SceneDescription& scene, const char* variant, double relativeError = 0.02) {
    ReferencePlan plan{*parseVariant(variant), {scene.options, scene.sppm}, 1e9, relativeError, 1000};
    plan.settings = plan.variant.applyTo(plan.settings);
    auto made = makeReference(plan, scene, host());
    EXPECT_TRUE(made && *made);
    return std::move(**made);
}

TEST(Reference, ItsErrorBarIsTrue) {
    const SceneDescription scene = glowingRoom();
    const ReferenceImage reference = referenceOf(scene, "pt");
    double squares = 0.0;
    for (const float value : reference.image.rgb) {
        const double miss = static_cast<double>(value - kTruth);
        squares += miss * miss / static_cast<double>(reference.image.rgb.size());
    }
    EXPECT_GE(reference.seeds.size(), static_cast<size_t>(kPathReplicates));
    EXPECT_LE(reference.relativeError(), 0.02)
        << "it ends at the error that was asked for, by its own spread";
    EXPECT_GT(reference.relativeError(), 0.01) << "and not long after";
    EXPECT_EQ(reference.endedBy, "precision");
    // 576 grey pixels: both sides have a relative deviation of about 6 %.
    EXPECT_NEAR(squares / reference.mse, 1.0, test::kNormalQuantile * 0.09);
}

/// Otherwise the next run would take it for one that had all its time.
TEST(Reference, AnInterruptedOneSaysSo) {
    const SceneDescription scene = glowingRoom();
    ConvergenceHost stopping = host();
    int parts = 0;
    stopping.onPart = [&](const std::string&) { ++parts; };
    stopping.stopWanted = [&] { return parts >= 4; };
    ReferencePlan plan{*parseVariant("pt"), {scene.options, scene.sppm}, 0.05, 1e-6, 1000};
    const auto made = makeReference(plan, scene, stopping);
    ASSERT_TRUE(made && *made);
    EXPECT_EQ((*made)->seeds.size(), 3u);
    EXPECT_EQ((*made)->endedBy, "interrupt");
    EXPECT_EQ((*made)->timeLimitSeconds, (*made)->renderSeconds);
}

TEST(Reference, ItsErrorAddsToTheMeasuredOneAndCanBeSubtracted) {
    const SceneDescription scene = glowingRoom();
    const ReferenceImage reference = referenceOf(scene, "pt", 0.03);
    const ConvergencePlan plan = planOf(scene, "pt", 64, 6);
    const ConvergenceResult measured = runConvergence(plan, scene, reference, host());
    const ConvergenceResult exact = runConvergence(plan, scene, truth(), host());
    const auto last = [](const ConvergenceResult& result, ErrorMeasure measure) {
        test::RunningMean mean;
        for (const MeasuredCurve& curve : result.variants[0].curves) {
            mean.add(at(curve.points.back().errors, measure));
        }
        return mean.mean();
    };
    const double trueMse = last(exact, ErrorMeasure::Mse);
    ASSERT_GT(reference.mse, 0.05 * trueMse) << "a floor too low to be seen here";
    EXPECT_NEAR(last(measured, ErrorMeasure::Mse), trueMse + reference.mse, 0.1 * (trueMse + reference.mse));
    EXPECT_NEAR(last(measured, ErrorMeasure::MseWithoutReference), trueMse, 0.1 * trueMse);
    const ConvergenceSummary summary = summarizeConvergence(measured, reference, true);
    EXPECT_TRUE(summary.variants[0].sameMethodAsReference);
    EXPECT_NEAR(summary.variants[0].curve.back().error, std::sqrt(trueMse) / reference.mean,
                0.06 * std::sqrt(trueMse) / reference.mean);
}

TEST(Reference, PhotonReferencesAreMarkedAsBiased) {
    const ReferenceImage reference = referenceOf(glowingRoom(), "sppm:photons=2000");
    EXPECT_EQ(reference.seeds.size(), static_cast<size_t>(kPhotonReplicates));
    ASSERT_FALSE(reference.remarks.empty());
    EXPECT_NE(reference.remarks[0].find("bias"), std::string::npos);
}

}  // namespace
}  // namespace glint
