// Materials that are dragged to objects, and images from files, by scripts.
#include <algorithm>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "engine/io/scene_loader.h"
#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;
namespace fs = std::filesystem;

const std::string kOnlyThese = R"(
wait picture
close "Scene"
close "Render"
close "Camera"
close "Lens"
close "Display"
)";

TEST(MaterialDrop, APresetIsGivenToTheObjectUnderTheMouse) {
    expectPlayed(play(kOnlyThese + R"(
open "Object"
open "Library"
wait frames 3
set "Group" Paints
wait frames 3
move "Terracotta"
press
move "Image" 0.5 0.5
wait frames 3
release
wait picture
expect "Object/Name" "sphere 1"
expect "Object/Material" Terracotta
key ctrl down
key z
key ctrl up
wait picture
expect "Object/Material" grey
move "Terracotta"
press
move "Image" 0.02 0.02
wait frames 3
release
wait frames 3
expect "Object/Material" grey
expect "Status message" "There is no object to give the material to"
)"));
}

/// Its user may still want it.
TEST(MaterialDrop, AnEditedMaterialOfThatNameStays) {
    const std::string drop = R"(
move "Library/Terracotta"
press
move "Image" 0.5 0.5
wait frames 3
release
wait picture
)";
    expectPlayed(play(kOnlyThese + R"(
open "Object"
open "Library"
open "Materials"
wait frames 3
set "Group" Paints
wait frames 3
)" + drop + R"(
expect "Object/Material" Terracotta
)" + drop + R"(
expect "Object/Material" Terracotta
expect no-widget "Materials/Terracotta 2"
set "Materials/Colour" 0 0 1
wait picture
)" + drop + R"(
expect "Object/Material" "Terracotta 2"
click "Materials/Terracotta"
wait frames 3
expect "Materials/Colour" 0 0 1
)" + drop + R"(
expect "Object/Material" "Terracotta 2"
)"));
}

TEST(MaterialDrop, AMaterialOfTheSceneToo) {
    std::string two(kScene);
    two.insert(two.find("\"grey\""), R"("red": {"type": "diffuse", "color": [0.8, 0, 0]}, )");
    write("two.json", two);
    write("script.txt", kOnlyThese + R"(
open "Object"
open "Materials"
wait frames 3
move "Materials/red"
press
move "Image" 0.5 0.5
wait frames 3
release
wait picture
expect "Object/Material" red
)");
    expectPlayed(run("view two.json --headless --threads 1 --script script.txt"));
}

TEST(MaterialDrop, BallsOfTheLibraryAreRendered) {
    expectPlayed(play(kOnlyThese + R"(
open "Library"
wait frames 2
set "Group" Plastics
wait jobs
click "Go to Library"
wait frames 4
expect "Red, glossy" pictured
screenshot library.png
)",
                      "--passes 2"));
    const auto shown = loadImage8("library.png");
    ASSERT_TRUE(shown);
    std::set<uint8_t> reds;
    for (size_t i = 0; i < (*shown)->rgb.size(); i += 3) {
        const uint8_t* pixel = &(*shown)->rgb[i];
        if (pixel[0] > 2 * std::max(pixel[1], pixel[2])) { reds.insert(pixel[0]); }
    }
    EXPECT_GT(reds.size(), 20u) << "a ball is lit from one side; a patch has one colour";
}

TEST(ImageChoice, TexturesAndEnvironmentsComeFromFiles) {
    fs::create_directories("images");
    ASSERT_TRUE(savePng("images/green.png", {2, 1, {0, 200, 0, 0, 200, 0}}));
    fs::remove("textured.json");
    expectPlayed(play(kOnlyThese + R"(
open "Materials"
open "Lights"
open "Checkpoint"
wait frames 3
set "Texture" "From a file…"
wait frames 3
set "Name" images/green.png
click "Open this"
wait picture
expect "Texture" green.png
set "Kind" Plastic
wait picture
set "Roughness map" "From a file…"
wait frames 3
set "Name" images/green.png
click "Open this"
wait picture
set "Lights/Image" Sky
wait picture
set "Scene file" textured.json
click "Save scene"
wait jobs
)"));
    const auto saved = loadScene("textured.json");
    ASSERT_TRUE(saved) << saved.error().format();
    ASSERT_EQ(saved->textures.size(), 2u) << "numbers are linear";
    EXPECT_EQ(saved->textures[0].encoding, ColorEncoding::Srgb);
    EXPECT_EQ(saved->textures[1].encoding, ColorEncoding::Linear);
    EXPECT_EQ(saved->materials[0].color.texture, 0);
    EXPECT_EQ(saved->materials[0].roughness.texture, 1);
    ASSERT_EQ(saved->environmentImages.size(), 1u);
    EXPECT_TRUE(saved->environmentImages[0].isGenerated());
}

TEST(ImageChoice, PicturesOfLightsComeFromFiles) {
    fs::create_directories("images");
    ASSERT_TRUE(savePng("images/green.png", {2, 1, {0, 200, 0, 0, 200, 0}}));
    fs::remove("pictured.json");
    std::string lit = kScene;
    lit.insert(lit.find("\"objects\""),
               R"("lights": [{"type": "spot", "position": [0, 2, 2], "direction": [0, -1, -1]}],
)");
    write("lit.json", lit);
    write("script.txt", kOnlyThese + R"(
open "Lights"
open "Checkpoint"
wait frames 3
expect no-widget "Lights/Picture"
set "Lights/Kind" Projector
wait picture
set "Lights/Picture" "From a file…"
wait frames 3
set "Name" images/green.png
click "Open this"
wait picture
expect "Lights/Picture" green.png
set "Lights/Kind" Goniometric
wait picture
expect "Lights/Picture" green.png
expect no-error
set "Scene file" pictured.json
click "Save scene"
wait jobs
)");
    expectPlayed(run("view lit.json --headless --threads 1 --script script.txt"));
    const auto saved = loadScene("pictured.json");
    ASSERT_TRUE(saved) << saved.error().format();
    ASSERT_EQ(saved->lights.size(), 1u);
    EXPECT_EQ(saved->lights[0].kind, LightKind::Goniometric);
    ASSERT_EQ(saved->lights[0].image.texture, 0);
    EXPECT_EQ(saved->textures[0].encoding, ColorEncoding::Srgb);
    EXPECT_TRUE(saved->textures[0].image.isRead());
}

}  // namespace
}  // namespace glint
