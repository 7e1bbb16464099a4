// Focusing on what is under the mouse, and the overlay of what is sharp, by scripts.
#include <algorithm>

#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;

TEST(FocusViewer, ClicksAndTFocusOnWhatIsUnderTheMouse) {
    // The sphere's front is 3 m away; the pixel under the mouse is half a pixel off the axis.
    expectPlayed(play(R"(
wait picture
open "Lens"
wait frames 2
set "Aperture" 50
wait picture
mark
move "Image"
key t
wait picture
expect "Focal distance" 3.0005178
expect "Focus on target" off
expect restarts 1
expect material-tables 0
set "Focal distance" 7
wait picture
move "Image"
key ctrl down
press
release
key ctrl up
wait picture
expect "Focal distance" 3.0005178
set "Focal distance" 7
wait picture
click "Click to focus"
wait frames 2
expect widget "Click on the picture…"
move "Image"
press
release
wait picture
expect "Focal distance" 3.0005178
expect widget "Click to focus"
click "Click to focus"
key escape
wait frames 3
expect widget "Click to focus"
)"));
}

TEST(FocusViewer, WhereNothingIsNothingIsFocusedOn) {
    expectPlayed(play(R"(
wait picture
mark
move "Image" 0.5 0.05
key t
wait frames 4
expect restarts 0
expect "Focal distance" 4
)"));
}

TEST(FocusViewer, StopsAndFocalLengthsAreTiedTogether) {
    expectPlayed(play(R"(
wait picture
set "Focal length" 50
wait picture
expect "Field of view" 26.991467
set "f-stop" 2.8
wait picture
expect "Aperture" 17.857143
click "Close by 1/3"
wait picture
expect "f-stop" 3.1748021
set "Focal length" 100
wait picture
expect "f-stop" 3.1748021
set "Sensor" "APS-C, 23.6 × 15.7 mm"
wait frames 3
expect "Focal length" 65.416667
)"));
}

struct Counts {
    int yellow = 0, green = 0, blue = 0, orange = 0;
};
Counts countsIn(const std::string& screenshot) {
    const auto image = loadImage(screenshot);
    EXPECT_TRUE(image);
    Counts counts;
    const Image8& picture = *image->bytes;
    for (int y = 0; y < 680; ++y) {
        for (int x = 0; x < 880; ++x) {
            const uint8_t* p = picture.rgb.data() + 3 * (static_cast<size_t>(y) * picture.width + x);
            counts.yellow += p[0] > 240 && p[1] > 220 && p[2] < 90;
            counts.green += p[1] > p[0] + 40 && p[1] > p[2] + 40;
            counts.blue += p[2] > p[0] + 60 && p[2] > p[1] + 40;
            counts.orange += p[0] > p[2] + 80 && p[1] > p[2] + 20 && p[1] < 215;
        }
    }
    return counts;
}

TEST(FocusViewer, TheOverlayShowsWhereTheFocusCuts) {
    // The plane in focus cuts the sphere half way to its rim, which is sharp there alone.
    expectPlayed(play(R"(
wait picture
set "Aperture" 200
set "Focal distance" 3.3
wait picture
screenshot none.png
set "Focus overlay" "What is sharp"
wait picture
screenshot sharp.png
set "Focus overlay" "Circles of confusion"
set "Sharp within" 0.1
wait picture
screenshot blur.png
set "Focus overlay" "Off"
wait picture
screenshot off.png
)",
                      "--passes 3"));
    const Counts none = countsIn("none.png");
    EXPECT_EQ(none.yellow + none.green + none.blue + none.orange, 0);
    const Counts sharp = countsIn("sharp.png");
    EXPECT_GT(sharp.yellow, 200);
    EXPECT_GT(sharp.green, 1000);
    const Counts blur = countsIn("blur.png");
    EXPECT_GT(blur.blue, 1000) << "the sphere's front";
    EXPECT_GT(blur.orange, 10000) << "its rim, and what is behind";
    EXPECT_EQ(countsIn("off.png").green, 0);
}

}  // namespace
}  // namespace glint
