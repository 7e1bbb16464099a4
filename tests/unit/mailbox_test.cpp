// How messages are joined, and which of them stop a pass in flight.
#include "engine/render/mailbox.h"

#include <thread>

#include <gtest/gtest.h>

namespace glint {
namespace {

SceneEdit edit(EditKind kinds) { return {std::make_shared<SceneDescription>(), kinds}; }

Mail takeNow(Mailbox& mailbox, Wishes* wishes) {
    return mailbox.take([](const Wishes&) { return true; }, wishes);
}

TEST(Mailbox, EditsThatWaitAreJoinedAndTheNewestSceneWins) {
    Mailbox mailbox;
    Wishes wishes;
    mailbox.post(edit(EditKind::Camera), std::nullopt);
    mailbox.post(edit(EditKind::Lights), std::nullopt);
    const SceneEdit newest = edit(EditKind::Camera | EditKind::ObjectTransform);
    mailbox.post(newest, std::nullopt);
    const Mail mail = takeNow(mailbox, &wishes);
    ASSERT_TRUE(mail.edit.has_value());
    EXPECT_EQ(mail.edit->scene, newest.scene);
    EXPECT_EQ(mail.edit->kinds, EditKind::Camera | EditKind::Lights | EditKind::ObjectTransform);
    EXPECT_FALSE(takeNow(mailbox, &wishes).edit.has_value());
}

TEST(Mailbox, FirstPostingTimeIsKept) {
    Mailbox mailbox;
    Wishes wishes;
    const auto before = SessionClock::now();
    mailbox.post(edit(EditKind::Camera), std::nullopt);
    const auto after = SessionClock::now();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    mailbox.post(edit(EditKind::Camera), std::nullopt);
    const Mail mail = takeNow(mailbox, &wishes);
    ASSERT_TRUE(mail.firstPosted.has_value());
    EXPECT_GE(*mail.firstPosted, before);
    EXPECT_LE(*mail.firstPosted, after);
}

TEST(Mailbox, AnEditStopsAPassAndTheNextPassStartsUnstopped) {
    Mailbox mailbox;
    Wishes wishes;
    mailbox.beginPass({});
    EXPECT_FALSE(mailbox.stopFlag());
    mailbox.post(edit(EditKind::Camera), std::nullopt);
    EXPECT_TRUE(mailbox.stopFlag());
    mailbox.endPass();
    (void)takeNow(mailbox, &wishes);
    mailbox.beginPass({});
    EXPECT_FALSE(mailbox.stopFlag());
}

TEST(Mailbox, AnEditBetweenTakeAndPassStopsThatPass) {
    Mailbox mailbox;
    Wishes wishes;
    (void)takeNow(mailbox, &wishes);
    mailbox.post(edit(EditKind::Camera), std::nullopt);
    mailbox.beginPass({});
    EXPECT_TRUE(mailbox.stopFlag());
}

TEST(Mailbox, APassThatMustBeShownIsStoppedByQuittingOnly) {
    Mailbox mailbox;
    mailbox.beginPass({.mustBeShown = true});
    mailbox.post(edit(EditKind::Camera), std::nullopt);
    mailbox.postRestart();
    EXPECT_FALSE(mailbox.stopFlag());
    mailbox.postQuit();
    EXPECT_TRUE(mailbox.stopFlag());
}

TEST(Mailbox, APreviewThatIsAlmostDoneIsLetThrough) {
    Mailbox mailbox;
    mailbox.beginPass({.previewSeconds = 0.005});
    mailbox.post(edit(EditKind::Camera), std::nullopt);
    EXPECT_FALSE(mailbox.stopFlag());
    mailbox.endPass();
    mailbox.beginPass({.previewSeconds = 5.0});
    EXPECT_TRUE(mailbox.stopFlag());
}

TEST(Mailbox, PausingStopsOnlyPassesThatAgree) {
    Mailbox mailbox;
    mailbox.beginPass({});
    mailbox.change([](Wishes& wishes) { wishes.paused = true; });
    EXPECT_FALSE(mailbox.stopFlag());
    mailbox.endPass();
    mailbox.beginPass({.mayWait = true});
    EXPECT_TRUE(mailbox.stopFlag());
}

TEST(Mailbox, LimitsAndCapturesStopNothing) {
    Mailbox mailbox;
    mailbox.beginPass({.mayWait = true});
    mailbox.change([](Wishes& wishes) { wishes.limits.passes = 3; });
    mailbox.postCapture({});
    EXPECT_FALSE(mailbox.stopFlag());
}

TEST(Mailbox, OnlyAnotherSceneOrTheEndMakesABuildFutile) {
    Mailbox mailbox;
    Wishes wishes;
    mailbox.post(edit(EditKind::MaterialKind), std::nullopt);
    EXPECT_FALSE(mailbox.abandonBuild());
    mailbox.post(edit(EditKind::Everything), std::nullopt);
    EXPECT_TRUE(mailbox.abandonBuild());
    (void)takeNow(mailbox, &wishes);
    EXPECT_FALSE(mailbox.abandonBuild());
    mailbox.postQuit();
    EXPECT_TRUE(mailbox.abandonBuild());
}

}  // namespace
}  // namespace glint
