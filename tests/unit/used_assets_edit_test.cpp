// What a scene has not read is read when an edit uses it, also while the scene renders.
#include <algorithm>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scene_json.h"
#include "engine/io/used_assets.h"
#include "engine/render/render_session.h"
#include "engine/scene/scene_hash.h"
#include "tests/support/used_assets.h"

namespace glint {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

using UsedAssetsEdit = test::UsedAssets;

TEST_F(UsedAssetsEdit, AnEditReadsWhatItUses) {
    const SceneDescription before = loadText("idle.json", test::kIdleScene);
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

TEST_F(UsedAssetsEdit, APartOfAnObjFileGetsItsTextureCoordinatesBack) {
    SceneDescription scene = load(folder.path("room.obj"));
    scene.materials[1].color.texture = 0;
    const CompletedScene completed = completeScene(scene);
    ASSERT_FALSE(completed.error) << completed.error->format();
    EXPECT_EQ(completed.scene.meshes[1].data->uvs, (std::vector<Vec2>{{4, 0}, {4, 4}, {0, 4}}));
    EXPECT_EQ(completed.scene.meshes[0].data, scene.meshes[0].data) << "has its own";
}

TEST_F(UsedAssetsEdit, AnEditThatUsesABrokenFileChangesNothing) {
    const SceneDescription before = loadText("idle.json", test::kIdleScene);
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
    std::string moved = test::kLeafPly;
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
TEST_F(UsedAssetsEdit, AssignedWhileRenderingTheImageIsTheSame) {
    SceneDescription scene = loadText("idle.json", test::kIdleScene);
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
TEST_F(UsedAssetsEdit, TheBuilderRefusesWhatWasNotRead) {
    const SceneDescription scene = loadText("idle.json", test::kIdleScene);
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
