// What the mouse drags, by keys: the gizmo, the divider of two pictures, the column of panels.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;

const std::string kSelected = R"(
wait picture
move "Image"
press
release
wait frames 3
click "Go to Object"
wait frames 4
)";

std::string tapped(const std::string& key) { return "key " + key + "\nwait frames 3\n"; }

std::vector<float> numbers(const Ran& ran, const std::string& label) {
    std::vector<float> out;
    for (const std::string& text : printed(ran, label)) {
        out.push_back(std::stof(text));
    }
    return out;
}

TEST(KeysInsteadOfMouse, ArrowsMoveTurnAndStretchTheSelection) {
    const Ran ran = play(kSelected + tapped("right") + R"(print "Object/Position.x"
key g
wait frames 3
expect "Object/Gizmo" Move
click "Object/Snap"
wait frames 3
)" + tapped("right") + tapped("right") +
                         tapped("left") + tapped("down") + tapped("pageup") + R"(wait picture
print "Object/Position.x"
expect "Object/Position.y" 0.9
expect "Object/Position.z" 0.1
key g
wait frames 3
)" + tapped("pageup") + R"(wait picture
expect "Object/Turned.z" 15
key g
wait frames 3
)" + tapped(".") + R"(wait picture
print "Object/Size.x"
print "Object/Size.y"
)" + tapped("up") + R"(wait picture
print "Object/Size.x"
print "Object/Size.y"
)");
    expectPlayed(ran);
    const auto x = numbers(ran, "Object/Position.x");
    ASSERT_EQ(x.size(), 2u) << ran.output;
    EXPECT_EQ(x[0], 0.0f) << "without handles, keys move nothing";
    EXPECT_NEAR(x[1], 0.1f, 1e-4f);
    const auto width = numbers(ran, "Object/Size.x"), height = numbers(ran, "Object/Size.y");
    ASSERT_EQ(width.size(), 2u) << ran.output;
    EXPECT_NEAR(width[0], height[0], 1e-4f);
    EXPECT_NEAR(width[1], width[0], 1e-4f);
    EXPECT_NEAR(height[1] / height[0], 1.1f, 1e-3f);
}

TEST(KeysInsteadOfMouse, AKeyThatIsHeldIsOneStepOfTheHistory) {
    const Ran ran = play(kSelected + R"(
key g
wait frames 3
key right down
wait frames 60
key right up
wait picture
print "Object/Position.x"
key ctrl down
key z
key ctrl up
wait picture
print "Object/Position.x"
key shift down
key right
key shift up
wait picture
print "Object/Position.x"
)");
    expectPlayed(ran);
    const auto x = numbers(ran, "Object/Position.x");
    ASSERT_EQ(x.size(), 3u) << ran.output;
    EXPECT_GT(x[0], 0.1f);
    EXPECT_EQ(x[1], 0.0f);
    EXPECT_GT(x[2], 0.0f);
    EXPECT_LT(x[2], 0.2f * x[0]) << "fine";
}

TEST(KeysInsteadOfMouse, ASelectedLightMoves) {
    const Ran ran = play(R"(
wait picture
click "Go to Object"
wait frames 3
set "Object/New" Light
wait picture
click "Go to Lights"
wait frames 4
print "Lights/Position.x"
key g
wait frames 3
)" + tapped("right") + "wait picture\nprint \"Lights/Position.x\"\n");
    expectPlayed(ran);
    const auto x = numbers(ran, "Lights/Position.x");
    ASSERT_EQ(x.size(), 2u) << ran.output;
    EXPECT_GT(x[1], x[0]);
}

/// Alt and an arrow move the column's edge: the arrow still means that when Alt is let go first.
TEST(KeysInsteadOfMouse, AnArrowThatWasPressedWithAltMovesNothing) {
    const Ran ran = play(kSelected + R"(key g
wait frames 3
print "Object/Position.x"
key alt down
key left down
wait frames 3
key alt up
wait seconds 1
wait frames 3
key left up
wait picture
print "Object/Position.x"
key left down
wait seconds 1
key left up
wait picture
print "Object/Position.x"
)");
    expectPlayed(ran);
    const auto x = numbers(ran, "Object/Position.x");
    ASSERT_EQ(x.size(), 3u) << ran.output;
    EXPECT_EQ(x[1], x[0]);
    EXPECT_LT(x[2], x[1]);
}

TEST(KeysInsteadOfMouse, TheDividerAndTheColumnMove) {
    const Ran ran = play(R"(
wait picture
print "Splitter"
key alt down
key left
wait frames 3
key left
wait frames 3
key alt up
print "Splitter"
key alt down
key shift down
key right
key shift up
key alt up
wait frames 3
print "Splitter"
key f6
wait frames 3
key alt down
key right
key alt up
wait frames 3
print "Splitter"
key escape
key c
wait frames 4
print "Divider"
key ctrl down
key left
wait frames 3
key ctrl up
print "Divider"
key ctrl down
key shift down
key right
key shift up
key ctrl up
wait frames 3
print "Divider"
expect state rendering
)");
    expectPlayed(ran);
    const auto column = numbers(ran, "Splitter"), divider = numbers(ran, "Divider");
    ASSERT_EQ(column.size(), 4u) << ran.output;
    EXPECT_EQ(column[1], column[0] + 40.0f);
    EXPECT_EQ(column[2], column[0] + 38.0f);
    EXPECT_EQ(column[3], column[0] + 18.0f) << "also while widgets are marked";
    ASSERT_EQ(divider.size(), 3u) << ran.output;
    EXPECT_EQ(divider[0], 0.5f);
    EXPECT_EQ(divider[1], 0.48f);
    EXPECT_EQ(divider[2], 0.482f);
}

}  // namespace
}  // namespace glint
