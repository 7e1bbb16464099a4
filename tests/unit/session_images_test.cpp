// What a session does with previews, layers and captures, with a fake backend.
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/session_bench.h"

namespace glint {
namespace {

using namespace test;

TEST(Session, AovsAndStandardErrorsComeOnRequestAlsoWhenFinished) {
    SessionBench bench;
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
    SessionBench bench;
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
    SessionBench bench(false);
    bench.control->secondsPerPass = 0.2;
    bench.open(8, 8);
    ASSERT_TRUE(bench.waitFor([&] { return !bench.control->begunPasses().empty(); }));
    const auto capture = bench.session->capture();
    ASSERT_TRUE(capture.has_value());
    EXPECT_EQ(capture->film.passes(), 1u);
}

TEST(Session, CapturesHaveTheLayersThatWereAskedFor) {
    SessionBench bench(false);
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
    SessionBench bench(false);
    bench.request.aovs = kAovDepth;
    bench.request.aovsEndWithFilm = true;
    bench.limit({.passes = 3});
    bench.open(8, 8);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(bench.session->status().aovPasses, 3u);
}

TEST(Session, AHeavySceneShowsAPreviewFirstAndThenTheWholeImage) {
    SessionBench bench;
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
    SessionBench bench;
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
    SessionBench bench;
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
    SessionBench straight;
    straight.limit({.passes = 9});
    straight.session->post({scene, EditKind::Everything});
    ASSERT_EQ(straight.session->wait(kPatience), SessionState::Finished);
    const auto whole = straight.session->capture();

    SessionBench first;
    first.limit({.passes = 4});
    first.session->post({scene, EditKind::Everything});
    ASSERT_EQ(first.session->wait(kPatience), SessionState::Finished);
    auto half = first.session->capture();
    ASSERT_TRUE(half.has_value());
    EXPECT_EQ(half->scene, scene);
    const double secondsBefore = half->renderSeconds;

    SessionBench second;
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
    SessionBench bench;
    bench.session->resume(fakeScene(8, 8), {.film = Film(9, 8), .renderSeconds = 1.0});
    EXPECT_EQ(bench.session->wait(kPatience), SessionState::Failed);
    EXPECT_NE(bench.session->status().error.find("9x8"), std::string::npos);
}

TEST(Session, AContinuousDragStillShowsImages) {
    SessionBench bench;
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
