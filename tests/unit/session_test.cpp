// What a session does with limits, pauses and requests, with a fake backend.
#include <gtest/gtest.h>

#include "tests/support/session_bench.h"

namespace glint {
namespace {

using namespace test;

TEST(Session, IsEmptyWithoutAScene) {
    SessionBench bench;
    EXPECT_EQ(bench.session->status().state, SessionState::Empty);
    EXPECT_EQ(bench.session->snapshot(), nullptr);
    EXPECT_FALSE(bench.session->capture().has_value());
    bench.session->restart();
    EXPECT_FALSE(bench.session->capture().has_value());
}

TEST(Session, RendersToThePassLimitAndShowsTheMean) {
    SessionBench bench;
    bench.limit({.passes = 7});
    bench.open(13, 9);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    const auto snapshot = bench.session->snapshot();
    ASSERT_NE(snapshot, nullptr);
    EXPECT_EQ(snapshot->passes, 7u);
    EXPECT_EQ(snapshot->width, 13);
    EXPECT_EQ(snapshot->previewScale, 1);
    double mean = 0.0;
    for (uint32_t pass = 0; pass < 7; ++pass) {
        mean += double(fakeRadiance(4, 5, pass, 0).x) / 7.0;
    }
    EXPECT_FLOAT_EQ(snapshot->radiance[(5 * 13 + 4) * 3], static_cast<float>(mean));
    EXPECT_EQ(bench.session->status().passes, 7u);
}

TEST(Session, RaisingALimitGoesOnWithoutRestarting) {
    SessionBench bench;
    bench.limit({.passes = 3});
    bench.open(8, 8);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    bench.limit({.passes = 5});
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    const SessionStatus status = bench.session->status();
    EXPECT_EQ(status.passes, 5u);
    EXPECT_EQ(status.counters.filmRestarts, 1u);
    EXPECT_EQ(status.counters.filmAllocations, 1u);
}

TEST(Session, StopsAtTheErrorLimitAndAtTheTimeLimit) {
    SessionBench bench;
    bench.limit({.relativeError = 0.05});
    bench.open(8, 8);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_LE(bench.session->status().relativeErrorHigh, 0.05) << "the band's upper end counts";
    const uint32_t passes = bench.session->status().passes;
    EXPECT_GT(passes, 2u);
    bench.control->secondsPerPass = 0.002;
    bench.limit({.renderSeconds = 0.05});
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_GE(bench.session->status().renderSeconds, 0.05);
}

TEST(Session, TheConvergenceCurveGrowsWithTheFilmAndRestartsWithIt) {
    SessionBench bench;
    EXPECT_TRUE(bench.session->convergenceCurve(IntegratorKind::PathTracing)->empty());
    bench.limit({.passes = 100});
    bench.open(8, 8);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    const auto curve = bench.session->convergenceCurve(IntegratorKind::PathTracing);
    ASSERT_FALSE(curve->empty());
    EXPECT_EQ(curve->points().front().passes, 2u);
    EXPECT_EQ(curve->points().back().passes, 100u);
    EXPECT_LE(curve->points().back().renderSeconds, bench.session->status().renderSeconds);
    EXPECT_LT(curve->points().back().relativeError, curve->points()[10].relativeError);
    for (const ConvergencePoint& point : curve->points()) {
        EXPECT_LE(point.relativeErrorLow, point.relativeError);
        EXPECT_GE(point.relativeErrorHigh, point.relativeError);
    }
    EXPECT_TRUE(bench.session->convergenceCurve(IntegratorKind::Sppm)->empty());

    const auto capture = bench.session->capture();
    ASSERT_TRUE(capture.has_value());
    EXPECT_EQ(capture->curve.points().size(), curve->points().size());

    bench.limit({.passes = 3});
    bench.session->restart();
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(bench.session->convergenceCurve(IntegratorKind::PathTracing)->points().size(), 2u);
    EXPECT_EQ(curve->points().back().passes, 100u) << "the old one is not touched";
}

TEST(Session, ErrorMapsComeOnRequest) {
    SessionBench bench;
    bench.limit({.passes = 4});
    bench.open(8, 8);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_TRUE(bench.session->snapshot()->errorBound.empty());
    bench.ask(&RenderRequest::errorMaps, true);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    const auto snapshot = bench.session->snapshot();
    EXPECT_EQ(snapshot->errorBound.size(), 64u);
    EXPECT_TRUE(snapshot->bias.empty()) << "of SPPM alone";
    EXPECT_EQ(bench.session->status().counters.filmRestarts, 1u);
}

TEST(Session, RequestsNeverRestartTheFilm) {
    SessionBench bench;
    bench.limit({.passes = 4});
    bench.open(8, 8);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    bench.ask(&RenderRequest::interacting, true);
    bench.ask(&RenderRequest::aovs, uint32_t{kAovAlbedo});
    bench.ask(&RenderRequest::standardError, true);
    bench.ask(&RenderRequest::interacting, false);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    bench.ask(&RenderRequest::paused, true);
    bench.ask(&RenderRequest::paused, false);
    bench.ask(&RenderRequest::aovs, uint32_t{0});
    bench.ask(&RenderRequest::standardError, false);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    const SessionStatus status = bench.session->status();
    EXPECT_EQ(status.counters.filmRestarts, 1u);
    EXPECT_EQ(status.passes, 4u);
    EXPECT_EQ(bench.control->scenes, 1);
    EXPECT_EQ(status.ticket, 1u);
}

TEST(Session, PauseStopsALongPassAtOnce) {
    SessionBench bench(false);
    bench.open(8, 8);
    ASSERT_TRUE(bench.waitFor([&] { return bench.session->status().passes >= 1; }));
    bench.control->secondsPerPass = 1e6;
    ASSERT_TRUE(bench.waitFor([&] {
        const size_t begun = bench.control->begunPasses().size();
        return begun > 0 && static_cast<int>(begun) > bench.control->passes + bench.control->stopped;
    }));
    bench.ask(&RenderRequest::paused, true);
    EXPECT_EQ(bench.session->wait(kPatience), SessionState::Paused);
}

TEST(Session, ClosingStopsALongPassAndALongBuild) {
    {
        SessionBench bench;
        bench.control->secondsPerPass = 1e6;
        bench.open(8, 8);
        ASSERT_TRUE(bench.waitFor([&] { return !bench.control->begunPasses().empty(); }));
    }
    {
        SessionBench bench;
        bench.control->buildSeconds = 1e6;
        bench.open(8, 8);
        ASSERT_TRUE(bench.waitFor([&] { return bench.session->status().state == SessionState::Building; }));
    }
}

}  // namespace
}  // namespace glint
