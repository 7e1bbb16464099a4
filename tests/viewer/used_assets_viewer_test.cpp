// Textures and environment images that nothing used when the scene was opened are read when they are chosen
// in the window; files that cannot be used put the choice back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "engine/io/scene_loader.h"
#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;
using testing::HasSubstr;

constexpr const char* kLibrary = R"({
  "glint": 1,
  "resolution": [64, 48],
  "camera": { "position": [0, 0, 3], "target": [0, 0, 0] },
  "textures": { "red": { "file": "red.png" }, "broken": { "file": "broken.png" } },
  "materials": { "grey": { "type": "diffuse", "color": 0.5 } },
  "meshes": { "wall": { "file": "wall.obj", "part": 0 } },
  "objects": [{ "type": "mesh", "mesh": "wall", "material": "grey" }],
  "lights": [{ "type": "directional", "direction": [0, 0, -1], "irradiance": 3.14159 }],
  "environment": { "strength": 0, "image": { "file": "blue.png" } }
})";

/// A wall whose texture coordinates all lie in the picture's right half.
constexpr const char* kWall = R"(v -2 -2 0
v 2 -2 0
v 0 2 0
vt 0.7 0.2
vt 0.8 0.2
vt 0.7 0.8
f 1/1 2/2 3/3
)";

Ran playLibrary(const std::string& script) {
    // Black on the left, red on the right: without texture coordinates both would be seen.
    EXPECT_TRUE(savePng("red.png", {2, 1, {0, 0, 0, 255, 0, 0}}));
    EXPECT_TRUE(savePng("blue.png", {2, 1, {0, 0, 255, 0, 0, 255}}));
    write("broken.png", "no picture");
    write("wall.obj", kWall);
    write("library.json", kLibrary);
    write("script.txt", script);
    return run("view library.json --headless --threads 1 --script script.txt");
}

struct Rgb {
    int r, g, b;
};

/// In the middle of the saved picture, on the wall; and at its left edge, beside it.
Rgb pixel(const std::string& path, int x, int y) {
    const auto image = loadImage8(path);
    EXPECT_TRUE(image.ok());
    const size_t at =
        3 * (static_cast<size_t>(y) * static_cast<size_t>((*image)->width) + static_cast<size_t>(x));
    return {(*image)->rgb[at], (*image)->rgb[at + 1], (*image)->rgb[at + 2]};
}

TEST(UsedAssetsViewer, WhatIsChosenIsReadAndRendered) {
    expectPlayed(playLibrary(R"(
wait picture
open "Materials"
open "Lights"
open "Checkpoint"
wait frames 2
expect "Texture" none
mark
set "Texture" red
wait picture
expect "Texture" red
expect restarts 1
expect mesh-builds 0
mark
set "Env. strength" 1
wait picture
expect restarts 1
wait passes 4
set "PNG file" chosen.png
click "Save PNG"
wait jobs
set "Scene file" chosen.json
click "Save scene"
wait jobs
)"));
    const Rgb wall = pixel("chosen.png", 32, 24);
    EXPECT_GT(wall.r, 200);
    EXPECT_EQ(wall.g, 0);
    const Rgb sky = pixel("chosen.png", 1, 1);
    EXPECT_GT(sky.b, 200);
    EXPECT_EQ(sky.r, 0);
    const auto saved = loadScene("chosen.json");
    ASSERT_TRUE(saved.ok()) << saved.error().format();
    EXPECT_EQ(saved->textures.size(), 2u) << "the broken one too";
    EXPECT_EQ(saved->materials.at(0).color.texture, 0);
    EXPECT_TRUE(saved->textures[0].image.isRead());
    EXPECT_EQ(saved->meshes.at(0).data->uvs.size(), 3u);
    EXPECT_EQ(saved->environment.strength, 1.0f);
}

TEST(UsedAssetsViewer, ABrokenFilePutsTheChoiceBack) {
    const Ran ran = playLibrary(R"(
wait picture
open "Materials"
open "Checkpoint"
wait frames 2
mark
set "Texture" broken
wait jobs
expect "Texture" none
expect message "broken.png: is not an image"
expect restarts 0
set "Exposure" 1
wait passes 3
set "Texture" red
wait picture
expect "Texture" red
expect restarts 1
)");
    expectPlayed(ran);
    EXPECT_THAT(ran.output, HasSubstr("broken.png: is not an image")) << "in the log";
}

}  // namespace
}  // namespace glint
