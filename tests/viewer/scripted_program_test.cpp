// What the window does as a program, by scripts: panels, files, errors, pauses, images without a display.
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;

TEST(ScriptedProgram, EveryPanelOpens) {
    expectPlayed(play(R"(
wait picture
open "Materials"
open "Lights"
open "Picture"
open "Checkpoint"
open "Log"
wait frames 3
expect widget "Scene/Open"
expect widget "Render/Pause"
expect widget "Lens/Aperture"
expect widget "Materials/Kind"
expect widget "Lights/Rotation"
expect widget "Display/Exposure"
expect widget "Picture/Max depth"
expect widget "Checkpoint/Save PNG"
expect widget "Log/Copy log"
set "Materials/Kind" Conductor
wait frames 2
expect widget "Metal"
close "Materials"
wait frames 2
expect no-widget "Metal"
key f1
wait frames 3
screenshot "panels.png"
)"));
    const auto image = loadImage8("panels.png");
    ASSERT_TRUE(image) << image.error().format();
    EXPECT_EQ((*image)->width, 1280);
    EXPECT_EQ((*image)->height, 720);
    // The column of panels holds text: far from one grey.
    size_t bright = 0;
    for (int y = 0; y < 700; ++y) {
        for (int x = 920; x < 1260; ++x) {
            bright += (*image)->rgb[static_cast<size_t>(y * 1280 + x) * 3] > 180;
        }
    }
    EXPECT_GT(bright, 1000u);
}

TEST(ScriptedProgram, ABadSceneLeavesTheRunningOneAlone) {
    write("bad.json", "{ \"glint\": 1,\n  \"camera\": {\"positoin\": [0, 0, 1]}\n}\n");
    expectPlayed(play(R"(
wait picture
mark
set "File" bad.json
click "Open"
wait jobs
expect error "bad.json:2:"
expect error "position"
expect widget "Scene/Dismiss"
expect restarts 0
expect mesh-builds 0
click "Dismiss"
wait frames 2
expect no-error
expect no-widget "Scene/Dismiss"
)"));
}

TEST(ScriptedProgram, ARefusedEditIsSaidUntilItIsUndone) {
    const Ran ran = play(R"(
wait picture
key ctrl down
click "Camera/Position.x"
key ctrl up
text "1e39"
key enter
wait frames 4
expect "Camera/Position.x" 0
expect no-widget "Status message"
set "Camera/Target" 0 1 4
wait seconds 0.3
wait frames 3
print "Status message"
key home
wait picture
wait frames 3
expect no-widget "Status message"
)");
    expectPlayed(ran);
    EXPECT_THAT(ran.output,
                testing::HasSubstr("\"Status message\" camera: position and target are the same point"));
}

TEST(ScriptedProgram, PausesAndGoesOn) {
    expectPlayed(play(R"(
wait picture
click "Pause"
wait paused
mark
click "Start"
wait passes 3
expect restarts 0
)"));
}

TEST(ScriptedProgram, ACheckpointIsSavedAndResumed) {
    expectPlayed(play(R"(
wait finished
open "Checkpoint"
wait frames 2
set "Checkpoint file" six.glintfilm
click "Save"
wait jobs
expect message "/six.glintfilm (6 passes"
click "Restart"
wait finished
set "Pass limit" 8
click "Resume"
wait jobs
expect message "Resumed six.glintfilm at 6 passes"
wait finished
expect passes-at-least 8
set "Field of view" 30
wait picture
click "Resume"
wait jobs
expect message "with the scene it is of"
wait picture
expect "Field of view" 40
)",
                      "--passes 6"));
}

TEST(ScriptedProgram, ThePngIsTheImageOnTheScreen) {
    expectPlayed(play(R"(
set "Exposure" 0.7
set "Tone map" Reinhard
wait finished
open "Checkpoint"
wait frames 2
set "PNG file" saved.png
click "Save PNG"
wait jobs
expect message "/saved.png (4 passes"
)",
                      "--passes 4"));
    // `glint render` goes through the processor's tone map.
    const Ran render =
        run("render scene.json -o rendered.png --passes 4 --threads 1 --exposure 0.7 --tone reinhard");
    ASSERT_EQ(render.exitCode, 0) << render.output;
    const auto saved = loadImage8("saved.png");
    const auto rendered = loadImage8("rendered.png");
    ASSERT_TRUE(saved && rendered);
    EXPECT_EQ((*saved)->rgb, (*rendered)->rgb);
}

TEST(ScriptedProgram, ScriptErrorsHaveTheirPlace) {
    Ran ran = play("wait picture\nset \"Apertur\" 3\n");
    EXPECT_EQ(ran.exitCode, 1);
    EXPECT_THAT(ran.output, testing::HasSubstr("script.txt:2:5:"));
    EXPECT_THAT(ran.output, testing::HasSubstr("Aperture"));
    ran = play("wait picture\nset \"Aperture\" wide\n");
    EXPECT_EQ(ran.exitCode, 1);
    EXPECT_THAT(ran.output, testing::HasSubstr("expected a number"));
    ran = play("wiat picture\n");
    EXPECT_EQ(ran.exitCode, 1);
    EXPECT_THAT(ran.output, testing::HasSubstr("script.txt:1:1:"));
}

TEST(ScriptedProgram, ScriptsAreTextAsOtherSystemsWriteIt) {
    expectPlayed(play("\xEF\xBB\xBFwait picture\r\nquit\r\n"));
    std::string utf16 = "\xFF\xFE";
    for (const char c : std::string("wait picture\nquit\n")) {
        utf16 += {c, '\0'};
    }
    expectPlayed(play(utf16));
    const Ran ran = play(std::string("wait picture\nset \"Aper\0ture\" 3\n", 33));
    EXPECT_EQ(ran.exitCode, 1);
    EXPECT_THAT(ran.output, testing::HasSubstr("script.txt:2:10: a byte is 0"));
}

TEST(ScriptedProgram, WhatIsWaitedForAfterTheEndIsAnError) {
    const Ran ran = play("wait finished\nwait passes 3\n", "--passes 2");
    EXPECT_EQ(ran.exitCode, 1);
    EXPECT_THAT(ran.output, testing::HasSubstr("script.txt:2:1: the render has finished, with 2 passes"));
    expectPlayed(play("wait finished\nset \"Pass limit\" 4\nwait passes 4\n", "--passes 2"));
}

TEST(ScriptedProgram, NoScreenshotReplacesAnotherOutput) {
    std::ofstream("shots.txt") << "wait picture\nscreenshot \"both.png\"\n";
    const Ran ran = run("view scene.json --headless --script shots.txt --screenshot both.png");
    EXPECT_EQ(ran.exitCode, 1);
    EXPECT_THAT(ran.output, testing::HasSubstr("shots.txt:2:12: two outputs go to one file"));
    std::ofstream("own.txt") << "wait picture\nscreenshot \"own.txt\"\n";
    EXPECT_THAT(run("view scene.json --headless --script own.txt").output,
                testing::HasSubstr("is the script"));
}

TEST(ScriptedProgram, ADragTakesALabelWithoutQuotesToo) {
    const Ran ran = play("wait picture\ndrag Exposure 30 0\nwait picture\nprint \"Exposure\"\n");
    expectPlayed(ran);
    EXPECT_THAT(ran.output, testing::HasSubstr("Exposure\" "));
    EXPECT_THAT(ran.output, testing::Not(testing::HasSubstr("Exposure\" 0\n"))) << "it was dragged";
}

TEST(ScriptedProgram, WhatIsSetIsReadBackAtOnce) {
    expectPlayed(play(R"(
wait picture
set "Shown" Albedo
expect "Shown" Albedo
set "Exposure" 2
expect "Exposure" 2
open "Checkpoint"
expect "Checkpoint" open
)"));
}

TEST(ScriptedProgram, HeadlessWithoutAScriptLeavesImages) {
    write("scene.json", kScene);
    const Ran ran = run(
        "view scene.json --headless --threads 1 --size 900x500 --scale 2 --passes 2 --screenshot window.png "
        "--output picture.png");
    ASSERT_EQ(ran.exitCode, 0) << ran.output;
    const auto window = loadImage8("window.png");
    const auto image = loadImage8("picture.png");
    ASSERT_TRUE(window && image);
    EXPECT_EQ((*window)->width, 900);
    EXPECT_EQ((*image)->width, 64);
}

TEST(ScriptedProgram, WithoutADisplayItSaysWhatToDo) {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    write("scene.json", kScene);
    const Ran ran = run("view scene.json");
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.output, testing::HasSubstr("--headless"));
}

}  // namespace
}  // namespace glint
