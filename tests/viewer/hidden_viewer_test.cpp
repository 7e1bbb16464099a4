// Hidden objects in the outliner, and back in the picture, by scripts.
#include <filesystem>

#include <gtest/gtest.h>

#include "engine/io/atomic_file.h"
#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;
namespace fs = std::filesystem;

TEST(HiddenViewer, WhatIsHiddenIsSavedAndListed) {
    fs::remove("hiding.json");
    expectPlayed(play(R"w(
wait picture
open "Checkpoint"
move "Image"
press
release
wait frames 3
key h
wait picture
set "Scene file" hiding.json
click "Save scene"
wait jobs
expect message "Saved "
)w"));
    write("script.txt", R"w(
wait picture
open "Object"
click "Go to Outliner"
wait frames 4
move "Image"
press
release
wait frames 3
expect no-widget "Object/Duplicate"
set "Search" hidden
wait frames 3
click "Hidden 1: sphere 1"
wait picture
expect no-widget "Hidden 1: sphere 1"
expect "Object/Name" "sphere 1"
move "Image"
press
release
wait frames 3
expect widget "Object/Duplicate"
)w");
    expectPlayed(run("view hiding.json --headless --threads 1 --script script.txt"));
}

TEST(HiddenViewer, AHiddenMeshIsReadWhenItIsShown) {
    write("ball.obj", "v -1 0 1\nv 1 0 1\nv 0 2 1\nf 1 2 3\n");
    std::string scene(kScene);
    scene.insert(scene.find("\"radius\": 1 }") + 13,
                 R"(, {"type": "mesh", "name": "there", "hidden": true, "material": "grey",
                 "mesh": {"file": "ball.obj"}}, {"type": "mesh", "name": "gone", "hidden": true,
                 "material": "grey", "mesh": {"file": "gone.obj"}})");
    write("hidden.json", scene);
    write("script.txt", R"w(
wait picture
open "Object"
click "Go to Outliner"
wait frames 4
click "Hidden 1: there"
wait jobs
wait picture
expect widget "Object 2: there"
click "Show all"
wait jobs
wait frames 5
expect message "gone.obj"
click "Go to Outliner"
wait frames 4
expect widget "Hidden 1: gone"
expect no-widget "Object 3: gone"
)w");
    expectPlayed(run("view hidden.json --headless --threads 1 --script script.txt"));
}

TEST(HiddenViewer, ANameIsAnEditThatIsSavedAndUndone) {
    fs::remove("renamed.json");
    expectPlayed(play(R"w(
wait finished
close "Render"
close "Camera"
close "Lens"
open "Object"
open "History"
move "Image"
press
release
wait frames 3
mark
set "Object/Name" "my ball"
wait frames 4
expect widget "2. Rename"
open "Checkpoint"
wait frames 2
set "Scene file" renamed.json
click "Save scene"
wait jobs
expect restarts 0
key ctrl down
key z
key ctrl up
wait frames 4
expect "Object/Name" "sphere 1"
)w",
                      "--passes 2"));
    EXPECT_NE(readFile("renamed.json")->find("\"my ball\""), std::string::npos);
}

}  // namespace
}  // namespace glint
