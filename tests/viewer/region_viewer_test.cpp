// A region in the window, by script: only what is drawn is rendered on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "tests/viewer/play_script.h"
#include "viewer/model/region_tool.h"

namespace glint {
namespace {

using namespace test;

// A ball that is noisy all over, under a lamp that its rays seldom meet.
constexpr const char* kNoisy = R"({
  "glint": 1,
  "resolution": [64, 48],
  "camera": { "position": [0, 1, 4], "target": [0, 1, 0] },
  "materials": {
    "grey": { "type": "diffuse", "color": 0.5 },
    "lamp": { "type": "diffuse", "color": 0, "emission": 40 }
  },
  "objects": [
    { "type": "sphere", "material": "grey", "center": [0, 1, 0], "radius": 30 },
    { "type": "sphere", "material": "lamp", "center": [1, 4, 2], "radius": 0.5 }
  ]
})";

Ran playNoisy(const std::string& script) {
    write("noisy.json", kNoisy);
    write("script.txt", script);
    return run("view noisy.json --headless --threads 1 --no-auto-exposure --passes 2 --script script.txt");
}

TEST(RegionTool, CornersMayBeDrawnInAnyOrder) {
    EXPECT_EQ(regionBetween({5, 9}, {2, 10}), (FilmRegion{2, 9, 6, 11}));
    RegionTool tool;
    tool.askOrGiveUp();
    EXPECT_TRUE(tool.picks);
    tool.picks = false;
    tool.drawn = FilmRegion{1, 2, 3, 4};
    tool.spot = spotAround({50, 20}, 96);
    EXPECT_TRUE(tool.wanted()->contains(50, 20));
    EXPECT_EQ(tool.wanted()->pixels(), 256);
    tool.spot.reset();
    EXPECT_EQ(tool.wanted(), tool.drawn);
    tool.askOrGiveUp();
    EXPECT_FALSE(tool.wanted());
    EXPECT_FALSE(tool.picks);
}

/// Where a script's window of the usual size shows the middle of a pixel of the noisy scene.
size_t placeOf(int x, int y) {
    return 3 * (static_cast<size_t>(12 + 14 * y + 7) * 1280 + static_cast<size_t>(3 + 14 * x + 7));
}

TEST(ScriptedWaits, ForPassesEndWithTheirPictureOnScreen) {
    expectPlayed(playNoisy(R"(wait passes 2
screenshot waited.png
wait finished
wait picture
wait frames 4
screenshot settled.png
)"));
    const auto waited = loadImage8("waited.png"), settled = loadImage8("settled.png");
    ASSERT_TRUE(waited && settled);
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            const uint8_t *a = &(*waited)->rgb[placeOf(x, y)], *b = &(*settled)->rgb[placeOf(x, y)];
            ASSERT_TRUE(std::equal(a, a + 3, b)) << x << ", " << y;
        }
    }
}

/// The render ends where the wait does, after longer than a script may wait for what does not come.
TEST(ScriptedWaits, ForPassesMayTakeLong) {
    std::string large = kNoisy;
    large.replace(large.find("[64, 48]"), 8, "[1024, 768]");
    write("large.json", large);
    write("script.txt", "wait passes 5\nexpect no-error\n");
    expectPlayed(run("view large.json --headless --threads 1 --passes 5 --script script.txt"));
}

TEST(RegionViewer, OnlyWhatIsDrawnIsRenderedOn) {
    // 14 screen pixels a picture pixel, from (3, 12) on.
    const Ran ran = playNoisy(R"(
wait finished
wait picture
move "Splitter"
wait frames 4
screenshot region_before.png
mark
key b
wait frames 3
expect widget "Drag on the picture…"
drag 150 159 444 453
wait frames 3
expect "Region" "10 10 32 32"
expect restarts 0
set "Pass limit" 200
wait finished
wait picture
print "Est. error"
key b
wait picture
move "Splitter"
wait frames 4
screenshot region_after.png
expect no-widget "Region"
set "Pass limit" 210
wait finished
wait frames 4
print "Est. error"
)");
    expectPlayed(ran);
    const auto before = loadImage8("region_before.png");
    const auto after = loadImage8("region_after.png");
    ASSERT_TRUE(before && after);
    int changedInside = 0;
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            const size_t at = placeOf(x, y);
            const bool isSame = std::equal(&(*before)->rgb[at], &(*before)->rgb[at] + 3, &(*after)->rgb[at]);
            const bool isInside = FilmRegion{10, 10, 32, 32}.contains(x, y);
            if (!isInside) { ASSERT_TRUE(isSame) << x << ", " << y; }
            changedInside += isInside && !isSame ? 1 : 0;
        }
    }
    EXPECT_GT(changedInside, 150) << "of 484, of which many are clipped to white";
    const auto errors = printed(ran, "Render/Est. error");
    ASSERT_EQ(errors.size(), 2u) << ran.output;
    EXPECT_THAT(errors[0], testing::HasSubstr("(region)"));
    EXPECT_THAT(errors[1], testing::Not(testing::HasSubstr("(region)")));
    EXPECT_GT(std::stof(errors[1]), 2.0f * std::stof(errors[0])) << "the rest has two passes and ten";
}

TEST(RegionViewer, ThisSpotFirstIsAroundTheMouseWhileItsKeyIsHeld) {
    expectPlayed(playNoisy(R"(
wait finished
move "Image"
key v down
wait frames 3
expect "Region" "24 16 40 32"
key v up
wait frames 3
expect no-widget "Region"
)"));
}

TEST(RegionViewer, PhotonsHaveNone) {
    const Ran ran = playNoisy(R"(
wait finished
set "Integrator" SPPM
wait finished
key b
wait frames 2
drag 150 159 444 453
wait frames 3
print "Est. error"
screenshot region_sppm.png
)");
    expectPlayed(ran);
    EXPECT_THAT(printed(ran, "Render/Est. error")[0], testing::Not(testing::HasSubstr("(region)")));
}

}  // namespace
}  // namespace glint
