// The errors against a reference as a film grows, restarts, goes back to a checkpoint or changes its size;
// and the table of the curves.
#include "viewer/model/reference_errors.h"

#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "viewer/model/convergence_csv.h"

namespace glint {
namespace {

using testing::HasSubstr;

constexpr int kSize = 4;

std::shared_ptr<const FilmSnapshot> snapshotOf(uint32_t passes, float value, int width = kSize) {
    auto snapshot = std::make_shared<FilmSnapshot>();
    snapshot->width = width;
    snapshot->height = kSize;
    snapshot->passes = passes;
    snapshot->renderSeconds = 0.5 * passes;
    snapshot->radiance.assign(static_cast<size_t>(width) * kSize * 3, value);
    return snapshot;
}

ConvergenceCurve curveFrom(double firstSeconds) {
    ConvergenceCurve curve;
    curve.add({.passes = 2, .renderSeconds = firstSeconds, .relativeError = 0.1});
    return curve;
}

struct Bench {
    ReferenceErrors errors;

    explicit Bench(float reference) {
        const ImageF image{kSize, kSize, std::vector<float>(kSize * kSize * 3, reference)};
        EXPECT_TRUE(saveHdr("reference.hdr", image));
        errors.load("reference.hdr", {kSize, kSize});
        settle();
        errors.follow(IntegratorKind::PathTracing, curveFrom(1.0));
    }
    void settle() {
        for (int i = 0; i < 20000 && (errors.loading() || errors.measuring()); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            errors.refresh();
        }
    }
    void observe(uint32_t passes, float value, bool resting = false, int width = kSize) {
        errors.observe(snapshotOf(passes, value, width), resting);
        settle();
    }
    std::vector<uint32_t> passes() const {
        std::vector<uint32_t> all;
        for (const ReferencePoint& point : errors.points(IntegratorKind::PathTracing)) {
            all.push_back(point.passes);
        }
        return all;
    }
};

TEST(ReferenceErrors, AnotherSizeNeverReplacesAGoodReference) {
    Bench bench(0.5f);
    const ImageF small{2, 1, std::vector<float>(6, 0.25f)};
    ASSERT_TRUE(saveHdr("small.hdr", small));
    bench.errors.load("small.hdr", {kSize, kSize});
    bench.settle();
    ASSERT_TRUE(bench.errors.loadError());
    EXPECT_THAT(bench.errors.loadError()->format(), HasSubstr("small.hdr"));
    ASSERT_TRUE(bench.errors.loaded());
    EXPECT_EQ(bench.errors.loaded()->path, "reference.hdr");
    bench.errors.load("small.hdr", {2, 1});
    bench.settle();
    EXPECT_EQ(bench.errors.loaded()->path, "small.hdr") << "the picture has its size now";
}

TEST(ReferenceErrors, NothingIsRelativeToABlackReference) {
    Bench bench(0.0f);
    EXPECT_THAT(bench.errors.mismatch(kSize, kSize), HasSubstr("black"));
}

TEST(ReferenceErrors, AreMeasuredAtGrowingDistancesAndAtTheEnd) {
    Bench bench(0.5f);
    ASSERT_TRUE(bench.errors.loaded());
    EXPECT_DOUBLE_EQ(bench.errors.loaded()->mean, 0.5);
    for (uint32_t pass = 2; pass <= 40; ++pass) {
        bench.observe(pass, 1.0f);
    }
    EXPECT_THAT(bench.passes(),
                testing::ElementsAre(2, 3, 4, 5, 6, 7, 9, 11, 13, 15, 18, 21, 25, 29, 34, 40));
    bench.observe(41, 1.0f, true);
    EXPECT_EQ(bench.passes().back(), 41u);
    const ReferencePoint& last = bench.errors.points(IntegratorKind::PathTracing).back();
    EXPECT_NEAR(last.rmseOverMean, 1.0, 1e-6);
    EXPECT_NEAR(last.relativeRmse, 0.5 / std::sqrt(0.26), 1e-6);
    EXPECT_NEAR(last.mape, 0.5 / 0.51, 1e-6);
    EXPECT_NEAR(last.relativeBias, 1.0, 1e-6);
    EXPECT_DOUBLE_EQ(last.renderSeconds, 20.5);
    EXPECT_TRUE(bench.errors.points(IntegratorKind::Sppm).empty());
}

TEST(ReferenceErrors, BeginAnewWithTheFilmAndGoBackWithACheckpoint) {
    Bench bench(0.5f);
    for (const uint32_t pass : {2u, 4u, 8u}) {
        bench.observe(pass, 1.0f);
    }
    bench.errors.follow(IntegratorKind::PathTracing, curveFrom(1.0));
    EXPECT_EQ(bench.passes().size(), 3u) << "the same film";
    bench.observe(5, 1.0f);
    EXPECT_THAT(bench.passes(), testing::ElementsAre(2, 4, 5)) << "resumed";
    bench.errors.follow(IntegratorKind::PathTracing, {});
    EXPECT_TRUE(bench.passes().empty()) << "restarted";
    bench.observe(9, 1.0f);
    EXPECT_TRUE(bench.passes().empty()) << "a picture of the film before";
    bench.errors.follow(IntegratorKind::PathTracing, curveFrom(1.5));
    bench.observe(3, 1.0f);
    EXPECT_THAT(bench.passes(), testing::ElementsAre(3));
}

TEST(ReferenceErrors, AFilmOfMoreThanAFewPointsIsKeptForComparison) {
    Bench bench(0.5f);
    const auto before = [&] { return bench.errors.pointsBefore(IntegratorKind::PathTracing).size(); };
    for (uint32_t pass = 2; pass <= 6; ++pass) {
        bench.observe(pass, 1.0f);
    }
    EXPECT_EQ(before(), 0u);
    bench.errors.follow(IntegratorKind::PathTracing, {});
    EXPECT_EQ(before(), 5u);
    bench.errors.follow(IntegratorKind::PathTracing, curveFrom(1.5));
    for (uint32_t pass = 2; pass <= 4; ++pass) {
        bench.observe(pass, 1.0f);
    }
    bench.errors.follow(IntegratorKind::PathTracing, {});
    EXPECT_EQ(before(), 5u) << "a film of three points does not take its place";
    bench.errors.clear();
    EXPECT_EQ(before(), 0u);
}

TEST(ReferenceErrors, AnotherSizeIsNotCompared) {
    Bench bench(0.5f);
    bench.observe(4, 1.0f, true, 2 * kSize);
    EXPECT_TRUE(bench.passes().empty());
    EXPECT_EQ(bench.errors.mismatch(kSize, kSize), "");
    EXPECT_THAT(bench.errors.mismatch(8, 4), HasSubstr("4 × 4 pixels, the picture 8 × 4"));
    bench.errors.load("missing.exr", {kSize, kSize});
    bench.settle();
    ASSERT_TRUE(bench.errors.loadError());
    EXPECT_THAT(bench.errors.loadError()->format(), HasSubstr("missing.exr"));
    EXPECT_TRUE(bench.errors.loaded()) << "the one before stays";
    bench.errors.clear();
    EXPECT_FALSE(bench.errors.loaded());
    EXPECT_FALSE(bench.errors.loadError());
}

TEST(ConvergenceCsv, HasALineForEachPoint) {
    const ReferencePoint point{.passes = 3,
                               .renderSeconds = 2.5,
                               .pictureError = 0.75,
                               .relativeRmse = 0.25,
                               .rmseOverMean = 0.5,
                               .mape = 0.125,
                               .relativeBias = -0.0625};
    EXPECT_EQ(convergenceCsv(
                  {{IntegratorKind::PathTracing, curveFrom(1.25), {}}, {IntegratorKind::Sppm, {}, {point}}}),
              "integrator,source,passes,render_seconds,relative_error,low_90,high_90,estimated_bias,"
              "relative_rmse,rmse_over_mean,mape,relative_bias\n"
              "path,estimate,2,1.25,0.1,0,0,0,,,,\n"
              "sppm,reference,3,2.5,0.75,,,,0.25,0.5,0.125,-0.0625\n");
}

}  // namespace
}  // namespace glint
