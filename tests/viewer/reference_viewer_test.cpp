// The reference picture of the Convergence panel, by scripts.
#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "engine/report/metrics.h"
#include "tests/viewer/play_script.h"
#include "viewer/base/units.h"

namespace glint {
namespace {

using namespace test;
using testing::HasSubstr;

/// A picture of the small scene after so many passes, with its full precision.
void makeReference(const std::string& file, int passes) {
    expectPlayed(play("wait finished\nopen \"Checkpoint\"\nwait frames 2\nset \"EXR file\" " + file +
                          "\nset \"32-bit float\" on\nclick \"Save EXR\"\nwait jobs\n",
                      "--passes " + std::to_string(passes)));
}

TEST(ReferenceViewer, TheErrorAgainstAReferenceIsThatOfTheSavedImages) {
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
    EXPECT_GT(ofPath->pictureError, 1e-4) << "another seed, another picture";
    EXPECT_THAT(printed(ran, "Convergence/Path tracing"),
                testing::ElementsAre(percent(ofPath->pictureError) + ", 9 passes"));
    EXPECT_THAT(printed(ran, "Convergence/SPPM"),
                testing::ElementsAre(percent(ofSppm->pictureError) + ", 9 passes",
                                     percent(ofSppm->mape) + ", 9 passes"));
}

TEST(ReferenceViewer, AReferenceOfAnotherSizeSaysSo) {
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

TEST(ReferenceViewer, AReferenceOfAnotherViewIsNotMeasuredAgainst) {
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

TEST(ReferenceViewer, MapsOfTheErrorHaveAScale) {
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
