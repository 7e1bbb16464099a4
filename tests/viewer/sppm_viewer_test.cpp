// SPPM in the window, by script: what an edit of it restarts, both integrators' pictures kept, the split view
// and the overlays.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;
using Color = std::array<int, 3>;

Color pixelOf(const Image8& image, int x, int y) {
    const size_t at =
        (static_cast<size_t>(y) * static_cast<size_t>(image.width) + static_cast<size_t>(x)) * 3;
    return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

/// How far from grey: the whole scene is grey, false colours are not.
int tint(const Color& c) { return std::max({c[0], c[1], c[2]}) - std::min({c[0], c[1], c[2]}); }

TEST(SppmViewer, ItsSettingsRestartItsStatisticsOnly) {
    expectPlayed(play(R"(
wait finished
set "Integrator" SPPM
wait finished
mark
set "SPPM/Radius" 6
wait picture
expect restarts 1
set "Alpha" 0.8
wait picture
set "Photons" 5000
wait picture
set "Direct light" "By photons"
wait picture
set "Look-up" Kd-tree
wait picture
set "Radius from" Absolute
wait picture
set "SPPM/Radius" 80
wait finished
expect restarts 7
expect allocations 7  # the films before are held
expect material-tables 0
expect light-tables 0
expect mesh-builds 0
mark
set "Integrator" "Path tracing"
wait picture
expect passes-at-least 5
expect restarts 0
)",
                      "--passes 5"));
}

TEST(SppmViewer, SwitchingKeepsBothImages) {
    const Ran ran = play(R"(
wait finished
set "Integrator" SPPM
wait finished
mark
set "Integrator" "Path tracing"
wait picture
expect passes-at-least 4
print status
set "Integrator" SPPM
wait picture
expect passes-at-least 4
print status
expect restarts 0
expect allocations 0
expect mesh-builds 0
)",
                         "--passes 4");
    expectPlayed(ran);
    EXPECT_THAT(ran.output, testing::HasSubstr("integrator=path passes=4"));
    EXPECT_THAT(ran.output, testing::HasSubstr("integrator=sppm passes=4"));
}

TEST(SppmViewer, ACameraMoveRestartsWhatIsShownAndTheOtherWhenItIs) {
    expectPlayed(play(R"(
wait finished
set "Integrator" SPPM
wait finished
mark
drag 400 300 460 300
wait finished
expect restarts 1
set "Integrator" "Path tracing"
wait finished
expect restarts 2
expect mesh-builds 0
)",
                      "--passes 3"));
}

TEST(SppmViewer, TheDividerDragsAndMovesNothingElse) {
    const Ran ran = play(R"(
wait picture
set "Compare" on
wait picture
mark
screenshot "middle.png"
drag "Divider" 200 0
wait frames 2
print "Divider"
screenshot "right.png"
expect restarts 0
expect "Camera/Position" 0 1 4
set "Compare" off
wait frames 3
expect no-widget "Divider"
)");
    expectPlayed(ran);
    const size_t at = ran.output.find("\"Divider\" ");
    ASSERT_NE(at, std::string::npos) << ran.output;
    // The picture fills the area: 902 pixels beside the panels.
    EXPECT_NEAR(std::atof(ran.output.c_str() + at + 10), 0.5 + 200.0 / 902.0, 0.005) << ran.output;
    const auto middle = loadImage8("middle.png");
    const auto right = loadImage8("right.png");
    ASSERT_TRUE(middle && right);
    EXPECT_EQ(pixelOf(**middle, 451, 200), (Color{235, 235, 235})) << "the divider's line";
    EXPECT_NE(pixelOf(**right, 451, 200), (Color{235, 235, 235}));
    EXPECT_EQ(pixelOf(**right, 651, 200), (Color{235, 235, 235}));
}

TEST(SppmViewer, OverlaysShowRadiiPhotonsAndVisiblePoints) {
    expectPlayed(play(R"(
set "Integrator" SPPM
wait frames 2
set "Direct light" "By photons"
wait finished
screenshot "radiance.png"
set "Shown" "SPPM radius"
wait picture
wait frames 2
screenshot "radius.png"
set "Shown" "Photon count"
wait picture
wait frames 2
screenshot "photons.png"
set "Shown" "Visible points"
wait picture
wait frames 2
screenshot "points.png"
set "Integrator" "Path tracing"
wait finished
wait frames 2
screenshot "path.png"
)",
                      "--passes 4"));
    constexpr int kSphereX = 451, kSphereY = 348, kSkyX = 40, kSkyY = 40;
    const auto at = [](const char* file, int x, int y) {
        const auto image = loadImage8(file);
        return image ? pixelOf(**image, x, y) : Color{-1, -1, -1};
    };
    EXPECT_LE(tint(at("radiance.png", kSphereX, kSphereY)), 12);
    EXPECT_GE(tint(at("radius.png", kSphereX, kSphereY)), 30);
    EXPECT_GE(tint(at("photons.png", kSphereX, kSphereY)), 30);
    EXPECT_EQ(at("radius.png", kSkyX, kSkyY), (Color{0, 0, 0})) << "the sky holds no visible point";
    EXPECT_EQ(at("points.png", kSphereX, kSphereY), (Color{184, 204, 184}));
    EXPECT_EQ(at("points.png", kSkyX, kSkyY), (Color{56, 23, 51}));
    EXPECT_LE(tint(at("path.png", kSphereX, kSphereY)), 12) << "path tracing shows its radiance instead";
}

TEST(SppmViewer, PhotonsThatDoNotFitTheMemoryAreReducedAndItSaysSo) {
    expectPlayed(play(R"(
set "Integrator" SPPM
wait picture
set "Memory limit" 1
wait picture
wait frames 2
expect "Memory limit" 1
expect widget "Reduced to"
set "Memory limit" 1024
wait picture
wait frames 2
expect no-widget "Reduced to"
)"));
}

}  // namespace
}  // namespace glint
