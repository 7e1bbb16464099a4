// Views of OpenColorIO configurations in the window, by scripts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/atomic_file.h"
#include "engine/render/ocio_view.h"
#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;

constexpr const char* kConfig = R"(ocio_profile_version: 2
roles:
  default: lin_rec709
  scene_linear: lin_rec709
file_rules:
  - !<Rule> {name: Default, colorspace: default}
displays:
  Screen:
    - !<View> {name: Plain, colorspace: lin_rec709}
    - !<View> {name: Half, colorspace: half}
active_displays: [Screen]
active_views: []
colorspaces:
  - !<ColorSpace>
    name: lin_rec709
    bitdepth: 32f
  - !<ColorSpace>
    name: half
    bitdepth: 32f
    from_scene_reference: !<MatrixTransform> {matrix: [0.5,0,0,0, 0,0.5,0,0, 0,0,0.5,0, 0,0,0,1]}
)";

TEST(OcioViewer, AViewIsChosenSavedAndUndone) {
    if (!hasOcio()) { GTEST_SKIP() << "built without OpenColorIO"; }
    write("config.ocio", kConfig);
    expectPlayed(play(R"w(
wait finished
mark
close "Render"
close "Camera"
close "Lens"
open "Checkpoint"
open "Inspector"
wait frames 2
set "Tone map" "Clamp (linear)"
wait picture
screenshot clamped.png
move "Image"
wait frames 3
set "PNG file" clamped_half.png
set "Exposure" -1
wait frames 3
click "Save PNG"
wait jobs
set "Exposure" 0
set "Tone map" OpenColorIO
wait frames 3
expect no-widget "OCIO view"
set "OCIO config" config.ocio
click "Read the configuration"
wait jobs
wait frames 3
expect "OCIO display" Screen
expect "OCIO view" Plain
expect "Tone map" OpenColorIO
set "OCIO view" Half
wait jobs
wait picture
expect "OCIO view" Half
set "PNG file" view_half.png
click "Save PNG"
wait jobs
screenshot half.png
expect restarts 0
key ctrl down
key z
key ctrl up
wait frames 3
expect "OCIO view" Plain
set "Tone map" Filmic
wait picture
expect no-widget "OCIO view"
)w",
                      "--passes 4"));
    EXPECT_TRUE(*readFile("view_half.png") == *readFile("clamped_half.png"));
}

TEST(OcioChoice, NamesEndAtColonsAndSlashesBehindTheConfiguration) {
    write("a.ocio", kConfig);
    write("a:b.ocio", kConfig);
    const auto read = [](const char* text) {
        const OcioChoice choice = parseOcioChoice(text);
        return choice.config + "|" + choice.display + "|" + choice.view;
    };
    EXPECT_EQ(read("a.ocio"), "a.ocio||");
    EXPECT_EQ(read("a:b.ocio"), "a:b.ocio||");
    EXPECT_EQ(read("a.ocio:Screen"), "a.ocio|Screen|");
    EXPECT_EQ(read("a.ocio:Screen/Half light"), "a.ocio|Screen|Half light");
    EXPECT_EQ(read("a.ocio:Screen:Half/b"), "a.ocio|Screen|Half/b");
    EXPECT_EQ(read("a.ocio:/Half"), "a.ocio||Half");
    EXPECT_EQ(read("a:b.ocio:Screen/Half"), "a:b.ocio|Screen|Half");
    EXPECT_EQ(read("missing.ocio:Screen"), "missing.ocio|Screen|");
}

TEST(OcioViewer, TheCommandLineChoosesOne) {
    if (!hasOcio()) { GTEST_SKIP() << "built without OpenColorIO"; }
    write("config.ocio", kConfig);
    expectPlayed(
        play("wait picture\nexpect \"OCIO view\" Half\n", "--passes 4 --ocio config.ocio:Screen/Half"));
    expectPlayed(play("wait picture\nexpect \"OCIO view\" Plain\n", "--passes 4 --ocio config.ocio:Screen"));
    EXPECT_EQ(play("wait picture\n", "--ocio no.ocio").exitCode, 1);
    EXPECT_THAT(play("wait picture\n", "--ocio config.ocio:Scren").output,
                testing::HasSubstr("there is no display 'Scren' (did you mean 'Screen'?)"));
}

}  // namespace
}  // namespace glint
