// A profile's control points in the window: dragged, typed, added and removed.
#include <gtest/gtest.h>

#include "tests/viewer/play_script.h"

namespace glint {
namespace {

constexpr const char* kScene = R"({ "glint": 1, "resolution": [64, 64],
    "camera": { "position": [0, 0.5, 4], "target": [0, 0.5, 0] },
    "objects": [{ "type": "revolved", "name": "vase", "material": { "type": "diffuse", "emission": 1 },
                  "profile": [[0, 0], [0.6, 0.2], [0.3, 0.6], [0.5, 1]] }] })";

TEST(ProfileViewer, PointsAreDraggedTypedAddedAndRemoved) {
    test::write("vase.json", kScene);
    test::write("script.txt", R"(
wait picture
open "Profile"
wait frames 3
expect "Surface" vase
mark
drag "Point 2" 40 0
wait picture
expect restarts 1
expect "Height" 0.2
set "Distance" 0.45
wait frames 2
expect "Distance" 0.45
click "Add points"
wait frames 2
expect "Point 5" "0.5 1"
click "Remove"
wait frames 2
set "Profile/Curve" "B-spline"
wait picture
expect "Profile/Curve" "B-spline"
)");
    test::expectPlayed(test::run("view vase.json --headless --threads 1 --script script.txt"));
}

}  // namespace
}  // namespace glint
