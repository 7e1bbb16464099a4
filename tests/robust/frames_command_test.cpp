// `glint render --turntable` and `--flight`: numbered pictures of a camera that moves.
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "engine/scene/camera_path.h"
#include "tests/support/program_test.h"
#include "viewer/base/camera_bookmarks.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;
using test::TempFolder;

class FramesCommand : public test::ProgramTest {
  protected:
    void SetUp() override {
        ProgramTest::SetUp();
        setenv("XDG_STATE_HOME", folder.path("state").c_str(), 1);
        scene = folder.write("ball.json", R"({"glint": 1, "resolution": [32, 24],
            "camera": {"position": [0, 1, 4], "target": [0, 1, 0]},
            "materials": {"grey": {"type": "diffuse", "color": [0.8, 0.3, 0.1]}},
            "objects": [{"type": "sphere", "material": "grey", "center": [0.7, 1, 0], "radius": 0.5}],
            "environment": {"color": 0.3}})");
    }
    ProgramRun render(const std::vector<std::string>& more) const {
        std::vector<std::string> words{"render", scene, "-o", folder.path("f.png"), "--passes", "4"};
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words);
    }
    std::string frame(int number) const {
        return TempFolder::read(folder.path("f-00000" + std::to_string(number) + ".png"));
    }
    std::string scene;
};

TEST_F(FramesCommand, ATurntableTurnsOnceAroundTheTarget) {
    ASSERT_EQ(render({"--turntable", "4"}).exitCode, 0);
    for (int i = 1; i <= 4; ++i) {
        EXPECT_FALSE(frame(i).empty()) << i;
    }
    EXPECT_TRUE(frame(5).empty());
    EXPECT_FALSE(std::filesystem::exists(folder.path("f.png")));
    EXPECT_NE(frame(1), frame(3)) << "the ball is on the other side";
    const std::string first = frame(1), third = frame(3);
    ASSERT_EQ(render({}).exitCode, 0);
    EXPECT_EQ(TempFolder::read(folder.path("f.png")), first);
    ASSERT_EQ(render({"--camera-position", "0,1,-4"}).exitCode, 0);
    EXPECT_FALSE(TempFolder::read(folder.path("f.png")).empty());
    EXPECT_TRUE(
        says(render({"--turntable", "4", "--checkpoint", folder.path("a.glintfilm")}).err, "pictures alone"));
    EXPECT_EQ(render({"--turntable", "4", "--flight", "4"}).exitCode, 1);
}

TEST_F(FramesCommand, WhatStandsInTheWayIsSaid) {
    EXPECT_EQ(render({"--turntable", "4"}).err.find("warning"), std::string::npos);
    const std::string open = scene;
    const auto withWall = [&](const char* wall) {
        std::string text = TempFolder::read(open);
        text.insert(text.find("\"radius\": 0.5}") + 14, wall);
        scene = folder.write("room.json", text);
        return render({"--turntable", "8"}).err;
    };
    // Beside the ball, within the ring of 4 m and across it.
    EXPECT_TRUE(says(withWall(R"(, {"type": "rectangle", "name": "screen", "material": "grey",
        "center": [2, 1, 0], "edgeU": [0, 3, 0], "edgeV": [0, 0, 3]})"),
                     "screen hides the target in picture"));
    EXPECT_TRUE(says(withWall(R"(, {"type": "rectangle", "name": "wall", "material": "grey",
        "center": [3, 1, 0], "edgeU": [0, 4, 0], "edgeV": [0, 0, 10]})"),
                     "the camera goes through wall after picture 2"));
    const std::string small = withWall(R"(, {"type": "sphere", "name": "crumb", "material": "grey",
        "center": [1.5, 1, 0], "radius": 0.1})");
    EXPECT_EQ(small.find("crumb"), std::string::npos) << "what is looked at may have parts";
}

TEST_F(FramesCommand, AFlightGoesFromBookmarkToBookmark) {
    const ProgramRun none = render({"--flight", "3"});
    EXPECT_EQ(none.exitCode, 1);
    EXPECT_TRUE(says(none.err, "Bookmark this view"));
    CameraBookmarks bookmarks;
    bookmarks.begin(folder.path("state/glint/views"));
    Camera camera;
    camera.position = {0.0f, 1.0f, 4.0f};
    camera.target = {0.0f, 1.0f, 0.0f};
    camera.focalDistance = 4.0f;
    bookmarks.add(scene, camera);
    camera.position = {4.0f, 2.0f, 0.0f};
    bookmarks.add(scene, camera);
    ASSERT_EQ(render({"--flight", "3"}).exitCode, 0);
    EXPECT_NE(frame(1), frame(2));
    EXPECT_NE(frame(2), frame(3));
    ASSERT_EQ(render({}).exitCode, 0);
    EXPECT_EQ(TempFolder::read(folder.path("f.png")), frame(1))
        << "the first bookmark is the scene's own camera";
}

}  // namespace
}  // namespace glint
