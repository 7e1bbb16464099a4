// Bump maps, normal maps and cut-outs in the Materials panel: edited live, and saved.
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "engine/io/scene_loader.h"
#include "tests/viewer/play_script.h"

namespace glint::test {
namespace {

TEST(ReliefViewer, IsEditedLiveAndSaved) {
    ASSERT_TRUE(savePng("heights.png", {2, 1, {0, 0, 0, 255, 255, 255}}));
    write("relief.json", R"({
  "glint": 1, "resolution": [64, 48],
  "camera": { "position": [0, 1, 4], "target": [0, 1, 0] },
  "textures": { "heights": { "file": "heights.png" } },
  "materials": { "grey": { "type": "diffuse", "color": 0.5 } },
  "objects": [{ "type": "sphere", "material": "grey", "center": [0, 1, 0], "radius": 1 }],
  "environment": { "color": 1 }
})");
    write("script.txt", R"(
wait picture
open "Materials"
open "Checkpoint"
wait frames 2
mark
set "Bump map" heights
wait picture
expect restarts 1
mark
set "Bump height" 0.25
wait picture
expect restarts 1
set "Normal map" heights
set "Normal strength" 0.5
set "Opacity" 0.75
wait picture
set "Scene file" saved.json
click "Save scene"
wait jobs
)");
    expectPlayed(run("view relief.json --headless --threads 1 --script script.txt"));
    const auto saved = loadScene("saved.json");
    ASSERT_TRUE(saved.ok()) << saved.error().format();
    const Material& material = saved->materials.at(0);
    EXPECT_EQ(material.bump.texture, 0);
    EXPECT_FLOAT_EQ(material.bumpHeight, 0.25f);
    EXPECT_EQ(material.normalMap.texture, 0);
    EXPECT_FLOAT_EQ(material.normalStrength, 0.5f);
    EXPECT_FLOAT_EQ(material.opacity.value, 0.75f);
}

}  // namespace
}  // namespace glint::test
