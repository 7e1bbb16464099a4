// Numbered pictures from the window, by scripts.
#include <filesystem>

#include <gtest/gtest.h>

#include "engine/io/atomic_file.h"
#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;
namespace fs = std::filesystem;

std::string imageOf(const std::string& folder, int number) {
    return *readFile(folder + "/frame-00000" + std::to_string(number) + ".png");
}

class FramesViewer : public ::testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all("window");
        fs::remove_all("command");
        fs::create_directories("command");
    }
};

TEST_F(FramesViewer, TheyAreThoseOfTheCommandAndTheLivePictureGoesOn) {
    std::string scene(kScene);
    scene.replace(scene.find("[0, 1, 0], \"radius\""), 9, "[0.7, 1, 0]");
    write("ball.json", scene);
    write("script.txt", R"(
wait passes 3
open "Turntable"
wait frames 2
set "Pictures" 3
set "Passes each" 4
set "Folder" window
wait frames 2
expect no-widget "Obstacles"
mark
click "Render the pictures"
wait frames 4
wait jobs
expect message "3 pictures in window"
expect restarts 0
wait finished
expect passes-at-least 24
click "Render the pictures"
wait frames 4
wait jobs
expect message "3 pictures in window"
)");
    expectPlayed(run("view ball.json --headless --threads 1 --script script.txt --passes 24"));
    const Ran command = run("render ball.json -o command/frame.png --threads 1 --passes 4 --turntable 3");
    ASSERT_EQ(command.exitCode, 0) << command.output;
    for (int i = 1; i <= 3; ++i) {
        EXPECT_TRUE(imageOf("window", i) == imageOf("command", i)) << i;
    }
    EXPECT_FALSE(imageOf("window", 1) == imageOf("window", 2));
}

TEST_F(FramesViewer, TheyCanBeCancelled) {
    expectPlayed(play(R"(
wait finished
open "Turntable"
wait frames 2
set "Way" "Through the bookmarks"
wait frames 2
expect no-widget "Render the pictures"
set "Way" "Round the target"
set "Pictures" 5000
set "Folder" window
wait frames 2
click "Render the pictures"
wait frames 10
expect widget "Turntable/Picture"
set "Field of view" 20
wait frames 3
click "Turntable/Cancel"
wait frames 2
wait jobs
expect message "cancelled"
wait finished
expect passes-at-least 12
)",
                      "--passes 12"));
    EXPECT_FALSE(fs::exists("window/frame-005000.png"));
}

TEST_F(FramesViewer, FilesOfOthersAreAskedFor) {
    fs::create_directories("window");
    write("window/frame-000002.png", "mine");
    expectPlayed(play(R"(
wait finished
open "Turntable"
wait frames 2
set "Pictures" 2
set "Passes each" 1
set "Folder" window
wait frames 2
click "Render the pictures"
wait frames 3
click "Keep the old file"
wait frames 3
wait jobs
)",
                      "--passes 2"));
    EXPECT_EQ(imageOf("window", 2), "mine");
    EXPECT_FALSE(fs::exists("window/frame-000001.png"));
}

TEST_F(FramesViewer, OneQuestionIsForAllFilesOfOthers) {
    fs::create_directories("window");
    for (const char* name : {"1", "3", "4", "9"}) {
        write("window/frame-00000" + std::string(name) + ".png", "mine");
    }
    expectPlayed(play(R"(
wait finished
open "Turntable"
wait frames 2
set "Pictures" 4
set "Passes each" 1
set "Folder" window
wait frames 2
click "Render the pictures"
wait frames 3
expect "Question" "Replace frame-000001.png and 2 more?"
key escape
wait frames 3
expect no-widget "Question"
click "Render the pictures"
wait frames 3
click "Replace"
wait frames 4
expect no-widget "Question"
wait jobs
expect message "4 pictures in window"
click "Render the pictures"
wait frames 4
expect no-widget "Question"
wait jobs
)",
                      "--passes 2"));
    EXPECT_NE(imageOf("window", 3), "mine");
    EXPECT_EQ(imageOf("window", 9), "mine");
}

TEST_F(FramesViewer, WallsInTheWayAreSaid) {
    std::string scene(kScene);
    scene.insert(scene.find("\"radius\": 1 }") + 13,
                 R"(, {"type": "rectangle", "name": "wall", "material": "grey",
                 "center": [3, 1, 0], "edgeU": [0, 4, 0], "edgeV": [0, 0, 10]})");
    write("room.json", scene);
    write("script.txt", R"(
wait finished
open "Turntable"
wait frames 3
expect "Obstacles" "the camera goes through wall after picture 5, and wall hides the target in picture 6"
)");
    expectPlayed(run("view room.json --headless --threads 1 --script script.txt --passes 2"));
}

TEST_F(FramesViewer, ACameraBeyondAllNumbersEndsNothing) {
    expectPlayed(play(R"(
wait picture
open "Turntable"
wait frames 3
set "Camera/Position.y" 3.4e38
wait frames 3
set "Camera/Target" 3e38 -3e38 3e38
wait frames 3
key ctrl down
key z
wait frames 2
key z
key ctrl up
wait picture
expect "Camera/Position.y" 1
)"));
}

}  // namespace
}  // namespace glint
