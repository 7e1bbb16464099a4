// The colour picker, by script: what is brighter than a screen stays, and Esc gives back what was there.
#include <array>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;

/// Opens the picker of the environment's radiance, which is `radiance` then.
std::string withPicker(const std::string& radiance) {
    return "wait picture\nopen \"Lights\"\nwait frames 2\nset \"Radiance\" " + radiance +
           "\nwait picture\nclick \"Radiance patch\"\nwait frames 3\n";
}

std::array<float, 3> colorOf(const std::string& text) {
    std::array<float, 3> rgb{};
    EXPECT_EQ(std::sscanf(text.c_str(), "%f %f %f", &rgb[0], &rgb[1], &rgb[2]), 3) << text;
    return rgb;
}

TEST(ColorPicker, KeepsRadianceAboveOne) {
    const Ran ran = play(withPicker("20 10 0") + R"(
expect "Radiance strength" 20
expect "Radiance hex" "#ffbc00"
screenshot picker.png
set "Radiance hex" "#00ff00"
wait picture
print "Lights/Radiance"
set "Radiance strength" 5
wait picture
print "Lights/Radiance"
)");
    expectPlayed(ran);
    const auto colors = printed(ran, "Lights/Radiance");
    ASSERT_EQ(colors.size(), 2u) << ran.output;
    EXPECT_EQ(colorOf(colors[0]), (std::array{0.0f, 20.0f, 0.0f})) << "the strength stays with another shade";
    EXPECT_EQ(colorOf(colors[1]), (std::array{0.0f, 5.0f, 0.0f})) << "the shade stays with another strength";
}

TEST(ColorPicker, ItsFieldOfShadesKeepsTheStrengthToo) {
    // A drag to the field's left edge takes the saturation away: grey, as bright as before.
    const Ran ran = play(withPicker("20 10 0") + R"(
print widgets
print "Radiance hex"
)");
    expectPlayed(ran);
    // The field begins above the row of the hexadecimal number.
    const size_t at = ran.output.find("\"Lights/Radiance hex\" ");
    ASSERT_NE(at, std::string::npos) << ran.output;
    float left = 0.0f;
    float top = 0.0f;
    ASSERT_EQ(std::sscanf(ran.output.c_str() + at, "\"Lights/Radiance hex\" %f %f", &left, &top), 2);
    const std::string x = std::to_string(left - 40.0f);
    const std::string drag = "drag " + x + " " + std::to_string(top - 150.0f) + " " +
                             std::to_string(left - 400.0f) + " " + std::to_string(top - 400.0f) + "\n";
    const Ran dragged = play(withPicker("20 10 0") + drag +
                             "wait picture\nprint \"Lights/Radiance\"\nexpect \"Radiance strength\" 20\n");
    expectPlayed(dragged);
    const auto colors = printed(dragged, "Lights/Radiance");
    ASSERT_EQ(colors.size(), 1u) << dragged.output;
    const auto rgb = colorOf(colors[0]);
    EXPECT_FLOAT_EQ(rgb[0], 20.0f);
    EXPECT_NEAR(rgb[1], 20.0f, 1e-3f);
    EXPECT_NEAR(rgb[2], 20.0f, 1e-3f);
}

TEST(ColorPicker, EscGivesBackWhatWasThere) {
    const Ran ran = play(withPicker("20 10 0") + R"(
set "Radiance hex" "#0000ff"
wait picture
set "Radiance strength" 3
wait picture
key escape
wait picture
expect no-widget "Radiance hex"
print "Lights/Radiance"
)");
    expectPlayed(ran);
    const auto colors = printed(ran, "Lights/Radiance");
    ASSERT_EQ(colors.size(), 1u) << ran.output;
    EXPECT_EQ(colorOf(colors[0]), (std::array{20.0f, 10.0f, 0.0f}));
}

TEST(ColorPicker, PicksAColourOfThePicture) {
    // The corner of the picture shows the environment, whose radiance is 1; the material's colour is 0.5.
    expectPlayed(play(R"(
wait picture
open "Materials"
wait frames 2
click "Colour patch"
wait frames 3
click "Pick from the picture"
wait frames 3
expect no-widget "Colour hex"
click 30 40
wait frames 3
expect "Materials/Colour" "1 1 1"
set "Colour" 0.25 0.25 0.25
wait picture
click "Colour patch"
wait frames 3
click "Pick from the picture"
wait frames 3
key escape
click 30 40
wait frames 3
expect "Materials/Colour" "0.25 0.25 0.25"
)"));
}

TEST(ColorPicker, WhatAScreenCanShowIsMixedWithoutStrength) {
    expectPlayed(play(R"(
wait picture
open "Materials"
wait frames 2
click "Colour patch"
wait frames 3
expect "Colour strength" 1
expect "Colour hex" "#bcbcbc"
set "Colour hex" "#ff0000"
wait picture
expect "Materials/Colour" "1 0 0"
set "Colour hex" "no colour"
wait frames 3
expect "Materials/Colour" "1 0 0"
)"));
}

}  // namespace
}  // namespace glint
