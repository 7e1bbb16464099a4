// Zoom and pan of the picture by itself: where it is placed, and that clicks keep hitting the right pixel.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "tests/viewer/play_script.h"
#include "viewer/model/image_framing.h"

namespace glint {
namespace {

using namespace test;

constexpr ImageArea kArea{{0.0f, 0.0f}, {900.0f, 690.0f}, {640, 480}, 1.0f};

Vec2 shareAt(const PlacedImage& placed, Vec2 at) { return (at - placed.min) / (placed.max - placed.min); }

int indexOf(const std::string& choice) {
    const auto names = ImageFraming::choices();
    return static_cast<int>(std::ranges::find(names, choice) - names.begin());
}

TEST(ImageFraming, IsExactToThePixelWhereThereIsRoom) {
    for (const float pixelScale : {1.0f, 1.5f, 2.0f}) {
        for (const Vec2i image : {Vec2i(64, 48), Vec2i(431, 333), Vec2i(640, 480)}) {
            ImageArea area = kArea;
            area.image = image;
            area.pixelScale = pixelScale;
            const PlacedImage placed = ImageFraming().place(area);
            EXPECT_EQ(placed.zoom, std::floor(placed.zoom));
            EXPECT_GE(placed.zoom, 1.0f);
            for (const float edge : {placed.min.x, placed.min.y, placed.max.x, placed.max.y}) {
                const float pixel = edge * pixelScale;
                EXPECT_NEAR(pixel, std::round(pixel), 1e-3f) << image.x << " at " << pixelScale;
            }
            EXPECT_LE(placed.max.x, area.max.x);
            EXPECT_LE(placed.max.y, area.max.y);
        }
    }
    ImageArea large = kArea;
    large.image = {1800, 690};
    EXPECT_FLOAT_EQ(ImageFraming().place(large).zoom, 0.5f) << "all of a large picture is seen";
}

TEST(ImageFraming, WhatIsUnderTheMouseStaysThereUnlessAnEdgeIsInTheWay) {
    for (const float pixelScale : {1.0f, 2.0f}) {
        ImageArea area = kArea;
        area.pixelScale = pixelScale;
        ImageFraming framing;
        framing.choose(indexOf("4:1"));
        const Vec2 at(300.0f, 200.0f);
        const Vec2 share = shareAt(framing.place(area), at);
        for (const int steps : {1, 2, -1, 3}) {
            framing.zoomBy(steps, at, area);
            const PlacedImage placed = framing.place(area);
            const Vec2 pixels = (shareAt(placed, at) - share) * (placed.max - placed.min) * pixelScale;
            EXPECT_LT(std::abs(pixels.x) + std::abs(pixels.y), 4.0f) << "after " << steps;
        }
    }
}

TEST(ImageFraming, PansToItsEdgesAndBackWithoutDelay) {
    ImageFraming framing;
    framing.panBy({50.0f, 50.0f}, kArea);
    EXPECT_EQ(framing.place(kArea).min, ImageFraming().place(kArea).min) << "nothing is hidden";
    framing.choose(indexOf("2:1"));
    framing.panBy({100000.0f, 100000.0f}, kArea);
    EXPECT_EQ(framing.place(kArea).min, Vec2(0.0f));
    framing.panBy({-10.0f, -20.0f}, kArea);
    EXPECT_NEAR(framing.place(kArea).min.x, -10.0f, 1.0f);
    EXPECT_NEAR(framing.place(kArea).min.y, -20.0f, 1.0f);
    framing.chooseOneToOne();
    EXPECT_EQ(framing.place(kArea).min, Vec2(130.0f, 105.0f)) << "what has room is in the middle";
}

TEST(ImageFraming, StepsFromAnySizeToTheNextWholeZoom) {
    ImageArea area = kArea;
    area.image = {1000, 100};  // fits at 0.9
    ImageFraming framing;
    framing.zoomBy(1, {450.0f, 300.0f}, area);
    EXPECT_FLOAT_EQ(framing.place(area).zoom, 1.0f);
    framing.zoomBy(-1, {450.0f, 300.0f}, area);
    EXPECT_FLOAT_EQ(framing.place(area).zoom, 0.5f);
    framing.zoomBy(-100, {450.0f, 300.0f}, area);
    EXPECT_FLOAT_EQ(framing.place(area).zoom, imageZooms().front());
    framing.zoomBy(100, {450.0f, 300.0f}, area);
    EXPECT_FLOAT_EQ(framing.place(area).zoom, imageZooms().back());
}

// A picture of 64 x 48 in an area whose middle is in pixel 32, 24: that stays under the mouse at any zoom.
/// `larger`: the second zoom above the automatic one.
std::string zooms(const std::string& larger) {
    return R"(
wait picture
open "Inspector"
open "Display"
wait frames 3
mark
move "Image"
key ctrl down
wheel 2
key ctrl up
wait frames 3
expect "Size" )" +
           larger + R"(
expect "Pixel" "32, 24"
key t
wait picture
expect "Focal distance" 3.0005178
key 1
wait frames 3
expect "Size" "1:1 pixels"
expect "Pixel" "32, 24"
expect "Inspector/Object" "sphere 1"
key +
wait frames 3
expect "Size" "2:1"
key -
key -
wait frames 3
expect "Size" "1:2"
expect "Pixel" "32, 24"
key 0
wait frames 3
expect "Size" "Automatic"
expect restarts 0
)";
}

TEST(ZoomViewer, KeepsThePixelUnderTheMouse) { expectPlayed(play(zooms("24:1"), "--passes 2")); }

TEST(ZoomViewer, KeepsThePixelUnderTheMouseOnADenseScreen) {
    expectPlayed(play(zooms("32:1"), "--passes 2 --size 2560x1440 --scale 2"));
}

TEST(ZoomViewer, DragsMoveThePictureAndNotTheCamera) {
    // 64 screen pixels at 32:1 are two pixels of the picture.
    const Ran ran = play(R"(
wait picture
open "Inspector"
wait frames 3
set "Size" "32:1"
wait frames 3
mark
move 420 340
wait frames 3
print "Pixel"
key ctrl down
drag 420 340 484 372 right
key ctrl up
move 420 340
wait frames 3
print "Pixel"
expect restarts 0
drag 420 340 484 372 right
wait picture
expect restarts 1
)",
                         "--passes 2");
    expectPlayed(ran);
    const auto pixels = printed(ran, "Inspector/Pixel");
    ASSERT_EQ(pixels.size(), 2u) << ran.output;
    int x[2];
    int y[2];
    for (size_t i : {0u, 1u}) {
        ASSERT_EQ(std::sscanf(pixels[i].c_str(), "%d, %d", &x[i], &y[i]), 2) << pixels[i];
    }
    EXPECT_EQ(x[0] - x[1], 2) << ran.output;
    EXPECT_EQ(y[0] - y[1], 1) << ran.output;
}

TEST(ZoomViewer, BothSidesOfAComparisonAreZoomedAndTheDividerStaysInSight) {
    const Ran ran = play(R"(
wait picture
key c
wait picture
set "Size" "32:1"
wait frames 3
print widgets
)",
                         "--passes 2");
    expectPlayed(ran);
    // Left, top, width, height: both sides reach to the divider in the middle of what is seen.
    EXPECT_THAT(ran.output, testing::ContainsRegex("\"Left side\" 0 0 45[0-9] ")) << ran.output;
    EXPECT_THAT(ran.output, testing::ContainsRegex("\"Right side\" 45[0-9] 0 45[0-9] ")) << ran.output;
}

/// `part` lies somewhere in `whole`, byte for byte.
bool contains(const Image8& whole, const Image8& part) {
    const auto row = [](const Image8& image, int x, int y) {
        return image.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * image.width + x);
    };
    const auto isAt = [&](int left, int top) {
        for (int y = 0; y < part.height; ++y) {
            const auto begin = row(part, 0, y);
            if (!std::equal(begin, begin + 3 * part.width, row(whole, left, top + y))) { return false; }
        }
        return true;
    };
    for (int top = 0; top + part.height <= whole.height; ++top) {
        for (int left = 0; left + part.width <= whole.width; ++left) {
            if (isAt(left, top)) { return true; }
        }
    }
    return false;
}

TEST(ZoomViewer, OneToOneShowsThePicturesOwnBytes) {
    for (const std::string more : {"", " --size 1920x1440 --scale 1.5"}) {
        expectPlayed(play(R"(
wait finished
key 1
wait picture
wait frames 4
screenshot zoom_1.png
)",
                          "--passes 1 --output zoom_picture.png" + more));
        const auto screen = loadImage8("zoom_1.png");
        const auto image = loadImage8("zoom_picture.png");
        ASSERT_TRUE(screen && image);
        EXPECT_TRUE(contains(**screen, **image)) << more;
    }
}

}  // namespace
}  // namespace glint
