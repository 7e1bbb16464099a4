// Scenes read what they use and nothing else, whatever their format; the rest keeps its name, survives
// saving, and is read when an edit uses it, also while the scene renders.
#include "engine/io/used_assets.h"

#include <filesystem>
#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"
#include "engine/render/memory_use.h"
#include "engine/render/render_session.h"
#include "engine/scene/scene_hash.h"
#include "tests/support/render_scene.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Two parts, one with the texture "wall.png"; both have texture coordinates.
constexpr const char* kObj = R"(mtllib room.mtl
v 0 0 0
v 1 0 0
v 0 1 0
v 1 1 0
vt 0 0
vt 4 0
vt 0 4
vt 4 4
usemtl wall
f 1/1 2/2 3/3
usemtl plain
f 2/2 4/4 3/3
)";
constexpr const char* kMtl = R"(newmtl wall
map_Kd wall.png
newmtl plain
Kd 0.5 0.5 0.5
newmtl nobody
map_Kd broken.png
)";

constexpr const char* kPly = R"(ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
property float u
property float v
element face 1
property list uchar int vertex_indices
end_header
0 0 0 0 0
1 0 0 1 0
0 1 0 0 1
3 0 1 2
)";

/// Uses a sphere, a mesh and nothing else of what it names.
constexpr const char* kIdleScene = R"({"glint": 1, "resolution": [24, 16],
  "camera": {"position": [0.4, 0.4, 3], "target": [0.4, 0.4, 0]},
  "textures": {"wall": {"file": "wall.png"}, "same": {"file": "./wall.png", "scale": [2, 2]},
               "broken": {"file": "broken.png"}, "gone": {"file": "gone.png"}},
  "materials": {"grey": {"type": "diffuse"},
                "nobody": {"type": "diffuse", "color": {"texture": "broken"}}},
  "meshes": {"leaf": {"file": "leaf.ply"}, "room": {"file": "room.obj", "part": 1},
             "unplaced": {"file": "broken.ply"}, "blob": {"generator": "blob", "triangleCount": 50000}},
  "objects": [{"type": "sphere", "material": "grey", "center": [2, 2, 0]},
              {"type": "mesh", "mesh": "leaf", "material": "grey"}],
  "lights": [{"type": "directional", "direction": [0.2, -0.3, -1], "irradiance": 3}],
  "environment": {"strength": 0, "image": {"file": "broken.exr"}}
})";

class UsedAssets : public testing::Test {
  protected:
    UsedAssets() {
        Image8 image{64, 32, {}};
        for (size_t i = 0; i < size_t{64} * 32 * 3; ++i) {
            image.rgb.push_back(static_cast<uint8_t>(i * 37 % 251));
        }
        EXPECT_TRUE(savePng(folder.path("wall.png"), image));
        for (const char* name : {"broken.png", "broken.ply", "broken.exr"}) {
            folder.write(name, "not what its name says");
        }
        folder.write("room.obj", kObj);
        folder.write("room.mtl", kMtl);
        folder.write("leaf.ply", kPly);
    }

    SceneDescription load(const std::string& path, LoadCounts* counts = nullptr) const {
        auto scene = loadScene(path, {.counts = counts});
        EXPECT_TRUE(scene.ok()) << scene.error().format();
        return scene ? std::move(*scene) : SceneDescription();
    }
    SceneDescription loadText(const std::string& name, const std::string& text,
                              LoadCounts* counts = nullptr) {
        return load(folder.write(name, text), counts);
    }

    TempFolder folder;
};

constexpr uint64_t kWallBytes = 64 * 32 * 3;

/// Nothing is held that a render would not read.
void expectNothingUnused(const SceneDescription& scene) {
    EXPECT_EQ(unusedMemory(scene, test::buildAll(scene)->features).total(), 0u);
    EXPECT_THAT(lackingAssets(scene), IsEmpty());
}

TEST_F(UsedAssets, AJsonSceneReadsOneMeshOfAllThatItNames) {
    LoadCounts counts;
    const SceneDescription scene = loadText("idle.json", kIdleScene, &counts);
    EXPECT_EQ(counts, (LoadCounts{.meshFiles = 1, .meshFileBytes = std::string(kPly).size()}));
    expectNothingUnused(scene);
    EXPECT_TRUE(scene.meshes[0].data->uvsLeftOut);
    EXPECT_EQ(idleAssets(scene).size(), 3u + 4u + 1u);
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("idle.json:4: \"gone.png\" is missing; nothing uses")));
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
    const SceneDescription scene = loadText("idle.json", kIdleScene);
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

TEST_F(UsedAssets, AnEditReadsWhatItUses) {
    const SceneDescription before = loadText("idle.json", kIdleScene);
    SceneDescription draft = before;
    draft.materials[0].color.texture = 1;
    EXPECT_EQ(lackingAssets(draft).size(), 2u) << "the picture, and the texture coordinates of the leaf";
    const SceneDescription meanwhile = withoutLacking(draft, before);
    EXPECT_EQ(meanwhile.materials[0].color.texture, -1);
    EXPECT_THAT(lackingAssets(meanwhile), IsEmpty());

    const CompletedScene completed = completeScene(draft);
    ASSERT_FALSE(completed.error) << completed.error->format();
    takeAssets(completed.scene, &draft);
    EXPECT_THAT(lackingAssets(draft), IsEmpty());
    EXPECT_EQ(draft.meshes[0].data->uvs, (std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}}));
    EXPECT_FALSE(draft.meshes[2].data || draft.meshes[3].data) << "no object places them";
    EXPECT_FALSE(draft.textures[0].image.isRead()) << "no object has it";
    EXPECT_FALSE(before.textures[1].image.isRead()) << "others keep theirs";

    draft.materials[0].color.texture = 0;  // the same file
    const CompletedScene again = completeScene(draft);
    EXPECT_EQ(again.scene.textures[0].image.bytes, draft.textures[1].image.bytes);
    EXPECT_EQ(pathOf(again.scene.textures[0].image.source), "wall.png");

    // As if it had been so from the beginning.
    ASSERT_TRUE(saveSceneJson(again.scene, folder.path("edited.json")).ok());
    EXPECT_EQ(sceneHash(load(folder.path("edited.json"))), sceneHash(again.scene));
}

TEST_F(UsedAssets, APartOfAnObjFileGetsItsTextureCoordinatesBack) {
    SceneDescription scene = load(folder.path("room.obj"));
    scene.materials[1].color.texture = 0;
    const CompletedScene completed = completeScene(scene);
    ASSERT_FALSE(completed.error) << completed.error->format();
    EXPECT_EQ(completed.scene.meshes[1].data->uvs, (std::vector<Vec2>{{4, 0}, {4, 4}, {0, 4}}));
    EXPECT_EQ(completed.scene.meshes[0].data, scene.meshes[0].data) << "has its own";
}

TEST_F(UsedAssets, AnEditThatUsesABrokenFileChangesNothing) {
    const SceneDescription before = loadText("idle.json", kIdleScene);
    SceneDescription draft = before;
    draft.materials[0].color.texture = 2;
    draft.environment.strength = 1.0f;
    const CompletedScene completed = completeScene(draft);
    ASSERT_TRUE(completed.error);
    EXPECT_THAT(completed.error->format(), HasSubstr("broken.png: is not an image"));
    takeAssets(completed.scene, &draft);
    const SceneDescription kept = withoutLacking(draft, before);
    EXPECT_EQ(kept.materials[0].color.texture, -1);
    EXPECT_EQ(kept.environment.strength, 0.0f);
    EXPECT_THAT(lackingAssets(kept), IsEmpty());

    draft = before;
    draft.materials[0].color.texture = 0;
    std::string moved = kPly;
    moved.replace(moved.find("1 0 0 1 0"), 9, "1 0 5 1 0");
    folder.write("leaf.ply", moved);
    const CompletedScene changed = completeScene(draft);
    ASSERT_TRUE(changed.error);
    EXPECT_THAT(changed.error->format(), HasSubstr("leaf.ply: has changed since the scene was opened"));
    EXPECT_EQ(changed.scene.meshes[0].data, before.meshes[0].data);
}

std::vector<FilmPixel> pixelsAfter(RenderSession& session) {
    EXPECT_EQ(session.wait(120.0), SessionState::Finished) << session.status().error;
    const auto capture = session.capture();
    return capture ? capture->film.pixels() : std::vector<FilmPixel>();
}

bool samePixels(const std::vector<FilmPixel>& a, const std::vector<FilmPixel>& b) {
    return !a.empty() && a.size() == b.size() &&
           std::equal(a.begin(), a.end(), b.begin(), [](const FilmPixel& x, const FilmPixel& y) {
               return x.mean == y.mean && x.luminanceM2 == y.luminanceM2;
           });
}

/// Textures are read and assigned while a session renders, on another thread, and the picture is that of a
/// scene that had them from the beginning. No structure is built again for texture coordinates that came.
TEST_F(UsedAssets, AssignedWhileRenderingTheImageIsTheSame) {
    SceneDescription scene = loadText("idle.json", kIdleScene);
    SessionOptions options;
    options.previews = false;
    options.lowPriority = false;
    options.threads = 2;
    RenderSession session(makeCpuBackend(2), options);
    StopLimits limits;
    limits.passes = 3;
    session.request({.limits = limits});
    session.post({std::make_shared<SceneDescription>(scene), EditKind::Everything});
    const std::vector<FilmPixel> untextured = pixelsAfter(session);
    limits.passes = 1'000'000;
    session.request({.limits = limits});
    for (const int texture : {0, 1, -1, 0}) {
        scene.materials[0].color.texture = texture;
        std::thread([&scene] { takeAssets(completeScene(scene).scene, &scene); }).join();
        session.post({std::make_shared<SceneDescription>(scene), EditKind::Everything});
    }
    limits.passes = 3;
    session.request({.limits = limits});
    session.restart();
    const std::vector<FilmPixel> edited = pixelsAfter(session);
    EXPECT_EQ(session.status().counters.meshBuilds, 1u);

    ASSERT_TRUE(saveSceneJson(scene, folder.path("fresh.json")).ok());
    RenderSession fresh(makeCpuBackend(1), options);
    fresh.request({.limits = limits});
    fresh.post({std::make_shared<SceneDescription>(load(folder.path("fresh.json"))), EditKind::Everything});
    EXPECT_TRUE(samePixels(edited, pixelsAfter(fresh)));
    EXPECT_FALSE(samePixels(edited, untextured));
}

/// Who forgets to read is told so, and the scene before goes on.
TEST_F(UsedAssets, TheBuilderRefusesWhatWasNotRead) {
    const SceneDescription scene = loadText("idle.json", kIdleScene);
    const auto refusal = [&](auto edit) {
        SceneDescription edited = scene;
        edit(&edited);
        RenderSession session(makeCpuBackend(1));
        session.post({std::make_shared<SceneDescription>(edited), EditKind::Everything});
        session.wait(60.0);
        return session.status().error;
    };
    EXPECT_THAT(refusal([](SceneDescription* s) { s->materials[0].color.texture = 0; }),
                HasSubstr("texture 'wall' is used, but has not been read"));
    EXPECT_THAT(refusal([](SceneDescription* s) { s->objects[1].mesh = 3; }),
                HasSubstr("mesh 'blob': an object places it, but its triangles have not been read"));
    EXPECT_THAT(refusal([](SceneDescription* s) { s->environment.strength = 1.0f; }),
                HasSubstr("environment: shines with an image that has not been read"));
}

}  // namespace
}  // namespace glint
