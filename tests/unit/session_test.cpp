// What a session does with edits, pauses, limits and failures, with a fake backend: no renderer, no OpenMP,
// so that the thread sanitizer sees every lock.
#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "engine/builders/scene_builder.h"
#include "tests/support/fake_backend.h"

namespace glint {
namespace {

using test::FakeControl;
using test::fakeOptions;
using test::fakeRadiance;
using test::fakeScene;
using test::makeFakeBackend;

constexpr double kPatience = 60.0;

struct Bench {
    std::shared_ptr<FakeControl> control = std::make_shared<FakeControl>();
    SessionOptions options = fakeOptions(control);
    std::unique_ptr<RenderSession> session;
    RenderRequest request;

    explicit Bench(bool previews = true) {
        options.previews = previews;
        session = std::make_unique<RenderSession>(makeFakeBackend(control), options);
    }
    /// Changes one thing of what is asked for.
    template <class Value>
    void ask(Value RenderRequest::*what, Value value) {
        request.*what = std::move(value);
        session->request(request);
    }
    void limit(const StopLimits& limits) { ask(&RenderRequest::limits, limits); }
    void open(int width, int height) { session->post({fakeScene(width, height), EditKind::Everything}); }
    bool waitFor(const std::function<bool()>& condition) const {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(kPatience);
        while (!condition()) {
            if (std::chrono::steady_clock::now() > end) { return false; }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return true;
    }
};

TEST(Session, IsEmptyWithoutAScene) {
    Bench bench;
    EXPECT_EQ(bench.session->status().state, SessionState::Empty);
    EXPECT_EQ(bench.session->snapshot(), nullptr);
    EXPECT_FALSE(bench.session->capture().has_value());
    bench.session->restart();
    EXPECT_FALSE(bench.session->capture().has_value());
}

TEST(Session, RendersToThePassLimitAndShowsTheMean) {
    Bench bench;
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
    Bench bench;
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
    Bench bench;
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
    Bench bench;
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
    Bench bench;
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
    Bench bench;
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

TEST(Session, AovsAndStandardErrorsComeOnRequestAlsoWhenFinished) {
    Bench bench;
    bench.limit({.passes = 4});
    bench.open(8, 8);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(bench.session->snapshot()->aovs, nullptr);
    EXPECT_TRUE(bench.session->snapshot()->standardError.empty());
    EXPECT_EQ(bench.control->aovPasses, 0);

    bench.ask(&RenderRequest::aovs, uint32_t{kAovDepth});
    bench.ask(&RenderRequest::standardError, true);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    const auto snapshot = bench.session->snapshot();
    ASSERT_NE(snapshot->aovs, nullptr);
    EXPECT_EQ(snapshot->aovs->passes(), kAovPasses);
    EXPECT_EQ(snapshot->standardError.size(), 64u);
    EXPECT_EQ(bench.session->status().passes, 4u);
}

TEST(Session, LayersThatAnEditKeepsHaveTheImagesSizeAfterPreviews) {
    Bench bench;
    const auto scene = fakeScene(64, 64);
    scene->options.integrator = IntegratorKind::Sppm;
    bench.limit({.passes = 2});
    bench.ask(&RenderRequest::aovs, uint32_t{kAovDepth});
    bench.ask(&RenderRequest::standardError, false);
    bench.control->secondsPerPath = 1e-5;
    bench.session->post({scene, EditKind::Everything});
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    // Several: a preview's layers are at hand or not by chance when the motion ends.
    for (int edit = 0; edit < 6; ++edit) {
        const auto edited = std::make_shared<SceneDescription>(*scene);
        edited->sppm.alpha = 0.6f + 0.01f * static_cast<float>(edit);
        bench.ask(&RenderRequest::interacting, true);
        bench.session->post({edited, EditKind::SppmParameters});
        ASSERT_TRUE(bench.waitFor([&] {
            const auto shown = bench.session->snapshot();
            return shown->previewScale > 1 && shown->aovs != nullptr;
        }));
        std::this_thread::sleep_for(std::chrono::milliseconds(7 * edit));
        bench.ask(&RenderRequest::interacting, false);
        ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
        const auto snapshot = bench.session->snapshot();
        ASSERT_NE(snapshot->aovs, nullptr);
        EXPECT_EQ(snapshot->aovs->width(), 64);
        EXPECT_EQ(snapshot->aovs->passes(), kAovPasses);
    }
}

TEST(Session, ACaptureThatIsAskedForDuringAPassCostsNoFurtherOne) {
    Bench bench(false);
    bench.control->secondsPerPass = 0.2;
    bench.open(8, 8);
    ASSERT_TRUE(bench.waitFor([&] { return !bench.control->begunPasses().empty(); }));
    const auto capture = bench.session->capture();
    ASSERT_TRUE(capture.has_value());
    EXPECT_EQ(capture->film.passes(), 1u);
}

TEST(Session, CapturesHaveTheLayersThatWereAskedFor) {
    Bench bench(false);
    bench.limit({.passes = 2});
    bench.open(8, 8);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    bench.request.aovs = kAovDepth;
    bench.ask(&RenderRequest::paused, true);
    const auto capture = bench.session->capture();
    ASSERT_TRUE(capture.has_value());
    EXPECT_GT(capture->aovs.passes(), 0u);
}

TEST(Session, LayersGetNoMorePassesThanTheFilmWhereThatIsAskedFor) {
    Bench bench(false);
    bench.request.aovs = kAovDepth;
    bench.request.aovsEndWithFilm = true;
    bench.limit({.passes = 3});
    bench.open(8, 8);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(bench.session->status().aovPasses, 3u);
}

TEST(Session, AnEditThatNoImageShowsRestartsNothing) {
    Bench bench;
    bench.options.build = buildScene;
    bench.session = std::make_unique<RenderSession>(makeFakeBackend(bench.control), bench.options);
    bench.limit({.passes = 3});
    auto scene = fakeScene(8, 8);
    bench.session->post({scene, EditKind::Everything});
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    const auto restartsAfter = [&](EditKind kinds) {
        scene = std::make_shared<SceneDescription>(*scene);
        scene->camera.focalDistance *= 2.0f;  // of a pinhole
        const uint64_t before = bench.session->status().counters.filmRestarts;
        bench.session->post({scene, kinds});
        EXPECT_EQ(bench.session->wait(kPatience), SessionState::Finished);
        EXPECT_EQ(bench.session->status().passes, 3u);
        return bench.session->status().counters.filmRestarts - before;
    };
    EXPECT_EQ(restartsAfter(EditKind::Camera), 0u);
    EXPECT_EQ(restartsAfter(EditKind::Camera | EditKind::Lights | EditKind::MaterialParameters), 0u);
    EXPECT_EQ(restartsAfter(EditKind::Camera | EditKind::Options), 1u) << "options are not the built scene's";
    EXPECT_EQ(restartsAfter(EditKind::Everything), 1u);
    bench.session->restart();
    EXPECT_EQ(restartsAfter(EditKind::Camera), 1u) << "a restart that was asked for, too";
}

TEST(Session, EachEditRebuildsWhatItNamesOnly) {
    Bench bench;
    bench.limit({.passes = 2});
    bench.open(8, 8);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    SessionCounters expected = bench.session->status().counters;
    const auto after = [&](EditKind kinds, int width) {
        bench.session->post({fakeScene(width, 8), kinds});
        EXPECT_EQ(bench.session->wait(kPatience), SessionState::Finished);
        return bench.session->status().counters;
    };
    auto expectSame = [&](const SessionCounters& now) {
        EXPECT_EQ(now.materialTables, expected.materialTables);
        EXPECT_EQ(now.lightTables, expected.lightTables);
        EXPECT_EQ(now.topLevelBuilds, expected.topLevelBuilds);
        EXPECT_EQ(now.filmRestarts, expected.filmRestarts);
        EXPECT_EQ(now.filmAllocations, expected.filmAllocations);
    };
    ++expected.filmRestarts;
    expectSame(after(EditKind::Camera, 8));
    ++expected.filmRestarts;
    expectSame(after(EditKind::Options, 8));
    ++expected.filmRestarts, ++expected.materialTables;
    expectSame(after(EditKind::MaterialParameters, 8));
    ++expected.filmRestarts, ++expected.lightTables;
    expectSame(after(EditKind::Lights, 8));
    ++expected.filmRestarts, ++expected.topLevelBuilds;
    expectSame(after(EditKind::ObjectTransform, 8));
    ++expected.filmRestarts, ++expected.filmAllocations;
    expectSame(after(EditKind::Resolution, 16));
    const int scenes = bench.control->scenes;
    expectSame(after(EditKind::SppmParameters, 16));
    expectSame(after(EditKind::None, 16));
    EXPECT_EQ(bench.control->scenes, scenes) << "SPPM settings and nothing at all need no build";
}

TEST(Session, PausedShowsOnePassAfterAnEditAndRestsThen) {
    Bench bench;
    bench.ask(&RenderRequest::paused, true);
    bench.open(8, 8);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Paused);
    EXPECT_EQ(bench.session->status().passes, 1u);
    bench.session->post({fakeScene(8, 8), EditKind::Camera});
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Paused);
    EXPECT_EQ(bench.session->status().passes, 1u);
    EXPECT_EQ(bench.session->snapshot()->ticket, 2u);
    bench.limit({.passes = 3});
    bench.ask(&RenderRequest::paused, false);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
}

TEST(Session, PauseStopsALongPassAtOnce) {
    Bench bench(false);
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
        Bench bench;
        bench.control->secondsPerPass = 1e6;
        bench.open(8, 8);
        ASSERT_TRUE(bench.waitFor([&] { return !bench.control->begunPasses().empty(); }));
    }
    {
        Bench bench;
        bench.control->buildSeconds = 1e6;
        bench.open(8, 8);
        ASSERT_TRUE(bench.waitFor([&] { return bench.session->status().state == SessionState::Building; }));
    }
}

TEST(Session, ANewSceneAbandonsTheBuildOfTheOneBefore) {
    Bench bench;
    bench.limit({.passes = 1});
    bench.control->buildSeconds = 1e6;
    bench.open(8, 8);
    ASSERT_TRUE(bench.waitFor([&] { return bench.session->status().state == SessionState::Building; }));
    bench.open(4, 4);
    ASSERT_TRUE(bench.waitFor([&] { return bench.session->status().ticket == 2; }));
    bench.control->buildSeconds = 0.0;
    bench.open(6, 6);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(bench.session->snapshot()->width, 6);
    EXPECT_EQ(bench.session->status().counters.editsRefused, 0u);
}

TEST(Session, ABadSceneLeavesTheOldOneRunning) {
    Bench bench;
    bench.limit({.passes = 5});
    bench.open(8, 8);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    const auto before = bench.session->snapshot();
    bench.control->buildsFailing = 1;
    bench.open(32, 32);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    SessionStatus status = bench.session->status();
    EXPECT_NE(status.error.find("teapot"), std::string::npos);
    EXPECT_EQ(status.passes, 5u);
    EXPECT_EQ(bench.session->snapshot()->width, 8);
    EXPECT_EQ(status.counters.filmRestarts, 1u);
    bench.limit({.passes = 6});
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(bench.session->status().passes, 6u);

    // The next edit makes up for the one that was refused.
    const uint64_t materials = bench.session->status().counters.materialTables;
    bench.session->post({fakeScene(8, 8), EditKind::Camera});
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    status = bench.session->status();
    EXPECT_TRUE(status.error.empty());
    EXPECT_EQ(status.counters.materialTables, materials + 1);
}

TEST(Session, ABadFirstSceneFailsAndAGoodOneRecovers) {
    Bench bench;
    bench.limit({.passes = 2});
    bench.control->buildsFailing = 1;
    bench.open(8, 8);
    EXPECT_EQ(bench.session->wait(kPatience), SessionState::Failed);
    EXPECT_FALSE(bench.session->capture().has_value());
    bench.session->post({fakeScene(8, 8), EditKind::Camera});
    EXPECT_EQ(bench.session->wait(kPatience), SessionState::Finished);
}

TEST(Session, BackendErrorsAndExceptionsFailWithAMessageAndARestartTriesAgain) {
    Bench bench;
    bench.limit({.passes = 2});
    bench.control->failPasses = true;
    bench.open(8, 8);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Failed);
    EXPECT_EQ(bench.session->status().error, "the device was lost");
    bench.control->failPasses = false;
    bench.control->throwInPass = true;
    bench.session->restart();
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Failed);
    EXPECT_NE(bench.session->status().error.find("thrown in a pass"), std::string::npos);
    bench.control->throwInPass = false;
    bench.session->restart();
    EXPECT_EQ(bench.session->wait(kPatience), SessionState::Finished);
}

TEST(Session, ALastGoodImageOutlivesAFailure) {
    Bench bench;
    bench.open(8, 8);
    ASSERT_TRUE(
        bench.waitFor([&] { return bench.session->status().passes > 0 && bench.session->snapshot(); }));
    bench.control->failPasses = true;
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Failed);
    EXPECT_NE(bench.session->snapshot(), nullptr);
    EXPECT_TRUE(bench.session->capture().has_value());
}

TEST(Session, AHeavySceneShowsAPreviewFirstAndThenTheWholeImage) {
    Bench bench;
    bench.limit({.passes = 1});
    bench.control->secondsPerPath = 2e-5;  // 0.33 s for 128x128
    bench.open(128, 128);
    ASSERT_TRUE(bench.waitFor([&] { return bench.session->snapshot() != nullptr; }));
    EXPECT_GT(bench.session->snapshot()->previewScale, 1);
    EXPECT_LT(bench.session->snapshot()->width, 128);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(bench.session->snapshot()->previewScale, 1);
    EXPECT_EQ(bench.session->snapshot()->width, 128);
    EXPECT_EQ(bench.session->status().passes, 1u);
}

TEST(Session, InteractingKeepsToPreviewsUntilItEnds) {
    Bench bench;
    bench.limit({.passes = 1});
    bench.control->secondsPerPath = 1e-5;
    bench.ask(&RenderRequest::interacting, true);
    bench.open(128, 128);
    ASSERT_TRUE(bench.waitFor([&] { return bench.session->status().counters.previewPasses > 5; }));
    EXPECT_EQ(bench.session->status().passes, 0u);
    EXPECT_GT(bench.session->snapshot()->previewScale, 1);
    bench.ask(&RenderRequest::interacting, false);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(bench.session->snapshot()->previewScale, 1);

    // Without an edit, interacting changes nothing.
    bench.ask(&RenderRequest::interacting, true);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(bench.session->snapshot()->previewScale, 1);
}

TEST(Session, CaptureWhileInteractingComesAtFullResolution) {
    Bench bench;
    bench.control->secondsPerPath = 1e-5;
    bench.ask(&RenderRequest::interacting, true);
    bench.open(96, 96);
    const auto capture = bench.session->capture();
    ASSERT_TRUE(capture.has_value());
    EXPECT_EQ(capture->film.width(), 96);
    EXPECT_GE(capture->film.passes(), 1u);
}

TEST(Session, CaptureAndResumeGoOnBitForBit) {
    const auto scene = fakeScene(16, 12);
    Bench straight;
    straight.limit({.passes = 9});
    straight.session->post({scene, EditKind::Everything});
    ASSERT_EQ(straight.session->wait(kPatience), SessionState::Finished);
    const auto whole = straight.session->capture();

    Bench first;
    first.limit({.passes = 4});
    first.session->post({scene, EditKind::Everything});
    ASSERT_EQ(first.session->wait(kPatience), SessionState::Finished);
    auto half = first.session->capture();
    ASSERT_TRUE(half.has_value());
    EXPECT_EQ(half->scene, scene);
    const double secondsBefore = half->renderSeconds;

    Bench second;
    second.limit({.passes = 9});
    second.session->resume(half->scene, {.film = std::move(half->film), .renderSeconds = secondsBefore});
    ASSERT_EQ(second.session->wait(kPatience), SessionState::Finished);
    const auto resumed = second.session->capture();
    ASSERT_TRUE(whole && resumed);
    EXPECT_EQ(resumed->film.passes(), 9u);
    EXPECT_GE(resumed->renderSeconds, secondsBefore);
    for (size_t i = 0; i < whole->film.pixels().size(); ++i) {
        ASSERT_EQ(whole->film.pixels()[i].mean, resumed->film.pixels()[i].mean);
        ASSERT_EQ(whole->film.pixels()[i].luminanceM2, resumed->film.pixels()[i].luminanceM2);
    }
    EXPECT_EQ(second.control->begunPasses().front().pass, 4u);
}

TEST(Session, ResumingWithAnotherSizeFails) {
    Bench bench;
    bench.session->resume(fakeScene(8, 8), {.film = Film(9, 8), .renderSeconds = 1.0});
    EXPECT_EQ(bench.session->wait(kPatience), SessionState::Failed);
    EXPECT_NE(bench.session->status().error.find("9x8"), std::string::npos);
}

TEST(Session, AContinuousDragStillShowsImages) {
    Bench bench;
    bench.control->secondsPerPath = 3e-6;
    bench.open(128, 128);
    ASSERT_TRUE(bench.waitFor([&] { return bench.session->status().passes > 0; }));
    bench.ask(&RenderRequest::interacting, true);
    const uint64_t before = bench.session->status().imagesAfterEdits;
    for (int i = 0; i < 100; ++i) {
        bench.session->post({fakeScene(128, 128), EditKind::Camera});
        std::this_thread::sleep_for(std::chrono::milliseconds(4));
    }
    // Edits come faster than previews end; the picture must move all the same.
    EXPECT_GT(bench.session->status().imagesAfterEdits, before + 5);
}

}  // namespace
}  // namespace glint
