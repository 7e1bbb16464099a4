// The whole viewer, headless through OSMesa, driven by scripts as a person would drive it: what restarts and
// what does not, errors that leave the running scene alone, pictures and checkpoints out and in.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;

TEST(ScriptedViewer, ApertureDragRestartsTheFilmOnceAndNothingElse) {
    const Ran ran = play(R"(
wait picture
mark
drag "Aperture" 40 0
wait picture
expect restarts 1
expect allocations 1  # undo goes back to the film before
expect material-tables 0
expect texture-tables 0
expect light-tables 0
expect feature-scans 0
expect mesh-builds 0
expect top-level-builds 0
expect "Aperture" 0
)");
    // The last expectation is there to fail: it shows that the drag arrived, and that a failing script is
    // an error.
    EXPECT_EQ(ran.exitCode, 1) << ran.output;
    EXPECT_THAT(ran.output, testing::HasSubstr("script.txt:14:19:")) << "the aperture changed";
}

TEST(ScriptedViewer, DisplayAndLimitsRestartNothing) {
    expectPlayed(play(R"(
wait picture
mark
set "Exposure" 1.5
set "Tone map" Filmic
set "Shown" Depth
set "Pass limit" 100000
set "Time limit" 5000
set "Size" "1:1 pixels"
drag "Splitter" -60 0
wait frames 5
expect restarts 0
expect allocations 0
expect "Exposure" 1.5
)"));
}

TEST(ScriptedViewer, TheWayToAPressTurnsNothing) {
    expectPlayed(play(R"(
wait picture
move 100 200
wait frames 2
mark
press 500 400
wait frames 2
move 501 400
wait frames 2
release
wait frames 3
expect restarts 0
press 100 200
wait frames 2
move 140 200
wait frames 2
release
wait picture
expect restarts 1
)"));
}

TEST(ScriptedViewer, EachEditRestartsItsPart) {
    expectPlayed(play(R"(
wait picture
open "Materials"
open "Lights"
open "Picture"
wait frames 2
mark
set "Colour" 0.2 0.3 0.4
wait picture
expect restarts 1
expect material-tables 1
expect light-tables 0
expect mesh-builds 0
mark
set "Env. strength" 2
wait picture
expect restarts 1
expect light-tables 1
expect material-tables 0
mark
set "Width" 80
wait picture
expect allocations 1
expect material-tables 0
mark
click "Restart"
wait picture
expect restarts 1
expect material-tables 0
expect light-tables 0
)"));
}

TEST(ScriptedViewer, EveryMaterialParameterIsLive) {
    expectPlayed(play(R"(
wait picture
open "Materials"
wait frames 2
mark
set "Materials/Kind" Conductor
wait picture
expect restarts 1
expect feature-scans 1
mark
set "Metal" copper
wait picture
expect restarts 1
expect material-tables 1
mark
set "Roughness" 0.4
wait picture
expect restarts 1
expect material-tables 1
set "Metal" "own constants"
wait picture
mark
set "Eta" 1 2 3
wait picture
expect restarts 1
set "Materials/Kind" Dielectric
wait picture
mark
set "Materials/IOR" 1.7
wait picture
expect restarts 1
mark
set "Thin" on
wait picture
expect restarts 1
set "Materials/Kind" Plastic
wait picture
mark
set "Materials/Emission" 1 2 3
wait picture
expect restarts 1
expect light-tables 1
expect mesh-builds 0
)"));
}

TEST(ScriptedViewer, AConstantEnvironmentTurnsWithoutARestart) {
    expectPlayed(play(R"(
wait picture
open "Lights"
wait frames 2
mark
set "Lights/Rotation" 45
wait frames 3
expect restarts 0
expect light-tables 0
set "Lights/Env. strength" 0.5
wait picture
expect restarts 1
expect light-tables 1
expect material-tables 0
expect mesh-builds 0
)"));
}

TEST(ScriptedViewer, TheMouseMovesTheCamera) {
    expectPlayed(play(R"(
wait picture
mark
drag 400 300 500 300
wait picture
expect restarts 1
expect mesh-builds 0
wheel 2 400 300
wait picture
key home
wait picture
expect "Camera/Position" 0 1 4
)"));
}

TEST(ScriptedViewer, APressIsADragOnlyAfterSomePixels) {
    expectPlayed(play(R"(
wait picture
mark
move 300 200
press
move 302 201
wait frames 3
release
wait frames 3
expect restarts 0
expect "Camera/Position" 0 1 4
)"));
}

TEST(ScriptedViewer, NumbersAreTypedAsPeopleWriteThem) {
    expectPlayed(play(R"(
wait picture
key ctrl down
click "f-stop"
key ctrl up
wait frames 3
text "2,8"
key enter
wait frames 3
expect "f-stop" 2.8
key ctrl down
click "f-stop"
key ctrl up
wait frames 3
text "f/4"
key enter
wait frames 3
expect "f-stop" 4
mark
key ctrl down
click "Focal distance"
key ctrl up
wait frames 3
text "1.2.3"
key enter
wait frames 3
expect "Focal distance" 4
screenshot "refused.png"
key ctrl down
click "Focal distance"
key ctrl up
wait frames 3
text "77"
key escape
wait frames 3
expect "Focal distance" 4
expect restarts 0
set "Exposure" 2.5
key ctrl down
click "Exposure"
key ctrl up
wait frames 3
text "abc"
key enter
wait frames 3
expect "Exposure" 2.5
set "Pass limit" 9876543
wait frames 2
expect "Pass limit" 9876543
key ctrl down
click "Pass limit"
key ctrl up
wait frames 3
text "2.5"
key enter
wait frames 3
expect "Pass limit" 9876543
key ctrl down
click "Exposure"
key ctrl up
wait frames 3
text "f 1,5"
key enter
wait frames 3
expect "Exposure" 1.5
key ctrl down
click "Position.x"
key ctrl up
wait frames 3
text "1,5"
key tab
wait frames 4
text "2"
key tab
wait frames 4
text "3.25"
key enter
wait frames 3
expect "Camera/Position" 1.5 2 3.25
)"));
}

}  // namespace
}  // namespace glint
