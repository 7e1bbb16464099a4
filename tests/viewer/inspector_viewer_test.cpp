// One pixel in numbers, the histogram, and the outliner: parts and scripts.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/viewer/play_script.h"
#include "viewer/model/area_statistics.h"
#include "viewer/model/histogram.h"
#include "viewer/model/outliner.h"
#include "viewer/model/waveform.h"

namespace glint {
namespace {

using namespace test;
using testing::HasSubstr;

TEST(Histogram, CountsWhatIsShown) {
    FilmSnapshot snapshot;
    snapshot.width = 4;
    snapshot.height = 1;
    // Black, white, a red that is cut, and half of white, linear.
    snapshot.radiance = {0, 0, 0, 1, 1, 1, 9, 0, 0, 0.5f, 0.5f, 0.5f};
    const Histogram histogram = histogramOf(snapshot, {0.0f, ToneMap::Clamp});
    EXPECT_FLOAT_EQ(histogram.black, 0.25f);
    EXPECT_FLOAT_EQ(histogram.white, 0.5f);
    EXPECT_FLOAT_EQ(histogram.bins[0].front(), 0.25f);
    EXPECT_FLOAT_EQ(histogram.bins[1].front(), 0.5f);
    EXPECT_FLOAT_EQ(histogram.bins[0].back(), 0.5f);
    EXPECT_FLOAT_EQ(histogram.bins[2][32], 0.25f);
    // A stop more cuts the grey too.
    EXPECT_FLOAT_EQ(histogramOf(snapshot, {1.0f, ToneMap::Clamp}).white, 0.75f);
    FilmSnapshot large;
    large.radiance.assign(size_t{3} << 20, 0.2f);
    EXPECT_NEAR(histogramOf(large, {0.0f, ToneMap::Clamp}).bins[0][12], 1.0f, 1e-3f)
        << "all pixels have a share";
}

TEST(Waveform, FollowsThePictureFromLeftToRight) {
    FilmSnapshot snapshot;
    snapshot.width = 600;
    snapshot.height = 300;
    for (int y = 0; y < snapshot.height; ++y) {
        for (int x = 0; x < snapshot.width; ++x) {
            const float ramp = (static_cast<float>(x) + 0.5f) / 600.0f;
            snapshot.radiance.insert(snapshot.radiance.end(), {ramp, y < 100 ? 1.0f : 0.0f, 0.5f});
        }
    }
    const DisplayLook look{0.0f, ToneMap::Clamp};
    const Waveform parade = waveformOf(snapshot, look, WaveformKind::Parade);
    ASSERT_EQ(parade.panes, 3u);
    const auto level = [](float share) { return static_cast<size_t>(share * Waveform::kLevels); };
    for (size_t column = 0; column < parade.columnsPerPane; ++column) {
        const float middle = (static_cast<float>(column) + 0.5f) / static_cast<float>(parade.columnsPerPane);
        float near = 0.0f;
        for (size_t i = level(middle) - (level(middle) > 0); i <= std::min(level(middle) + 1, size_t{63});
             ++i) {
            near += parade.share(0, column, i);
        }
        EXPECT_FLOAT_EQ(near, 1.0f) << column;
        EXPECT_NEAR(parade.share(1, column, 63), 1.0f / 3.0f, 0.02f);
        EXPECT_NEAR(parade.share(1, column, 0), 2.0f / 3.0f, 0.02f);
        EXPECT_FLOAT_EQ(parade.share(2, column, 32), 1.0f);
    }
    const Waveform luma = waveformOf(snapshot, {1.0f, ToneMap::Clamp}, WaveformKind::Luminance);
    ASSERT_EQ(luma.panes, 1u);
    // With a stop more blue is white: 0.0722, green adds 0.7152, and red runs from 0 to 0.2126.
    EXPECT_NEAR(luma.share(0, 0, level(0.0722f)), 2.0f / 3.0f, 0.02f);
    EXPECT_NEAR(luma.share(0, luma.columnsPerPane - 1, 63), 1.0f / 3.0f, 0.02f);
    EXPECT_EQ(waveformOf(FilmSnapshot{}, look, WaveformKind::Parade).columnsPerPane, 0u);
}

TEST(InspectorViewer, HasAWaveformOfWhatIsShown) {
    expectPlayed(play(R"w(
wait finished
open "Inspector"
set "Tone map" "Clamp (linear)"
wait frames 3
expect widget "Histogram"
set "Scope" Waveform
wait frames 3
expect no-widget "Histogram"
expect "Reaches" "49–100 %"
set "Scope" Parade
set "Exposure" -1
wait frames 3
expect "Reaches" "25–50 %, 25–50 %, 25–50 %"
)w",
                      "--passes 64"));
}

TEST(AreaStatistics, OfTheAreaAloneAndInPreviewsToo) {
    FilmSnapshot snapshot;
    snapshot.width = 3;
    snapshot.height = 2;
    snapshot.radiance = {9, 9, 9, 1, 2, 3, 3, 2, 1, 9, 9, 9, 5, 2, 2, std::nanf(""), 0, 0};
    const AreaStatistics few = statisticsOf(snapshot, {1, 0, 3, 2});
    EXPECT_EQ(few.pixels, 3u) << "one is not a number";
    EXPECT_EQ(few.mean, Vec3(3.0f, 2.0f, 2.0f));
    EXPECT_EQ(few.deviation, Vec3(2.0f, 0.0f, 1.0f));
    snapshot.previewScale = 4;
    EXPECT_EQ(statisticsOf(snapshot, {4, 0, 12, 8}).mean, few.mean);
    EXPECT_EQ(statisticsOf(snapshot, {4, 0, 1000, 1}).pixels, 2u);
    EXPECT_EQ(statisticsOf(snapshot, {100, 100, 200, 200}).pixels, 0u);
}

TEST(InspectorViewer, MeasuresAnArea) {
    expectPlayed(play(R"(
wait finished
mark
open "Inspector"
wait frames 3
expect no-widget "Area mean"
click "Measure an area…"
drag 30 40 200 80
wait frames 3
expect widget "Measured area"
expect "Area mean" "1  1  1"
expect "Area deviation" "0  0  0"
expect restarts 0
click "Forget the area"
wait frames 3
expect no-widget "Measured area"
)",
                      "--passes 4"));
}

TEST(Outliner, FindsByPartsOfNamesInAnyCase) {
    SceneDescription scene;
    scene.objects.resize(10000);
    scene.objects[4321].name = "Teapot";
    scene.materials.resize(1);
    scene.materials[0].name = "tea colour";
    scene.lights.resize(2);
    SceneDocument document;
    document.adopt(scene);
    Outliner outliner;
    outliner.update(document);
    EXPECT_EQ(outliner.size(), 10003u);
    EXPECT_EQ(outliner.at(10002).label, "Material 1: tea colour");
    outliner.search = "TEA";
    outliner.update(document);
    ASSERT_EQ(outliner.size(), 2u);
    EXPECT_EQ(outliner.at(0).label, "Object 4322: Teapot");
    EXPECT_EQ(outliner.at(0).index, 4321);
    EXPECT_EQ(outliner.at(1).label, "Material 1: tea colour");
    EXPECT_EQ(outliner.count(), 10003u);
    outliner.search = "light";
    outliner.update(document);
    EXPECT_EQ(outliner.size(), 2u);
}

TEST(InspectorViewer, TellsWhatThePixelHolds) {
    const Ran ran = play(R"(
wait finished
open "Inspector"
wait frames 3
move "Image" 0.5 0.06
wait picture
wait frames 4
expect "Inspector/Linear" "1  1  1"
expect "Inspector/Object" "–"
expect "Depth" "–"
move "Image"
wait picture
wait frames 4
expect "Pixel" "32, 24"
expect "Inspector/Object" "sphere 1"
expect "Inspector/Material" grey
expect "Depth" "3 m"
print "Inspector/Luminance"
print "Clipped"
screenshot inspector.png
set "Integrator" SPPM
wait finished
wait frames 4
expect widget "SPPM radius"
)",
                         "--passes 4");
    expectPlayed(ran);
    EXPECT_THAT(ran.output, HasSubstr(" ± ")) << "the standard error comes by itself";
    EXPECT_THAT(ran.output, HasSubstr("% black, ")) << ran.output;
}

TEST(OutlinerViewer, SelectsFramesAndFollowsClicks) {
    expectPlayed(play(R"(
wait picture
close "Render"
close "Convergence"
close "Lens"
open "Outliner"
wait frames 3
expect "Object 1: sphere 1" ""
move "Image"
press
release
wait frames 3
expect "Object 1: sphere 1" selected
set "Search" grey
wait frames 3
expect no-widget "Object 1: sphere 1"
expect widget "Material 1: grey"
set "Search" object
wait frames 3
move "Image" 0.5 0.05
press
release
wait frames 3
expect "Object 1: sphere 1" ""
click "Object 1: sphere 1"
wait frames 3
expect "Object 1: sphere 1" selected
mark
click "Frame selection"
wait picture
expect restarts 1
open "History"
wait frames 3
expect widget "2. Frame sphere 1"
)"));
}

}  // namespace
}  // namespace glint
