// Checkpoints keep how their scene's file was read: the same scene is opened again, also where it holds
// images in memory, which no checkpoint has.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scene_loader.h"
#include "engine/render/checkpoint.h"
#include "tests/support/capture.h"
#include "tests/support/temp_folder.h"

namespace glint::test {
namespace {

using testing::HasSubstr;

/// `sky`: an emitter whose picture is made while the file is read.
std::string mitsubaScene(bool hasSky) {
    return std::string(R"(<scene version="3.0.0"><default name="grey" value="0.25"/>
<shape type="sphere"><bsdf type="diffuse"><rgb name="reflectance" value="$grey"/></bsdf></shape>)") +
           (hasSky ? R"(<emitter type="sky"/></scene>)" : R"(<emitter type="constant"/></scene>)");
}

SessionCapture captured(const SceneDescription& scene) {
    return captureOf(scene, Film(scene.resolution.width, scene.resolution.height), 1.0);
}

float greyOf(const SceneDescription& scene) { return scene.materials.at(0).color.value.x; }

TEST(CheckpointReading, TheSameSceneIsOpenedAgain) {
    for (const bool hasSky : {false, true}) {
        const TempFolder folder;
        const std::string path = folder.write("a.xml", mitsubaScene(hasSky)),
                          film = folder.path("a.glintfilm");
        const auto scene =
            loadScene(path, {.allowMissing = true, .parameters = {{"grey", "0.75"}, {"unknown", "x"}}});
        ASSERT_TRUE(scene) << scene.error().format();
        ASSERT_EQ(greyOf(*scene), 0.75f);
        ASSERT_TRUE(saveCheckpoint(film, captured(*scene)));
        const auto info = readCheckpointInfo(film);
        ASSERT_TRUE(info) << info.error().format();
        EXPECT_EQ(info->readWith, scene->readWith);
        EXPECT_TRUE(info->readWith.allowMissing);
        EXPECT_FALSE(info->readWith.noStudio);
        EXPECT_EQ(info->readWith.parameters.size(), 2u);
        EXPECT_THAT(info->scenePath, HasSubstr("a.xml"));
        const auto opened = loadCheckpointScene(film);
        ASSERT_TRUE(opened) << opened.error().format();
        EXPECT_EQ(greyOf(*opened), 0.75f);
        EXPECT_EQ(opened->readWith, scene->readWith);
        const auto point = loadCheckpoint(film, *opened);
        EXPECT_TRUE(point) << point.error().format();
    }
}

/// Its own file says what was edited; of one with images in memory, that is said.
TEST(CheckpointReading, EditsOfScenesWithImagesInMemoryAreMissed) {
    const TempFolder folder;
    const std::string path = folder.write("a.xml", mitsubaScene(true)), film = folder.path("a.glintfilm");
    auto scene = loadScene(path);
    ASSERT_TRUE(scene) << scene.error().format();
    scene->materials[0].color.value = Vec3(0.5f);
    ASSERT_TRUE(saveCheckpoint(film, captured(*scene)));
    const auto opened = loadCheckpointScene(film);
    ASSERT_TRUE(opened) << opened.error().format();
    const auto point = loadCheckpoint(film, *opened);
    ASSERT_FALSE(point);
    EXPECT_THAT(point.error().format(), HasSubstr("the materials differ"));
}

TEST(CheckpointReading, ScenesOfNoFileHaveNone) {
    const TempFolder folder;
    SceneDescription scene;
    scene.resolution = {4, 4};
    ASSERT_TRUE(saveCheckpoint(folder.path("a.glintfilm"), captured(scene)));
    const auto info = readCheckpointInfo(folder.path("a.glintfilm"));
    ASSERT_TRUE(info);
    EXPECT_EQ(info->readWith, ReadingOptions());
}

}  // namespace
}  // namespace glint::test
