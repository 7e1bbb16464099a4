// The Convergence panel by script: both curves grow, the error against a reference is that of the saved
// pictures, checkpoints keep the curve, and what the mouse, the target and the files do.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/atomic_file.h"
#include "engine/io/image_io.h"
#include "engine/report/metrics.h"
#include "tests/viewer/play_script.h"
#include "viewer/base/units.h"

namespace glint {
namespace {

using namespace test;
using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

/// What `print "LABEL"` said, in order.
std::vector<std::string> printed(const Ran& ran, const std::string& label) {
    std::vector<std::string> values;
    const std::string begin = "\"" + label + "\" ";
    size_t at = 0;
    while ((at = ran.output.find(begin, at)) != std::string::npos) {
        at += begin.size();
        values.push_back(ran.output.substr(at, ran.output.find('\n', at) - at));
    }
    return values;
}

struct PointCounts {
    int path = -1;
    int sppm = -1;
};
PointCounts countsOf(const std::string& text) {
    PointCounts counts;
    std::sscanf(text.c_str(), "Path tracing %d points, SPPM %d points", &counts.path, &counts.sppm);
    return counts;
}

/// A picture of the small scene after so many passes, with its full precision.
void makeReference(const std::string& file, int passes) {
    expectPlayed(play("wait finished\nopen \"Checkpoint\"\nwait frames 2\nset \"EXR file\" " + file +
                          "\nset \"32-bit float\" on\nclick \"Save EXR\"\nwait jobs\n",
                      "--passes " + std::to_string(passes)));
}

TEST(ConvergenceViewer, BothCurvesGrow) {
    const Ran ran = play(R"(
set "Integrator" SPPM
wait frames 2
set "Photons" 2000
key c
wait passes 3
wait frames 2
print "Convergence/Curve"
wait passes 30
wait frames 2
print "Convergence/Curve"
expect widget "Convergence/PT to target"
move "Convergence/Curve" 0.5 0.6
wait frames 3
print "Convergence/Curve"
screenshot "curves.png"
)");
    expectPlayed(ran);
    const auto said = printed(ran, "Convergence/Curve");
    ASSERT_EQ(said.size(), 3u) << ran.output;
    const PointCounts before = countsOf(said[0]);
    const PointCounts after = countsOf(said[1]);
    EXPECT_GE(before.sppm, 2) << said[0];
    EXPECT_GT(after.path, before.path) << said[1];
    EXPECT_GT(after.sppm, before.sppm) << said[1];
    EXPECT_THAT(said[2], AnyOf(StartsWith("Path tracing: "), StartsWith("SPPM: ")))
        << "what the mouse is over";
    EXPECT_THAT(said[2], HasSubstr("passes"));
    EXPECT_THAT(ran.output, HasSubstr("90 %: "));
}

TEST(ConvergenceViewer, TheErrorAgainstAReferenceIsThatOfTheSavedImages) {
    makeReference("reference.exr", 40);
    const Ran ran = play(R"(
drop "reference.exr"
wait jobs
open "Picture"
open "Checkpoint"
wait frames 2
set "Seed" 7
set "32-bit float" on
set "EXR file" path.exr
wait finished
wait jobs
wait frames 2
print "Convergence/Path tracing"
click "Save EXR"
wait jobs
set "Integrator" SPPM
set "EXR file" sppm.exr
wait finished
wait jobs
wait frames 2
print "Convergence/SPPM"
click "Save EXR"
wait jobs
set "Measured as" MAPE
wait frames 2
print "Convergence/SPPM"
expect widget "Convergence/In use"
click "Clear"
wait frames 3
expect no-widget "Convergence/In use"
)",
                         "--passes 9");
    expectPlayed(ran);
    const auto reference = loadImageF("reference.exr");
    const auto path = loadImageF("path.exr");
    const auto sppm = loadImageF("sppm.exr");
    ASSERT_TRUE(reference && path && sppm);
    const auto ofPath = compareImages(**path, **reference);
    const auto ofSppm = compareImages(**sppm, **reference);
    ASSERT_TRUE(ofPath && ofSppm);
    EXPECT_GT(ofPath->relativeRmse(), 1e-4) << "another seed, another picture";
    EXPECT_THAT(printed(ran, "Convergence/Path tracing"),
                testing::ElementsAre(percent(ofPath->relativeRmse()) + ", 9 passes"));
    EXPECT_THAT(printed(ran, "Convergence/SPPM"),
                testing::ElementsAre(percent(ofSppm->relativeRmse()) + ", 9 passes",
                                     percent(ofSppm->mape) + ", 9 passes"));
}

TEST(ConvergenceViewer, TheCurveBeforeARestartStaysForComparison) {
    const Ran ran = play(R"(
wait passes 24
key r
wait picture
wait passes 24
wait frames 3
move "Convergence/Curve" 0.7 0.6
wait frames 3
print "Convergence/Curve"
set "CSV file" "/proc/no/curves.csv"
click "Export CSV"
wait jobs
wait frames 3
print "Convergence/CSV message"
)",
                         "--passes 24");  // so that both curves end at one place
    expectPlayed(ran);
    const auto said = printed(ran, "Convergence/Curve");
    ASSERT_EQ(said.size(), 1u) << ran.output;
    EXPECT_THAT(ran.output, HasSubstr("Path tracing before the last restart: "));
    EXPECT_THAT(printed(ran, "Convergence/CSV message"),
                testing::ElementsAre(HasSubstr("/proc/no/curves.csv")));
}

TEST(ConvergenceViewer, ACheckpointKeepsTheCurve) {
    expectPlayed(play(R"(
wait finished
open "Checkpoint"
wait frames 2
set "Checkpoint file" curve.glintfilm
click "Checkpoint/Save"
wait jobs
set "CSV file" before.csv
click "Export CSV"
wait jobs
expect message "Saved before.csv"
)",
                      "--passes 14"));
    expectPlayed(play(R"(
wait finished
drop "curve.glintfilm"
wait jobs
expect message "Resumed curve.glintfilm"
wait finished
wait frames 2
set "CSV file" after.csv
click "Export CSV"
wait jobs
)",
                      "--passes 14"));
    const auto before = readFile("before.csv");
    const auto after = readFile("after.csv");
    ASSERT_TRUE(before && after);
    EXPECT_THAT(*before, StartsWith("integrator,source,passes,render_seconds,relative_error,"));
    EXPECT_THAT(*before, HasSubstr("\npath,estimate,14,"));
    EXPECT_EQ(*before, *after);
}

TEST(ConvergenceViewer, AReferenceOfAnotherSizeSaysSo) {
    makeReference("small.exr", 2);
    const Ran ran = play(R"(
open "Picture"
wait frames 2
set "Width" 80
drop "small.exr"
wait jobs
wait frames 3
print "Convergence/Mismatch"
open "Display"
set "Shown" "Error against reference"
wait picture
wait frames 3
expect no-widget "Scale"
set "Width" 64
wait passes 4
wait jobs
wait frames 3
expect no-widget "Convergence/Mismatch"
expect widget "Scale"
drop "missing.exr"
wait jobs
wait frames 3
print "Convergence/Load error"
expect widget "Status message"
expect widget "Convergence/In use"
)");
    expectPlayed(ran);
    EXPECT_THAT(ran.output, HasSubstr("The reference has 64 × 48 pixels, the picture 80 × 48"));
    EXPECT_THAT(ran.output, HasSubstr("missing.exr"));
}

TEST(ConvergenceViewer, AReferenceOfAnotherViewIsNotMeasuredAgainst) {
    makeReference("view.exr", 2);
    const Ran ran = play(R"(
drop "view.exr"
wait jobs
wait passes 4
wait jobs
set "Shown" "Error against reference"
wait picture
wait frames 3
expect no-widget "Convergence/Mismatch"
print "Convergence/Path tracing"
drag 500 300 560 320
wait passes 4
wait frames 3
print "Convergence/Mismatch"
print "Convergence/Path tracing"
expect no-widget "Scale"
print "Note"
key home
wait passes 4
wait jobs
wait frames 3
expect no-widget "Convergence/Mismatch"
expect widget "Scale"
set "Measured as" MAPE
open "Picture"
wait frames 2
set "Seed" 5
set "Max depth" 3
wait passes 4
wait frames 3
print "Convergence/Mismatch"
set "Use anyway" on
wait passes 6
wait jobs
wait frames 3
print "Convergence/Path tracing"
)");
    expectPlayed(ran);
    EXPECT_THAT(
        printed(ran, "Convergence/Mismatch"),
        testing::ElementsAre(HasSubstr("the camera has changed"), HasSubstr("the max depth has changed")));
    EXPECT_THAT(printed(ran, "Note"), testing::ElementsAre(HasSubstr("No reference that fits")));
    const auto errors = printed(ran, "Convergence/Path tracing");
    ASSERT_EQ(errors.size(), 3u) << ran.output;
    EXPECT_THAT(errors[0], HasSubstr("passes"));
    EXPECT_THAT(errors[1], HasSubstr("(")) << "the estimate with its band";
    EXPECT_THAT(errors[2], HasSubstr("passes"));
}

TEST(ConvergenceViewer, ADroppedSceneIsOpened) {
    std::string other = kScene;
    other.replace(other.find("[64, 48]"), 8, "[32, 16]");
    write("other.json", other);
    expectPlayed(play(R"(
wait picture
drop "other.json"
wait jobs
wait picture
expect "Scene/File" other.json
open "Picture"
wait frames 2
expect "Width" 32
)"));
}

TEST(ConvergenceViewer, TheTargetStopsTheRenderWhenAsked) {
    expectPlayed(play(R"(
wait picture
mark
set "Target error" 20
wait frames 2
expect "Error limit" 0
set "Stop there" on
wait finished
wait frames 2
expect "Error limit" 20
print "Convergence/PT to target"
set "Stop there" off
wait frames 2
expect "Error limit" 0
expect "Target error" 20
expect state rendering
expect restarts 0
)"));
}

TEST(ConvergenceViewer, MapsOfTheErrorHaveAScale) {
    const Ran ran = play(R"(
set "Integrator" SPPM
wait frames 2
set "Photons" 2000
wait passes 4
set "Integrator" "Path tracing"
key c
wait passes 4
set "Shown" "Standard error"
wait picture
wait frames 3
print "Scale"
screenshot "noise.png"
set "Shown" "SPPM radius"
wait picture
wait frames 3
print "Scale"
screenshot "radius.png"
set "Shown" Radiance
wait picture
wait frames 3
expect no-widget "Scale"
)");
    expectPlayed(ran);
    const auto scales = printed(ran, "Scale");
    ASSERT_EQ(scales.size(), 2u) << ran.output;
    EXPECT_THAT(scales[0], HasSubstr("noise"));
    EXPECT_THAT(scales[1], HasSubstr("radius")) << "path tracing is chosen, and the other side shows it";
    // Right of the divider, on the sphere: coloured; left of it grey radiance.
    const auto image = loadImage8("radius.png");
    ASSERT_TRUE(image);
    const auto tint = [&](int x, int y) {
        const uint8_t* c =
            (*image)->rgb.data() + (static_cast<size_t>(y) * 1280 + static_cast<size_t>(x)) * 3;
        return std::max({c[0], c[1], c[2]}) - std::min({c[0], c[1], c[2]});
    };
    EXPECT_GE(tint(520, 348), 30);
    EXPECT_LE(tint(380, 348), 12);
}

}  // namespace
}  // namespace glint
