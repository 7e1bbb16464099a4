// Pictures that are kept and compared, by script, and what the differences hold.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "tests/viewer/play_script.h"
#include "viewer/model/shown_difference.h"
#include "viewer/model/snapshots.h"

namespace glint {
namespace {

using namespace test;
using testing::HasSubstr;

std::shared_ptr<FilmSnapshot> image(int width, std::vector<float> radiance) {
    auto made = std::make_shared<FilmSnapshot>();
    made->width = width;
    made->height = static_cast<int>(radiance.size()) / 3 / width;
    made->passes = 3;
    made->radiance = std::move(radiance);
    return made;
}

TEST(ShownDifference, SignedIsOrangeWhereTheLeftOneIsBrighter) {
    const auto left = image(3, {1, 1, 1, 0, 0, 0, 0.5f, 0.5f, 0.5f});
    const auto right = image(3, {0, 0, 0, 1, 1, 1, 0.5f, 0.5f, 0.5f});
    const auto made = makeDifference({CompareView::SignedDifference, left, right, 0.0f});
    ASSERT_EQ(made.rgba.size(), 12u);
    EXPECT_TRUE(made.scale.isSigned);
    EXPECT_FLOAT_EQ(made.scale.heat.largest, 1.0f);
    EXPECT_GT(made.rgba[0], made.rgba[2]) << "orange";
    EXPECT_LT(made.rgba[4], made.rgba[6]) << "blue";
    EXPECT_EQ(made.rgba[8], 0) << "black";
    EXPECT_NEAR(made.mean, 0.0, 1e-7);
}

TEST(ShownDifference, FlipIsNothingForEqualPictures) {
    const auto left = image(8, std::vector<float>(8 * 8 * 3, 0.3f));
    const auto right = image(8, std::vector<float>(8 * 8 * 3, 0.6f));
    EXPECT_EQ(makeDifference({CompareView::FlipMap, left, left, 0.0f}).mean, 0.0);
    EXPECT_GT(makeDifference({CompareView::FlipMap, left, right, 0.0f}).mean, 0.05);
    const auto other = image(4, std::vector<float>(4 * 4 * 3, 0.3f));
    EXPECT_TRUE(makeDifference({CompareView::FlipMap, left, other, 0.0f}).rgba.empty());
}

TEST(Snapshots, PreviewsAreNotKept) {
    Snapshots snapshots;
    auto preview = image(2, std::vector<float>(12, 1.0f));
    preview->previewScale = 4;
    EXPECT_FALSE(snapshots.keep(preview, nullptr, {}));
    EXPECT_FALSE(snapshots.keep(nullptr, nullptr, {}));
    ASSERT_TRUE(snapshots.keep(image(2, std::vector<float>(12, 1.0f)), nullptr, {}));
    EXPECT_THAT(snapshots.kept()[0].summary, HasSubstr("3 passes"));
    EXPECT_EQ(snapshots.kept()[0].thumbnail.rgba[0], 255);
    snapshots.left = 1;
    snapshots.remove(1);
    EXPECT_FALSE(snapshots.isComparing());
}

const std::string kKeepAndEdit = R"(
wait finished
key k
wait frames 3
open "Materials"
wait frames 2
set "Colour" 0.1 0.1 0.1
wait finished
wait picture
close "Materials"
open "Snapshots"
wait frames 3
expect "Snapshots/Snapshot 1" ""
click "Snapshots/Snapshot 1"
wait frames 4
expect "Snapshots/Snapshot 1" selected
)";

TEST(CompareViewer, AKeptPictureIsComparedWithTheLiveOne) {
    const Ran ran = play(kKeepAndEdit + R"(
move "Splitter"
wait frames 4
print "Left side"
print "Right side"
screenshot compare_wipe.png
set "Snapshots/Compared by" "Signed difference"
wait frames 3
wait picture
wait frames 3
print "Difference"
screenshot compare_signed.png
set "Snapshots/Compared by" "FLIP map"
wait frames 3
wait picture
wait frames 3
print "Difference"
screenshot compare_flip.png
)",
                         "--passes 4");
    expectPlayed(ran);
    EXPECT_THAT(printed(ran, "Left side")[0], HasSubstr("Snapshot 1"));
    EXPECT_THAT(printed(ran, "Left side")[0], HasSubstr("4 passes"));
    EXPECT_THAT(printed(ran, "Right side")[0], HasSubstr("Path tracing"));
    const auto wipe = loadImage8("compare_wipe.png");
    ASSERT_TRUE(wipe);
    // The ball's middle is left and right of the divider: bright as it was, dark as it is.
    const auto red = [&](int x) { return (*wipe)->rgb[3 * (346u * 1280u + static_cast<size_t>(x))]; };
    EXPECT_GT(red(430), 2 * red(470));
    const auto differences = printed(ran, "Difference");
    ASSERT_EQ(differences.size(), 2u) << ran.output;
    EXPECT_THAT(differences[0], HasSubstr("Left − right"));
    EXPECT_THAT(differences[1], HasSubstr("FLIP"));
    const auto map = loadImage8("compare_signed.png");
    ASSERT_TRUE(map);
    const size_t middle = 3 * (346u * 1280u + 450u);
    EXPECT_GT((*map)->rgb[middle], (*map)->rgb[middle + 2]) << "orange: the kept one is brighter";
}

TEST(CompareViewer, MapsSideBySideHaveAScale) {
    const Ran ran = play(R"(
set "Shown" "Standard error"
wait finished
wait picture
)" + kKeepAndEdit + R"(
set "Snapshots/Compared by" "Side by side"
wait frames 3
expect widget "Scale"
set "Shown" "Radiance"
wait picture
wait frames 3
expect no-widget "Scale"
)",
                         "--passes 4");
    expectPlayed(ran);
}

TEST(CompareViewer, FlippingAndSideBySideShowBoth) {
    const Ran ran = play(kKeepAndEdit + R"(
set "Snapshots/Compared by" "Flip"
wait frames 3
print "Left side"
expect no-widget "Right side"
move "Splitter"
key x
wait frames 3
print "Right side"
expect no-widget "Left side"
key n
open "Inspector"
wait frames 3
expect "Snapshots/Compared by" "Side by side"
move "Image" 0.25 0.5
wait frames 3
print "Inspector/Pixel"
print "Status line"
move "Image" 0.75 0.5
wait frames 3
print "Inspector/Pixel"
print "Status line"
screenshot compare_both.png
)",
                         "--passes 4");
    expectPlayed(ran);
    EXPECT_THAT(printed(ran, "Left side")[0], HasSubstr("Snapshot 1"));
    EXPECT_THAT(printed(ran, "Right side")[0], HasSubstr("Path tracing"));
    const auto pixels = printed(ran, "Inspector/Pixel");
    ASSERT_EQ(pixels.size(), 2u) << ran.output;
    EXPECT_EQ(pixels[0], pixels[1]) << "the same place of both";
    const auto lines = printed(ran, "Status line");
    EXPECT_NE(lines[0], lines[1]) << "each side's own values";
}

TEST(CompareViewer, ItsSceneComesBack) {
    expectPlayed(play(kKeepAndEdit + R"(
click "Its scene"
wait picture
open "Materials"
wait frames 3
expect "Materials/Colour" "0.5 0.5 0.5"
click "Snapshots/Remove"
wait frames 3
expect no-widget "Snapshots/Snapshot 1"
expect no-widget "Divider"
)",
                      "--passes 4"));
}

TEST(CompareViewer, PathTracingLessPhotons) {
    const Ran ran = play(R"(
wait finished
key c
wait picture
set "Display/Compared by" "Signed difference"
wait frames 3
wait picture
wait frames 3
print "Difference"
print "Scale"
)",
                         "--passes 4");
    expectPlayed(ran);
    ASSERT_EQ(printed(ran, "Difference").size(), 1u) << ran.output;
    EXPECT_THAT(printed(ran, "Difference")[0], HasSubstr("mean"));
    EXPECT_THAT(printed(ran, "Scale")[0], HasSubstr("-"));
}

}  // namespace
}  // namespace glint
