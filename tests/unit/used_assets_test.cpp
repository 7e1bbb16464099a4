// Scenes read what they use and nothing else, whatever their format; the rest keeps its name and
// survives saving.
#include "engine/io/used_assets.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scene_json.h"
#include "engine/render/memory_use.h"
#include "engine/scene/scene_hash.h"
#include "tests/support/render_scene.h"
#include "tests/support/used_assets.h"

namespace glint {
namespace {

using test::UsedAssets;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr uint64_t kWallBytes = 64 * 32 * 3;

/// Nothing is held that a render would not read.
void expectNothingUnused(const SceneDescription& scene) {
    EXPECT_EQ(unusedMemory(scene, test::buildAll(scene)->features).total(), 0u);
    EXPECT_THAT(lackingAssets(scene), IsEmpty());
}

TEST_F(UsedAssets, AJsonSceneReadsOneMeshOfAllThatItNames) {
    LoadCounts counts;
    const SceneDescription scene = loadText("idle.json", test::kIdleScene, &counts);
    EXPECT_EQ(counts, (LoadCounts{.meshFiles = 1, .meshFileBytes = std::string(test::kLeafPly).size()}));
    expectNothingUnused(scene);
    EXPECT_TRUE(scene.meshes[0].data->uvsLeftOut);
    EXPECT_EQ(idleAssets(scene).size(), 3u + 4u + 1u);
    EXPECT_THAT(scene.warnings,
                ElementsAre(HasSubstr("idle.json:4: files are missing that nothing uses: \"gone.png\"")));
}

TEST_F(UsedAssets, AnObjSceneReadsTheTexturesOfItsFaces) {
    LoadCounts counts;
    const SceneDescription scene = load(folder.path("room.obj"), &counts);
    EXPECT_EQ(counts.meshFiles, 1u);
    EXPECT_EQ(counts.imageFiles, 1u) << "the third material has no face";
    EXPECT_EQ(counts.pixelBytes, kWallBytes);
    expectNothingUnused(scene);
    EXPECT_EQ(scene.meshes[0].data->uvs.size(), 3u);
    EXPECT_TRUE(scene.meshes[1].data->uvs.empty() && scene.meshes[1].data->uvsLeftOut);
}

TEST_F(UsedAssets, ATextSceneLeavesTheMaterialsOfItsMeshesAlone) {
    folder.write("room.mtl", "newmtl wall\nKd this is no number\n");
    LoadCounts counts;
    const SceneDescription scene = loadText("room.txt", R"(
Materials { numMaterials 2
    Material { diffuseColor 1 1 1 texture broken.png }
    Material { diffuseColor 1 1 1 texture wall.png } }
Group { numObjects 1 MaterialIndex 1 TriangleMesh { obj_file room.obj } })",
                                            &counts);
    EXPECT_EQ(counts.imageFiles, 1u);
    EXPECT_EQ(counts.meshFiles, 1u);
    expectNothingUnused(scene);
    EXPECT_EQ(scene.meshes[1].data->uvs.size(), 3u) << "the whole mesh has the texture";
}

TEST_F(UsedAssets, AFileThatIsNamedSeveralTimesIsReadOnce) {
    LoadCounts counts;
    const SceneDescription scene = loadText("twice.json", R"({"glint": 1,
      "textures": {"a": {"file": "wall.png"}, "b": {"file": "./wall.png", "flipV": true}},
      "materials": {"a": {"type": "diffuse", "color": {"texture": "a"}},
                    "b": {"type": "diffuse", "color": {"texture": "b"}}},
      "meshes": {"m": {"file": "leaf.ply"}, "n": {"file": "./leaf.ply"}},
      "objects": [{"type": "mesh", "mesh": "m", "material": "a"}, {"type": "mesh", "mesh": "n", "material": "b"},
                  {"type": "mesh", "mesh": {"file": "room.obj"}},
                  {"type": "mesh", "mesh": {"file": "room.obj", "part": 1}, "material": "b"}]})",
                                            &counts);
    EXPECT_EQ(counts.imageFiles, 1u);
    EXPECT_EQ(counts.pixelBytes, kWallBytes);
    EXPECT_EQ(counts.meshFiles, 2u);
    EXPECT_EQ(scene.textures[0].image.bytes, scene.textures[1].image.bytes);
    EXPECT_EQ(scene.textures[0].image.bytes, scene.textures[2].image.bytes) << "the OBJ file's own";
    EXPECT_EQ(scene.meshes[0].data, scene.meshes[1].data);
    EXPECT_EQ(scene.meshes[3].data, scene.meshes[4].data);
    EXPECT_EQ(scene.meshes[4].data->uvs.size(), 3u) << "one of its two objects needs them";
    expectNothingUnused(scene);
}

TEST_F(UsedAssets, TheScenesOfTheProjectHoldNothingUnused) {
    int read = 0;
    for (const auto& entry : std::filesystem::directory_iterator(std::string(GLINT_SOURCE_DIR) + "/scenes")) {
        if (entry.path().extension() == ".json" && entry.path().stem().extension().empty()) {
            SCOPED_TRACE(entry.path().string());
            const SceneDescription scene = load(entry.path().string());
            expectNothingUnused(scene);
            EXPECT_THAT(idleAssets(scene), IsEmpty()) << "and name nothing in vain";
            ++read;
        }
    }
    EXPECT_GE(read, 12);
}

TEST_F(UsedAssets, WhatIsUsedIsAnErrorAtItsPlace) {
    const auto errorOf = [&](const std::string& objects) {
        const auto scene = loadScene(folder.write("used.json", std::string(R"({"glint": 1,
"textures": {"broken": {"file": "broken.png"}, "gone": {"file": "gone.png"}},
"meshes": {"broken": {"file": "broken.ply"}, "gone": {"file": "gone.ply"}, "part": {"file": "room.obj", "part": 9}},
"materials": {"a": {"type": "diffuse", "color": {"texture": "broken"}},
              "b": {"type": "diffuse", "color": {"texture": "gone"}}, "c": {"type": "diffuse"}},
"objects": [)") + objects + "]}"));
        return scene ? "no error" : scene.error().format();
    };
    EXPECT_THAT(errorOf(R"({"type": "sphere", "material": "a"})"), HasSubstr("broken.png: is not an image"));
    EXPECT_THAT(errorOf(R"({"type": "sphere", "material": "b"})"),
                HasSubstr("used.json:2:65: the file \"gone.png\""));
    EXPECT_THAT(errorOf(R"({"type": "mesh", "mesh": "broken", "material": "c"})"),
                HasSubstr("broken.ply:1:1"));
    EXPECT_THAT(errorOf(R"({"type": "mesh", "mesh": "gone", "material": "c"})"),
                HasSubstr("used.json:3:54: the file \"gone.ply\""));
    EXPECT_THAT(errorOf(R"({"type": "mesh", "mesh": "part", "material": "c"})"),
                HasSubstr("there is no part 9"));
    EXPECT_EQ(errorOf(R"({"type": "sphere", "material": "c"})"), "no error");
}

TEST_F(UsedAssets, SavingKeepsWhatWasNotRead) {
    const SceneDescription scene = loadText("idle.json", test::kIdleScene);
    std::filesystem::create_directory(folder.path("below"));
    ASSERT_TRUE(saveSceneJson(scene, folder.path("below/saved.json")).ok());
    const SceneDescription saved = load(folder.path("below/saved.json"));
    ASSERT_EQ(saved.textures.size(), scene.textures.size());
    ASSERT_EQ(saved.meshes.size(), scene.meshes.size());
    EXPECT_EQ(pathOf(saved.textures[2].image.source), "../broken.png");
    EXPECT_EQ(saved.materials[1].color.texture, 2);
    EXPECT_EQ(pathOf(saved.meshes[2].source), "../broken.ply");
    EXPECT_EQ(std::get<MeshGenerator>(saved.meshes[3].source).triangles, 50000u);
    EXPECT_EQ(pathOf(saved.environmentImages.at(0).source), "../broken.exr");
    EXPECT_EQ(sceneHash(saved), sceneHash(scene));
}

/// The textures of an OBJ file are found from the scene's folder, wherever it is saved.
TEST_F(UsedAssets, ASavedObjSceneFindsItsTextures) {
    const SceneDescription scene = load(folder.path("room.obj"));
    EXPECT_EQ(pathOf(scene.textures.at(0).image.source), "wall.png");
    const SceneDescription relative = load(std::filesystem::relative(folder.path("room.obj")).string());
    EXPECT_EQ(pathOf(relative.textures.at(0).image.source), "wall.png");
    std::filesystem::create_directory(folder.path("below"));
    ASSERT_TRUE(saveSceneJson(scene, folder.path("below/saved.json")).ok());
    LoadCounts counts;
    const SceneDescription saved = load(folder.path("below/saved.json"), &counts);
    EXPECT_EQ(pathOf(saved.textures.at(0).image.source), "../wall.png");
    EXPECT_EQ(counts.imageFiles, 1u);
    EXPECT_EQ(sceneHash(saved), sceneHash(scene));
    const SceneDescription outer =
        loadText("below/outer.json",
                 R"({"glint": 1, "objects": [{"type": "mesh", "mesh": {"file": "../room.obj"}}]})");
    EXPECT_EQ(pathOf(outer.textures.at(0).image.source), "../wall.png");
    EXPECT_TRUE(outer.textures[0].image.isRead());
}

}  // namespace
}  // namespace glint
