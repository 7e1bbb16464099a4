// How messages are joined, and which of them stop a pass in flight.
#include "engine/render/command_queue.h"

#include <thread>

#include <gtest/gtest.h>

namespace glint {
namespace {

SceneEdit edit(EditKind kinds) { return {std::make_shared<SceneDescription>(), kinds}; }

Commands takeNow(CommandQueue& commandQueue, RenderRequest* request) {
    return commandQueue.take([](const RenderRequest&) { return true; }, request);
}

TEST(CommandQueue, EditsThatWaitAreJoinedAndTheNewestSceneWins) {
    CommandQueue commandQueue;
    RenderRequest request;
    commandQueue.post(edit(EditKind::Camera), 0, std::nullopt);
    commandQueue.post(edit(EditKind::Lights), 0, std::nullopt);
    const SceneEdit newest = edit(EditKind::Camera | EditKind::ObjectTransform);
    commandQueue.post(newest, 0, std::nullopt);
    const Commands commands = takeNow(commandQueue, &request);
    ASSERT_TRUE(commands.edit.has_value());
    EXPECT_EQ(commands.edit->scene, newest.scene);
    EXPECT_EQ(commands.edit->kinds, EditKind::Camera | EditKind::Lights | EditKind::ObjectTransform);
    EXPECT_FALSE(takeNow(commandQueue, &request).edit.has_value());
}

TEST(CommandQueue, FirstPostingTimeIsKept) {
    CommandQueue commandQueue;
    RenderRequest request;
    const auto before = SessionClock::now();
    commandQueue.post(edit(EditKind::Camera), 0, std::nullopt);
    const auto after = SessionClock::now();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    commandQueue.post(edit(EditKind::Camera), 0, std::nullopt);
    const Commands commands = takeNow(commandQueue, &request);
    ASSERT_TRUE(commands.firstPosted.has_value());
    EXPECT_GE(*commands.firstPosted, before);
    EXPECT_LE(*commands.firstPosted, after);
}

TEST(CommandQueue, AnEditStopsAPassAndTheNextPassStartsUnstopped) {
    CommandQueue commandQueue;
    RenderRequest request;
    commandQueue.beginPass({});
    EXPECT_FALSE(commandQueue.stopFlag());
    commandQueue.post(edit(EditKind::Camera), 0, std::nullopt);
    EXPECT_TRUE(commandQueue.stopFlag());
    commandQueue.endPass();
    (void)takeNow(commandQueue, &request);
    commandQueue.beginPass({});
    EXPECT_FALSE(commandQueue.stopFlag());
}

TEST(CommandQueue, AnEditBetweenTakeAndPassStopsThatPass) {
    CommandQueue commandQueue;
    RenderRequest request;
    (void)takeNow(commandQueue, &request);
    commandQueue.post(edit(EditKind::Camera), 0, std::nullopt);
    commandQueue.beginPass({});
    EXPECT_TRUE(commandQueue.stopFlag());
}

TEST(CommandQueue, APassThatMustBeShownIsStoppedByQuittingOnly) {
    CommandQueue commandQueue;
    commandQueue.beginPass({.mustBeShown = true});
    commandQueue.post(edit(EditKind::Camera), 0, std::nullopt);
    commandQueue.postRestart();
    EXPECT_FALSE(commandQueue.stopFlag());
    commandQueue.postQuit();
    EXPECT_TRUE(commandQueue.stopFlag());
}

TEST(CommandQueue, APreviewThatIsAlmostDoneIsLetThrough) {
    CommandQueue commandQueue;
    commandQueue.beginPass({.previewSeconds = 0.005});
    commandQueue.post(edit(EditKind::Camera), 0, std::nullopt);
    EXPECT_FALSE(commandQueue.stopFlag());
    commandQueue.endPass();
    commandQueue.beginPass({.previewSeconds = 5.0});
    EXPECT_TRUE(commandQueue.stopFlag());
}

TEST(CommandQueue, PausingStopsOnlyPassesThatAgree) {
    CommandQueue commandQueue;
    commandQueue.beginPass({});
    commandQueue.request({.paused = true});
    EXPECT_FALSE(commandQueue.stopFlag());
    commandQueue.endPass();
    commandQueue.beginPass({.mayWait = true});
    EXPECT_TRUE(commandQueue.stopFlag());
}

TEST(CommandQueue, LimitsAndCapturesStopNothing) {
    CommandQueue commandQueue;
    commandQueue.beginPass({.mayWait = true});
    commandQueue.request({.limits = {.passes = 3}});
    commandQueue.postCapture({});
    EXPECT_FALSE(commandQueue.stopFlag());
}

TEST(CommandQueue, OnlyAnotherSceneOrTheEndMakesABuildFutile) {
    CommandQueue commandQueue;
    RenderRequest request;
    commandQueue.post(edit(EditKind::MaterialKind), 0, std::nullopt);
    EXPECT_FALSE(commandQueue.abandonBuild());
    commandQueue.post(edit(EditKind::Everything), 0, std::nullopt);
    EXPECT_TRUE(commandQueue.abandonBuild());
    (void)takeNow(commandQueue, &request);
    EXPECT_FALSE(commandQueue.abandonBuild());
    commandQueue.postQuit();
    EXPECT_TRUE(commandQueue.abandonBuild());
}

}  // namespace
}  // namespace glint
