// Images and meshes that stand in memory, as another file brought them: each is read once and by the same
// readers as files, and a saved scene finds them again.
#include "engine/io/embedded_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"
#include "engine/io/used_assets.h"
#include "engine/scene/scene_hash.h"
#include "tests/support/used_assets.h"

namespace glint {
namespace {

using test::TempFolder;
using testing::HasSubstr;

EmbeddedFile embedded(std::string name, std::string bytes) {
    return {std::move(name), std::make_shared<const std::string>(std::move(bytes))};
}

std::string pngBytes() {
    const TempFolder folder;
    const std::string path = folder.path("a.png");
    EXPECT_TRUE(savePng(path, {2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 99, 199}}));
    return TempFolder::read(path);
}

/// Two triangles of one mesh file and two textures of one image file, which is the environment too.
SceneDescription sceneInMemory(const std::string& path) {
    SceneDescription scene;
    scene.path = path;
    const EmbeddedFile image = embedded("wood.png", pngBytes());
    const EmbeddedFile mesh = embedded("leaf.ply", test::kLeafPly);
    for (int i = 0; i < 2; ++i) {
        scene.textures.push_back(
            {.name = "wood", .image = {image}, .scale = Vec2(1.0f + static_cast<float>(i))});
        scene.materials.emplace_back();
        scene.materials.back().color.texture = i;
        scene.meshes.push_back({"leaf", mesh, nullptr});
        Object object;
        object.shape = ShapeKind::Mesh;
        object.mesh = object.material = i;
        scene.objects.push_back(object);
    }
    scene.environmentImages.push_back({image});
    scene.environment = {.color = Vec3(1.0f), .image = 0};
    return scene;
}

TEST(EmbeddedFiles, AreReadOnceLikeFilesOnTheDisk) {
    const TempFolder folder;
    SceneDescription scene = sceneInMemory(folder.path("scene.json"));
    EXPECT_EQ(lackingAssets(scene).size(), 5u);
    LoadCounts counts;
    AssetCache assets(scene.path, &counts);
    const Status read = readUsedAssets(&assets, &scene);
    ASSERT_TRUE(read) << read.error().format();
    EXPECT_EQ(counts.meshFiles, 1u);
    EXPECT_EQ(counts.meshFileBytes, std::string(test::kLeafPly).size());
    EXPECT_EQ(counts.imageFiles, 2u) << "the texture, and the environment, whose values are light";
    EXPECT_EQ(scene.meshes[0].data, scene.meshes[1].data);
    EXPECT_EQ(scene.textures[0].image.bytes, scene.textures[1].image.bytes);
    EXPECT_EQ(scene.textures[0].image.bytes->rgb[11], 199);
    ASSERT_NE(scene.environmentImages[0].bytes, nullptr) << "8-bit pictures stay in bytes";
    EXPECT_EQ(scene.environmentImages[0].bytes->rgb[0], 255);
    EXPECT_EQ(scene.meshes[0].data->uvs.size(), 3u);
    EXPECT_TRUE(std::holds_alternative<EmbeddedFile>(scene.textures[0].image.source)) << "keeps its name";
}

TEST(EmbeddedFiles, ThatAreBrokenAreNamed) {
    const TempFolder folder;
    SceneDescription scene = sceneInMemory(folder.path("scene.json"));
    scene.meshes[0].source = embedded("stone.ply", "ply\nformat none\n");
    const CompletedScene completed = completeScene(scene);
    ASSERT_TRUE(completed.error);
    EXPECT_THAT(completed.error->format(), HasSubstr("stone.ply in " + folder.path("scene.json") + ":2"));
    scene = sceneInMemory(folder.path("scene.json"));
    scene.textures[0].image.source = embedded("bark.png", pngBytes().substr(0, 40));
    EXPECT_THAT(completeScene(scene).error->format(), HasSubstr("bark.png in "));
}

TEST(EmbeddedFiles, StandBesideASavedScene) {
    const TempFolder folder;
    const CompletedScene whole = completeScene(sceneInMemory(folder.path("model.json")));
    ASSERT_FALSE(whole.error) << whole.error->format();
    std::filesystem::create_directory(folder.path("saved"));
    folder.write("saved/wood.png", "somebody else's");
    const std::string path = folder.path("saved/scene.json");
    for (int save = 0; save < 2; ++save) {  // the second one finds its files
        ASSERT_TRUE(saveSceneJson(whole.scene, path).ok());
        EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path("saved")), {}), 4);
    }
    EXPECT_EQ(TempFolder::read(folder.path("saved/wood.png")), "somebody else's");
    EXPECT_EQ(TempFolder::read(folder.path("saved/wood-2.png")), pngBytes());
    EXPECT_EQ(TempFolder::read(folder.path("saved/leaf.ply")), test::kLeafPly);
    const auto saved = loadScene(path);
    ASSERT_TRUE(saved) << saved.error().format();
    EXPECT_EQ(pathOf(saved->textures[0].image.source), "wood-2.png");
    EXPECT_EQ(sceneHash(*saved), sceneHash(whole.scene));
}

TEST(EmbeddedFiles, ThatNothingUsesAreSavedUnread) {
    const TempFolder folder;
    SceneDescription scene = sceneInMemory(folder.path("scene.json"));
    scene.objects.clear();
    scene.environment.image = -1;
    EXPECT_TRUE(lackingAssets(scene).empty());
    ASSERT_TRUE(saveSceneJson(scene, scene.path).ok());
    EXPECT_EQ(TempFolder::read(folder.path("wood.png")), pngBytes());
    EXPECT_EQ(TempFolder::read(folder.path("leaf.ply")), test::kLeafPly);
}

/// A name from a foreign file does not lead out of the scene's folder.
TEST(EmbeddedFiles, StayInTheScenesFolder) {
    const TempFolder folder;
    std::filesystem::create_directory(folder.path("below"));
    for (const char* name : {"../../evil.png", "/evil.png", "..", ""}) {
        SceneDescription scene;
        scene.path = folder.path("below/scene.json");
        scene.textures.push_back({.name = "t", .image = {embedded(name, pngBytes() + name)}});
        ASSERT_TRUE(writeEmbeddedFiles(&scene, scene.path)) << name;
        const std::string written = pathOf(scene.textures[0].image.source);
        EXPECT_EQ(written.find('/'), std::string::npos) << written;
        EXPECT_TRUE(std::filesystem::is_regular_file(folder.path("below/" + written))) << written;
    }
    EXPECT_EQ(folder.size(), 1u);
}

TEST(EmbeddedFiles, TextAloneRefusesThem) {
    const auto text = writeSceneJson(sceneInMemory("scene.json"), "scene.json");
    ASSERT_FALSE(text);
    EXPECT_THAT(text.error().message, HasSubstr("not from a file"));
}

}  // namespace
}  // namespace glint
