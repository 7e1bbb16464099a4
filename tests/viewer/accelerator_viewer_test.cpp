// Acceleration structures and ray casting in the window, by script: what their edits restart, and the
// pictures of what is tested, alone and in the split view.
#include <gtest/gtest.h>

#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;

constexpr const char* kKnot = R"({
  "glint": 1,
  "resolution": [64, 48],
  "camera": { "position": [0, 0, 4], "target": [0, 0, 0] },
  "materials": { "grey": { "type": "diffuse", "color": 0.5 } },
  "objects": [{ "type": "mesh", "mesh": { "generator": "torus-knot", "triangleCount": 2000 },
                "material": "grey" }],
  "lights": [{ "type": "point", "position": [2, 2, 3], "intensity": 20 }],
  "environment": { "color": 1 }
})";

Ran playKnot(const std::string& script) {
    write("knot.json", kKnot);
    write("script.txt", script);
    return run("view knot.json --headless --threads 1 --script script.txt --passes 4");
}

TEST(AcceleratorViewer, AnotherStructureIsBuiltAndTheFilmRestartsOnce) {
    expectPlayed(playKnot(R"(
wait finished
mark
set "Accelerator" kd-tree
wait finished
expect restarts 1
expect mesh-builds 1
expect top-level-builds 1
expect material-tables 0
expect light-tables 0
expect feature-scans 0
set "Accelerator" "One box each"
wait picture
set "Accelerator" None
wait picture
set "Accelerator" "Box hierarchy"
wait finished
# The first film comes back.
expect restarts 3
expect mesh-builds 4
)"));
}

TEST(AcceleratorViewer, WhatRaysAreTestedAgainstIsShownAloneAndInTheSplitView) {
    expectPlayed(playKnot(R"(
wait finished
mark
expect no-widget "Scale"
set "Shown" "Boxes tested"
wait picture
expect widget "Scale"
set "Shown" "Triangles tested"
wait picture
expect widget "Scale"
set "Compare" on
wait picture
expect widget "Scale"
expect restarts 0
)"));
}

TEST(AcceleratorViewer, RayCastingsSettingsRestartItsFilmOnly) {
    expectPlayed(playKnot(R"(
wait finished
expect no-widget "Ray casting/Shadows"
set "Integrator" "Ray casting"
wait finished
mark
set "Ray casting/Shadows" off
wait picture
set "Ray casting/Falloff" off
wait picture
open "Materials"
set "Shininess" 5
wait finished
expect restarts 3
expect material-tables 0
expect light-tables 0
expect mesh-builds 0
mark
set "Integrator" "Path tracing"
wait picture
expect passes-at-least 4
expect restarts 0
)"));
}

}  // namespace
}  // namespace glint
