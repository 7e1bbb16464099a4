// Objects that are added, copied, hidden, removed and moved with handles, and materials from the library,
// by script.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;
using testing::HasSubstr;

const std::string kSelected = R"(
wait picture
move "Image"
press
release
wait frames 3
click "Go to Object"
wait frames 4
)";

TEST(ObjectsViewer, HandlesMoveTheObjectAndNotTheCamera) {
    const Ran ran = play(kSelected + R"(
key g
wait frames 3
expect "Object/Gizmo" Move
screenshot gizmo_move.png
mark
print "Object/Position.x"
drag "Gizmo X" 70 0
wait picture
print "Object/Position.x"
print "Object/Position.y"
expect restarts 1
key ctrl down
key z
key ctrl up
wait picture
print "Object/Position.x"
key g
wait frames 3
expect "Object/Gizmo" Rotate
screenshot gizmo_rotate.png
drag "Gizmo Z" 0 -60
wait picture
print "Object/Turned.z"
key g
wait frames 3
drag "Gizmo Y" 0 -40
wait picture
print "Object/Size.y"
)");
    expectPlayed(ran);
    const auto x = printed(ran, "Object/Position.x");
    ASSERT_EQ(x.size(), 3u) << ran.output;
    EXPECT_EQ(std::stof(x[0]), 0.0f);
    EXPECT_GT(std::stof(x[1]), 0.1f);
    EXPECT_EQ(x[2], x[0]) << "one step of the history";
    EXPECT_EQ(std::stof(printed(ran, "Object/Position.y")[0]), 1.0f);
    EXPECT_GT(std::abs(std::stof(printed(ran, "Object/Turned.z")[0])), 5.0f);
    EXPECT_GT(std::stof(printed(ran, "Object/Size.y")[0]), 1.1f);
}

TEST(ObjectsViewer, AHandleThatIsLetGoBesideTheObjectKeepsTheSelection) {
    const Ran ran = play(kSelected + R"(
set "Object/Gizmo" Scale
wait frames 3
drag "Gizmo middle" -300 -200
wait picture
print "Object/Size"
expect widget "Object/Delete"
)");
    expectPlayed(ran);
    ASSERT_EQ(printed(ran, "Object/Size").size(), 1u) << ran.output;
}

TEST(ObjectsViewer, ThingsAreAddedCopiedHiddenAndRemoved) {
    expectPlayed(play(kSelected + R"(
open "Outliner"
open "History"
wait frames 3
set "Object/New" Box
wait picture
expect widget "Object 2: box"
expect "Object 2: box" selected
set "Object/Position" 1 1 0
wait picture
key ctrl down
key d
key ctrl up
wait picture
expect widget "Object 3: box copy"
key ctrl down
key d
key ctrl up
wait picture
expect widget "Object 4: box copy 2"
key delete
wait picture
click "Object 3: box copy"
wait frames 3
key delete
wait picture
expect no-widget "Object 3: box copy"
click "Object 1: sphere 1"
wait frames 3
key h
wait picture
expect widget "Object 1: box"
expect no-widget "Object 2: box"
expect widget "Show all"
click "Show all"
wait picture
expect widget "Object 2: sphere 1"
expect no-widget "Show all"
set "Object/New" Light
wait picture
expect widget "2. Add box"
key ctrl down
key z
key z
key ctrl up
wait picture
screenshot objects.png
)"));
}

TEST(ObjectsViewer, MeshFilesAreAdded) {
    write("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    const Ran ran = play(kSelected + R"(
open "Outliner"
wait frames 3
set "Object/New" "Mesh file…"
wait frames 3
click "square.obj"
wait jobs
wait picture
expect message "Added 1 object of square.obj"
print widgets
)");
    expectPlayed(ran);
    EXPECT_THAT(ran.output, HasSubstr("\"Outliner/Object 2"));
}

TEST(ObjectsViewer, TheLibraryMakesMaterials) {
    expectPlayed(play(R"(
wait picture
click "Go to Library"
open "Materials"
wait frames 4
click "gold"
wait picture
expect "Materials/Kind" Conductor
expect "Materials/Metal" gold
expect widget "Materials/grey"
screenshot library.png
click "Copy"
set "Library/Group" Paints
wait frames 3
click "Navy"
wait picture
expect "Materials/Kind" Diffuse
click "Paste"
wait picture
expect "Materials/Metal" gold
)"));
}

TEST(ObjectsViewer, HandlesMoveAndTurnLights) {
    std::string scene(kScene);
    scene.insert(scene.rfind('}'), R"(, "lights": [
        {"type": "point", "name": "lamp", "position": [1.2, 1.6, 0], "intensity": 5},
        {"type": "spot", "name": "spot", "position": [-1.2, 1.6, 0], "direction": [0, -2, 0],
         "intensity": 5},
        {"type": "directional", "name": "sun", "direction": [0, -1, 0], "irradiance": 1}])");
    write("lights.json", scene);
    write("script.txt", R"(
wait picture
open "Lights"
wait frames 2
expect no-widget "Light mark 1"
key g
wait frames 3
expect "Lights/Gizmo" Move
print "Lights/Position.x"
mark
drag "Gizmo X" 70 0
wait picture
print "Lights/Position.x"
print "Lights/Position.y"
expect restarts 1
key ctrl down
key z
key ctrl up
wait picture
print "Lights/Position.x"
click "Light mark 2"
wait frames 3
expect "Light" spot
screenshot lights_move.png
key g
wait frames 3
screenshot lights_turn.png
drag "Gizmo Z" 0 -60
wait picture
print "Lights/Direction.x"
print "Lights/Direction.y"
print "Lights/Position.x"
set "Light" sun
wait frames 3
expect no-widget "Gizmo middle"
drag "Gizmo Z" 0 -60
wait picture
print "Lights/Direction.x"
)");
    const Ran ran = run("view lights.json --headless --threads 1 --script script.txt");
    expectPlayed(ran);
    const auto x = printed(ran, "Lights/Position.x");
    ASSERT_EQ(x.size(), 4u) << ran.output;
    EXPECT_GT(std::stof(x[1]), std::stof(x[0]) + 0.1f);
    EXPECT_EQ(printed(ran, "Lights/Position.y").at(0), "1.6");
    EXPECT_EQ(x[2], x[0]);
    EXPECT_EQ(std::stof(x[3]), -1.2f) << "a turn leaves it where it is";
    const auto turnedX = printed(ran, "Lights/Direction.x");
    ASSERT_EQ(turnedX.size(), 2u);
    const float spotX = std::stof(turnedX[0]), spotY = std::stof(printed(ran, "Lights/Direction.y").at(0));
    EXPECT_GT(std::fabs(spotX), 0.2f);
    EXPECT_NEAR(std::hypot(spotX, spotY), 2.0f, 1e-3f) << "its length stays";
    EXPECT_GT(std::fabs(std::stof(turnedX[1])), 0.1f);
}

}  // namespace
}  // namespace glint
