// Checkpoints keep how their scene's file was read, and its edits: the same scene is opened again, also where
// it holds files in memory.
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scene_loader.h"
#include "engine/render/checkpoint.h"
#include "engine/scene/scene_hash.h"
#include "tests/support/capture.h"
#include "tests/support/temp_folder.h"
#include "tests/support/used_assets.h"

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

/// The picture that was made while the file was read stands in the checkpoint, so that its file is not asked.
TEST(CheckpointReading, EditsOfScenesWithImagesInMemoryAreKept) {
    const TempFolder folder;
    const std::string path = folder.write("a.xml", mitsubaScene(true)), film = folder.path("a.glintfilm");
    auto scene = loadScene(path);
    ASSERT_TRUE(scene) << scene.error().format();
    scene->materials[0].color.value = Vec3(0.5f);
    ASSERT_TRUE(saveCheckpoint(film, captured(*scene)));
    folder.write("a.xml", "<scene/>");
    const auto opened = loadCheckpointScene(film);
    ASSERT_TRUE(opened) << opened.error().format();
    EXPECT_EQ(greyOf(*opened), 0.5f);
    ASSERT_EQ(opened->environmentImages.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<EmbeddedFile>(opened->environmentImages[0].source));
    EXPECT_EQ(sceneHash(*opened), sceneHash(*scene));
    const auto point = loadCheckpoint(film, *opened);
    EXPECT_TRUE(point) << point.error().format();
    ASSERT_TRUE(saveCheckpoint(film, captured(*opened)));
    const auto again = loadCheckpointScene(film);
    ASSERT_TRUE(again) << again.error().format();
    EXPECT_EQ(sceneHash(*again), sceneHash(*scene));
}

/// Meshes and textures, one of which has the name that another file on the disk has.
TEST(CheckpointReading, FilesInMemoryAreNotThoseOnTheDisk) {
    const TempFolder folder;
    SceneDescription scene;
    scene.resolution = {4, 4};
    scene.path = folder.path("scene.json");
    const auto bytes = std::make_shared<const std::string>(kLeafPly);
    for (int i = 0; i < 2; ++i) {
        scene.meshes.push_back({.name = "leaf", .source = EmbeddedFile{"leaf.ply", bytes}, .data = nullptr});
    }
    scene.meshes.push_back({.name = "other", .source = FileSource{"embedded/0-leaf.ply"}, .data = nullptr});
    std::filesystem::create_directory(folder.path("embedded"));
    folder.write("embedded/0-leaf.ply", kLeafPly + std::string("\n"));
    const std::string film = folder.path("a.glintfilm");
    ASSERT_TRUE(saveCheckpoint(film, captured(scene)));
    const auto opened = loadCheckpointScene(film);
    ASSERT_TRUE(opened) << opened.error().format();
    ASSERT_EQ(opened->meshes.size(), 3u);
    for (size_t i = 0; i < 2; ++i) {
        const auto* file = std::get_if<EmbeddedFile>(&opened->meshes[i].source);
        ASSERT_NE(file, nullptr);
        EXPECT_EQ(file->name, "leaf.ply");
        EXPECT_EQ(*file->bytes, kLeafPly);
    }
    EXPECT_EQ(opened->meshes[0].source, opened->meshes[1].source) << "they share their bytes";
    EXPECT_EQ(pathOf(opened->meshes[2].source), "embedded/0-leaf.ply");
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
