// The studio of a model without light is switched off and on in the window.
#include <gtest/gtest.h>

#include "tests/viewer/play_script.h"

namespace glint {
namespace {

TEST(StudioViewer, IsSwitchedOffAndOn) {
    test::write("model.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    test::write("script.txt", R"(
wait picture
open "Lights"
wait frames 2
expect "Studio" on
mark
set "Studio" off
wait picture
expect restarts 1
expect mesh-builds 0
expect "Studio" off
set "Studio" on
wait picture
expect "Studio" on
)");
    test::expectPlayed(test::run("view model.obj --headless --threads 1 --script script.txt"));
}

}  // namespace
}  // namespace glint
