// The switch of the Display panel: the picture and the files that are saved are denoised while it is on, and
// say so.
#include <gtest/gtest.h>

#include "engine/io/exr_io.h"
#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;

TEST(DenoiseViewer, ShowsAndSavesWithoutNoiseWhileItIsOn) {
    const Ran ran = play(R"(open "Render"
set "Pass limit" 8
wait finished
wait picture
mark
expect no-widget "Note"
open "Checkpoint"
set "EXR file" "noisy.exr"
click "Save EXR"
wait jobs
open "Display"
set "Denoise" on
wait picture
wait frames 2
expect widget "Note"
print "Note"
set "EXR file" "denoised.exr"
click "Save EXR"
wait jobs
expect no-error
set "Shown" "Depth"
wait picture
wait frames 2
expect no-widget "Note"
set "Shown" "Radiance"
wait picture
wait frames 2
print "Note"
set "Denoise" off
wait picture
wait frames 2
expect no-widget "Note"
expect restarts 0
expect passes-at-least 8
)");
    expectPlayed(ran);
    EXPECT_EQ(printed(ran, "Note"), (std::vector<std::string>{"Denoised", "Denoised"})) << ran.output;
    const auto noisy = loadExr("noisy.exr"), denoised = loadExr("denoised.exr");
    ASSERT_TRUE(noisy && denoised);
    EXPECT_FALSE(noisy->attributes.contains("denoised"));
    EXPECT_EQ(denoised->attributes.at("denoised"), "yes");
    EXPECT_NE(noisy->find("G")->floats, denoised->find("G")->floats);
}

TEST(DenoiseViewer, FollowsEditsWhileItRenders) {
    expectPlayed(play(R"(open "Display"
set "Denoise" on
wait passes 3
wait picture
drag 300 300 360 320
wait picture
key space
wait paused
wait picture
expect widget "Note"
)"));
}

}  // namespace
}  // namespace glint
