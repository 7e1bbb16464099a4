// The statistics of measurements taken by turns: known intervals, and what happens with few turns.
#include "viewer/bench/bench_pairs.h"

#include <gtest/gtest.h>

namespace glint {
namespace {

std::vector<double> upTo(int n) {
    std::vector<double> values;
    for (int i = 1; i <= n; ++i) {
        values.push_back(i);
    }
    return values;
}

/// Ranks and confidences from tables of the binomial distribution: the median's 95 % interval of 10, 15 and
/// 20 values is from the 2nd to the 9th, the 4th to the 12th and the 6th to the 15th.
TEST(BenchPairs, IntervalOfTheMedian) {
    struct Known {
        int n;
        double low, high, confidence;
    };
    for (const Known& known : {Known{6, 1, 6, 0.96875}, Known{10, 2, 9, 0.978516}, Known{15, 4, 12, 0.964844},
                               Known{20, 6, 15, 0.958611}}) {
        const RatioInterval r =
            ratioOf(upTo(known.n), std::vector<double>(static_cast<size_t>(known.n), 1.0));
        EXPECT_EQ(r.low, known.low) << known.n;
        EXPECT_EQ(r.high, known.high) << known.n;
        EXPECT_NEAR(r.confidence, known.confidence, 1e-6) << known.n;
        EXPECT_EQ(r.median, 0.5 * (known.n + 1)) << known.n;
    }
}

TEST(BenchPairs, FewTurnsGiveTheOutermostAndSaySo) {
    const RatioInterval r = ratioOf({2.0, 6.0, 4.0}, {1.0, 2.0, 2.0});
    EXPECT_EQ(r.low, 2.0);
    EXPECT_EQ(r.median, 2.0);
    EXPECT_EQ(r.high, 3.0);
    EXPECT_NEAR(r.confidence, 0.75, 1e-12);
    EXPECT_EQ(ratioOf({1.0}, {2.0}).confidence, 0.0);
    EXPECT_EQ(ratioOf({}, {}).median, 0.0);
}

TEST(BenchPairs, TurnsAlternateAndTheFirstIsThrownAway) {
    std::string order;
    const PairTimes times = measureByTurns(
        3, [&](uint32_t turn) { return order += 'a', static_cast<double>(turn); },
        [&](uint32_t turn) { return order += 'b', 10.0 + turn; });
    EXPECT_EQ(order, "abbaabba");
    EXPECT_EQ(times.first, (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(times.second, (std::vector<double>{11, 12, 13}));
}

TEST(BenchPairs, DifferencesAreCountedByPixel) {
    Film a(2, 1), b(2, 1);
    std::vector<PixelSample> samples(2);
    samples[0].radiance = samples[1].radiance = Vec3(1.0f);
    a.commit(samples, 0, 1);
    EXPECT_FALSE(compareImages(a, b).identical());
    b.commit(samples, 0, 1);
    EXPECT_TRUE(compareImages(a, b).identical());
    samples[1].radiance.y = 2.0f;
    a.commit(samples, 1, 1);
    samples[1].radiance.y = 2.5f;
    b.commit(samples, 1, 1);
    const ImageDifference difference = compareImages(a, b);
    EXPECT_EQ(difference.different, 1u);
    EXPECT_NEAR(difference.largest, 0.25 / (6.5 / 6.0), 1e-9);
}

}  // namespace
}  // namespace glint
