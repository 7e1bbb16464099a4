// Panels by the keyboard alone, by scripts.
#include <gtest/gtest.h>

#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;

/// Keys one after the other, a few frames apart.
std::string keys(const std::vector<std::string>& names) {
    std::string script;
    for (const std::string& name : names) {
        script += "key " + name + "\nwait frames 3\n";
    }
    return script;
}

/// Closes what is open at first, so that few keys lead far.
const std::string kClosed = R"(
wait passes 1
close "Scene"
close "Render"
close "Convergence"
close "Camera"
close "Lens"
close "Display"
wait frames 2
)";

TEST(KeyboardWalk, NumbersAndChoicesAreMadeWithoutTheMouse) {
    expectPlayed(play(kClosed +
                      keys({"f6", "down", "down", "down", "down", "space", "down", "down", "enter"}) +
                      R"(
text "50 mm"
key enter
wait picture
expect "Lens/Focal length" 50
)" + keys({"up", "space", "down", "enter"}) +
                      R"(
wait picture
expect "Lens/Sensor" "APS-C, 23.6 × 15.7 mm"
expect state rendering
)" + keys({"up", "space"}) +
                      "expect \"Lens\" closed\nexpect state rendering\n"));
}

TEST(KeyboardWalk, ANumberIsMovedByArrowsAsOneStepOfTheHistory) {
    expectPlayed(play(kClosed + "open \"Camera\"\nopen \"History\"\nwait frames 2\n" +
                      keys({"f6", "down", "down", "down", "down", "space"}) + R"(
expect "Camera/Position.x" 0
key right down
wait frames 20
key right up
wait frames 3
)" + keys({"space"}) + R"(
wait picture
expect widget "2. Camera: position and 1 more"
expect no-widget "3. Camera: position and 1 more"
key ctrl down
key z
key ctrl up
wait picture
expect "Camera/Position.x" 0
)"));
}

TEST(KeyboardWalk, EscGivesTheKeysBackToThePicture) {
    expectPlayed(play(kClosed + keys({"f6", "space"}) + "expect \"Scene\" open\nexpect state rendering\n" +
                      keys({"escape", "space"}) + "wait paused\nexpect \"Scene\" open\n" + keys({"space"}) +
                      "expect state rendering\n"));
}

TEST(KeyboardWalk, HiddenPanelsComeAlongAndQuestionsHaveTheKeyboard) {
    write("here.png", "somebody's");
    expectPlayed(play(kClosed + R"(
key tab
wait frames 3
expect no-widget "Scene"
key f6
wait frames 3
expect widget "Scene"
open "Checkpoint"
wait frames 3
set "PNG file" here.png
click "Save PNG"
wait frames 4
expect "Question" "Replace here.png?"
)" + keys({"right", "space"}) +
                      "expect no-widget \"Question\"\nexpect state rendering\n"));
}

}  // namespace
}  // namespace glint
