// What a session does with edits, and with what fails, with a fake backend.
#include <gtest/gtest.h>

#include "engine/builders/scene_builder.h"
#include "tests/support/session_bench.h"

namespace glint {
namespace {

using namespace test;

TEST(Session, AnEditThatNoImageShowsRestartsNothing) {
    SessionBench bench;
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
    SessionBench bench;
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
    SessionBench bench;
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

TEST(Session, ANewSceneAbandonsTheBuildOfTheOneBefore) {
    SessionBench bench;
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
    SessionBench bench;
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
    SessionBench bench;
    bench.limit({.passes = 2});
    bench.control->buildsFailing = 1;
    bench.open(8, 8);
    EXPECT_EQ(bench.session->wait(kPatience), SessionState::Failed);
    EXPECT_FALSE(bench.session->capture().has_value());
    bench.session->post({fakeScene(8, 8), EditKind::Camera});
    EXPECT_EQ(bench.session->wait(kPatience), SessionState::Finished);
}

TEST(Session, BackendErrorsAndExceptionsFailWithAMessageAndARestartTriesAgain) {
    SessionBench bench;
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
    SessionBench bench;
    bench.open(8, 8);
    ASSERT_TRUE(
        bench.waitFor([&] { return bench.session->status().passes > 0 && bench.session->snapshot(); }));
    bench.control->failPasses = true;
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Failed);
    EXPECT_NE(bench.session->snapshot(), nullptr);
    EXPECT_TRUE(bench.session->capture().has_value());
}

}  // namespace
}  // namespace glint
