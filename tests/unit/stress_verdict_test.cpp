// The rule that judges stability cases: errors put in on purpose are found, noise is not taken for error, and
// what could hide an error is not called ok.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "engine/stress/stress_html.h"
#include "engine/stress/stress_render.h"
#include "engine/stress/stress_scene.h"
#include "engine/stress/stress_suite.h"
#include "engine/stress/stress_summary.h"

namespace glint {
namespace {

StressOutcome outcomeOf(std::vector<StressValue> values, uint64_t samples = 1000) {
    StressOutcome outcome;
    outcome.values = std::move(values);
    outcome.samples = samples;
    return outcome;
}

StressVerdict verdictOf(const StressOutcome& outcome, double tolerance = 0.005) {
    return judgeStress(outcome, tolerance).verdict;
}

TEST(StressQuantile, AgreesWithTables) {
    EXPECT_NEAR(twoSidedQuantile(0.05, 0), 1.959964, 1e-5);
    EXPECT_NEAR(twoSidedQuantile(1e-6, 0), 4.891638, 1e-5);
    EXPECT_NEAR(twoSidedQuantile(0.05, 1), 12.7062, 1e-3);
    EXPECT_NEAR(twoSidedQuantile(0.05, 10), 2.228139, 1e-5);
    EXPECT_NEAR(twoSidedQuantile(0.001, 7), 5.407883, 1e-4);
}

TEST(StressVerdict, ExactValuesAreOk) {
    EXPECT_EQ(verdictOf(outcomeOf({{1.0, 1.0, 0.0, 0}})), StressVerdict::Ok);
    EXPECT_EQ(verdictOf(outcomeOf({{1.004, 1.0, 0.0, 0}})), StressVerdict::Ok);
    EXPECT_EQ(verdictOf(outcomeOf({{0.0, 0.0, 0.0, 0}})), StressVerdict::Ok);
}

TEST(StressVerdict, SureDeviationsAreDegradedAndThenBroken) {
    EXPECT_EQ(verdictOf(outcomeOf({{1.006, 1.0, 0.0, 0}})), StressVerdict::Degraded);
    EXPECT_EQ(verdictOf(outcomeOf({{0.952, 1.0, 0.0, 0}})), StressVerdict::Degraded);
    EXPECT_EQ(verdictOf(outcomeOf({{1.051, 1.0, 0.0, 0}})), StressVerdict::Broken);
    EXPECT_EQ(verdictOf(outcomeOf({{0.94, 1.0, 0.0, 0}})), StressVerdict::Broken);
}

TEST(StressVerdict, NoiseExcusesADeviationButNotAnIntervalThatHidesOne) {
    // 4.9 standard errors of 0.01 are an interval of 4.9 %.
    EXPECT_EQ(verdictOf(outcomeOf({{1.03, 1.0, 0.01, 0}})), StressVerdict::Ok);
    const StressJudgement noisy = judgeStress(outcomeOf({{1.03, 1.0, 0.02, 0}}), 0.005);
    EXPECT_EQ(noisy.verdict, StressVerdict::Degraded);
    EXPECT_NE(noisy.reason.find("too noisy"), std::string::npos) << noisy.reason;
    EXPECT_EQ(verdictOf(outcomeOf({{2.0, 1.0, 0.02, 0}})), StressVerdict::Broken);
}

TEST(StressVerdict, FewDegreesOfFreedomWidenTheInterval) {
    const double few = judgeStress(outcomeOf({{1.0, 1.0, 0.001, 7}}), 0.005).halfWidth;
    const double many = judgeStress(outcomeOf({{1.0, 1.0, 0.001, 0}}), 0.005).halfWidth;
    EXPECT_GT(few, 3.0 * many);
}

TEST(StressVerdict, TheWorstOfManyValuesDecides) {
    std::vector<StressValue> values(16, {1.0, 1.0, 0.0, 0});
    values[11] = {1.2, 1.0, 0.001, 0};
    const StressJudgement judgement = judgeStress(outcomeOf(values), 0.005);
    EXPECT_EQ(judgement.verdict, StressVerdict::Broken);
    EXPECT_EQ(judgement.worst, 11u);
    EXPECT_NEAR(judgement.deviation, 0.2, 1e-12);
}

TEST(StressVerdict, DarkPartsAreMeasuredByTheWhole) {
    std::vector<StressValue> values(10, {1.0, 1.0, 0.0, 0});
    values[0] = {0.0002, 0.0001, 0.0, 0};  // twice as bright, and still black
    EXPECT_EQ(verdictOf(outcomeOf(values)), StressVerdict::Ok);
    values[0] = {0.02, 0.0001, 0.0, 0};
    EXPECT_EQ(verdictOf(outcomeOf(values)), StressVerdict::Broken);
}

TEST(StressVerdict, DroppedSamplesAreNeverOk) {
    StressOutcome outcome = outcomeOf({{1.0, 1.0, 0.0, 0}}, 100000);
    outcome.faults[static_cast<size_t>(SampleFault::NotANumber)] = 1;
    EXPECT_EQ(verdictOf(outcome), StressVerdict::Degraded);
    outcome.faults[static_cast<size_t>(SampleFault::Negative)] = 200;
    EXPECT_EQ(verdictOf(outcome), StressVerdict::Broken);
}

TEST(StressVerdict, NothingAndNotANumberAreBroken) {
    EXPECT_EQ(verdictOf({}), StressVerdict::Broken);
    EXPECT_EQ(verdictOf(outcomeOf({{std::nan(""), 1.0, 0.0, 0}})), StressVerdict::Broken);
    EXPECT_EQ(verdictOf(outcomeOf({{1.0, 1.0, 0.0, 0}, {1.0, HUGE_VAL, 0.0, 0}})), StressVerdict::Broken);
    EXPECT_EQ(verdictOf(outcomeOf({{1.0, 1.0, HUGE_VAL, 0}})), StressVerdict::Broken);
}

/// The rule's own error rate: 4000 right cases of normal noise at a significance of 1e-6 give no alarm (an
/// expected 0.004 of them), and a bias of twice the interval is always found.
TEST(StressVerdict, NormalNoiseGivesNoFalseAlarmAndBiasIsFound) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> noise;
    for (int i = 0; i < 4000; ++i) {
        std::vector<StressValue> right;
        std::vector<StressValue> wrong;
        for (int k = 0; k < 16; ++k) {
            right.push_back({1.0 + 0.005 * noise(random), 1.0, 0.005, 0});
            wrong.push_back({1.0 + 0.005 * noise(random) + (k == 3 ? 0.12 : 0.0), 1.0, 0.005, 0});
        }
        ASSERT_EQ(verdictOf(outcomeOf(right), 0.0), StressVerdict::Ok);
        ASSERT_EQ(verdictOf(outcomeOf(wrong), 0.0), StressVerdict::Broken);
    }
}

/// A grey floor under an even sky whose albedo is not what the truth says.
StressCase floorCase(float albedo, double truth) {
    StressCase c;
    c.family = "floor";
    c.grade = "wrong on purpose";
    c.extreme = "nothing";
    c.truth = "albedo";
    c.run = [=](const StressEffort& effort) {
        SceneDescription scene = emptyStressScene({0.2f, 1, 0}, {0, 0, 0}, 10.0f);
        scene.environment.color = Vec3(1.0f);
        addObject(&scene, ShapeKind::Plane, placeFlatShape({0, 0, 0}, {0, 1, 0}, 1, 1),
                  diffuseMaterial(albedo));
        return measurePaths(scene, effort.passes(16), truth, effort);
    };
    return c;
}

TEST(StressSuite, FindsErrorsThatWerePutIn) {
    const auto verdict = [](float albedo, double truth) {
        const StressCase c = floorCase(albedo, truth);
        const auto result = runStressCase(c, {});
        EXPECT_TRUE(result);
        return result->judgement.verdict;
    };
    EXPECT_EQ(verdict(0.5f, 0.5), StressVerdict::Ok);
    EXPECT_EQ(verdict(0.51f, 0.5), StressVerdict::Degraded);
    EXPECT_EQ(verdict(0.6f, 0.5), StressVerdict::Broken);
}

TEST(StressSuite, FindsAPairedDifference) {
    const SceneDescription room = stressRoom();
    SceneDescription brighter = room;
    for (Material& material : brighter.materials) {
        material.emission.value *= 1.02f;
    }
    const auto same = measurePathsAgainst(room, room, 8, {});
    const auto other = measurePathsAgainst(brighter, room, 8, {});
    ASSERT_TRUE(same && other);
    EXPECT_EQ(verdictOf(*same, 0.0), StressVerdict::Ok);
    EXPECT_NE(verdictOf(*other, 0.005), StressVerdict::Ok);
}

TEST(StressSuite, ARefusedSceneIsBrokenWithItsMessage) {
    StressCase c = floorCase(0.5f, 0.5);
    c.run = [](const StressEffort& effort) {
        SceneDescription scene = emptyStressScene({0, 0, 0}, {0, 0, 1}, 500.0f);
        return measurePaths(scene, 1, 1.0, effort);
    };
    const auto result = runStressCase(c, {});
    ASSERT_TRUE(result);
    EXPECT_EQ(result->judgement.verdict, StressVerdict::Broken);
    EXPECT_NE(result->judgement.reason.find("field of view"), std::string::npos) << result->judgement.reason;
    EXPECT_TRUE(result->unexpected());
}

TEST(StressSuite, AStoppedCaseIsAnErrorAndNoVerdict) {
    const std::atomic<bool> stop{true};
    const StressCase c = floorCase(0.5f, 0.5);
    EXPECT_FALSE(runStressCase(c, {.quick = true, .threads = 1, .stop = &stop}));
}

TEST(StressSuite, EveryCaseHasAnIdentityOfItsOwn) {
    std::vector<std::string> names;
    for (const StressCase& c : stressCases()) {
        names.push_back(c.family + "/" + c.grade);
        EXPECT_FALSE(c.extreme.empty()) << names.back();
        EXPECT_FALSE(c.truth.empty()) << names.back();
        EXPECT_FALSE(stressFamilyAbout(c.family).empty()) << names.back();
        EXPECT_EQ(c.documented == StressVerdict::Ok, c.limit.empty()) << names.back();
    }
    std::ranges::sort(names);
    EXPECT_EQ(std::ranges::adjacent_find(names), names.end()) << *std::ranges::adjacent_find(names);
    EXPECT_GT(names.size(), 150u);
}

TEST(StressSuite, FiltersByFamilyAndByPartOfAName) {
    const auto scale = filterStressCases(stressCases(), "scale");
    ASSERT_TRUE(scale);
    for (const StressCase& c : *scale) {
        EXPECT_EQ(c.family, "scale");
    }
    const auto part = filterStressCases(stressCases(), "albedo/sphere");
    ASSERT_TRUE(part);
    EXPECT_LT(part->size(), filterStressCases(stressCases(), "albedo")->size());
    EXPECT_EQ(filterStressCases(stressCases(), "")->size(), stressCases().size());
    const auto none = filterStressCases(stressCases(), "scael");
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("did you mean 'scale'"), std::string::npos) << none.error().message;
}

TEST(StressReport, HtmlNeedsNothingElseAndEscapes) {
    StressCase c = floorCase(0.5f, 0.5);
    c.extreme = "<script>&\"";
    c.documented = StressVerdict::Broken;
    c.limit = "a < b";
    std::vector<StressResult> results(1);
    results[0].stressCase = &c;
    results[0].outcome = outcomeOf({{1.2, 1.0, 0.0, 0}});
    results[0].judgement = judgeStress(results[0].outcome, c.tolerance);
    const std::string page = stressHtml(results, true);
    for (const char* foreign : {"http:", "https:", "src=", "<script", "url(", "@import"}) {
        EXPECT_EQ(page.find(foreign), std::string::npos) << foreign;
    }
    EXPECT_NE(page.find("&lt;script&gt;&amp;&quot;"), std::string::npos);
    EXPECT_NE(page.find("a &lt; b"), std::string::npos);
    EXPECT_NE(page.find("class=\"broken\""), std::string::npos);
    EXPECT_NE(stressMarkdown(results).find("| floor | 0 | 0 | 1 |"), std::string::npos)
        << stressMarkdown(results);
}

}  // namespace
}  // namespace glint
