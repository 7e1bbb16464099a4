// The same film to the last bit: for 1, 2 and 3 threads, over capture and resume, through the session, and
// from a scene that was saved and loaded again.
#include <filesystem>

#include <gtest/gtest.h>

#include "engine/builders/scene_builder.h"
#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"
#include "engine/render/pass_params.h"
#include "engine/render/path_pass.h"
#include "engine/render/render_session.h"
#include "tests/support/film_bits.h"
#include "tests/support/temp_folder.h"
#include "tests/support/test_scenes.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr uint32_t kPasses = 3;
const std::atomic<bool> kNever{false};

TEST(FilmIdentity, OneTwoAndThreeThreadsOnEveryTestScene) {
    for (const test::NamedScene& named : test::allTestScenes()) {
        SCOPED_TRACE(named.name);
        const Film one = test::renderPasses(named.scene, kPasses, 1);
        test::expectSameBits(one, test::renderPasses(named.scene, kPasses, 2));
        test::expectSameBits(one, test::renderPasses(named.scene, kPasses, 3));
    }
}

TEST(FilmIdentity, TheSessionAddsNothingAndResumesExactly) {
    const auto scene = std::make_shared<SceneDescription>(test::cornellBox());
    const Film direct = test::renderPasses(*scene, kPasses, 2);

    RenderSession first(makeCpuBackend(2));
    first.request({.limits = {.passes = 1}, .aovs = kAovAlbedo, .standardError = true});
    first.post({scene, EditKind::Everything});
    ASSERT_EQ(first.wait(300.0), SessionState::Finished);
    auto half = first.capture();
    ASSERT_TRUE(half.has_value());

    RenderSession second(makeCpuBackend(3));
    second.request({.limits = {.passes = kPasses}});
    second.resume(scene, {.film = std::move(half->film), .renderSeconds = half->renderSeconds});
    ASSERT_EQ(second.wait(300.0), SessionState::Finished);
    const auto whole = second.capture();
    ASSERT_TRUE(whole.has_value());
    test::expectSameBits(direct, whole->film);
}

TEST(FilmIdentity, OurScenesSavedAndLoadedAgain) {
    for (const auto& entry : fs::directory_iterator(GLINT_SOURCE_DIR "/scenes")) {
        const fs::path& path = entry.path();
        if (path.extension() == ".json" && path.stem().extension() != ".schema") {
            test::expectSameFilmWhenSaved(path.string());
        }
    }
}

TEST(FilmIdentity, TextScenesAndObjFilesSavedAndLoadedAgain) {
    for (const auto& entry : fs::directory_iterator(GLINT_SOURCE_DIR "/tests/data/film")) {
        if (entry.path().extension() == ".txt" || entry.path().extension() == ".obj") {
            test::expectSameFilmWhenSaved(entry.path().string());
        }
    }
}

TEST(FilmIdentity, WhatTextsAndModelsHoldIsEditableJsonWithTheSameFilm) {
    const test::TempFolder folder;
    test::expectSameFilmWhenSaved(folder.write("lights.txt", R"(
PerspectiveCamera { center 0 2 9 direction 0 -0.2 -1 up 0.1 1 0 angle 45 width 40 height 30 focalLength 9 aperture 0.2 }
Background { color 0.1 0.2 0.3 }
Lights { numLights 2 PointLight { position 3 5 4 color 1 1 1 } DirectionalLight { direction -1 -1 0 color 0.3 0.2 0.1 } }
Materials { numMaterials 2 Material { color 0.8 0.7 0.6 } Material { type 0.5 0.3 0.2 refr 1.4 } }
Group { numObjects 4 Plane { normal 0 1 0 offset 0 } MaterialIndex 1
    Transform { Translate -1 0 0 YRotate 30 Scale 1 1.5 1 RevSurface { profile BsplineCurve {
        controls [ 0 0 0 ] [ 0.8 0 0 ] [ 0.6 1 0 ] [ 0.4 1.5 0 ] [ 0.5 2 0 ] } } }
    Transform { Matrix4f { 1 0 0 0  0.3 1 0 0  0 0 1 0  1 1 0 1 } Sphere { center 0 0 0 radius 0.7 } }
    Triangle { vertex0 -2 0 -2 vertex1 2 0 -2 vertex2 0 3 -2 } })"));
    folder.write("room.mtl",
                 "newmtl floor\nKd 0.7 0.6 0.5\nnewmtl lamp\nKd 0 0 0\nKe 10 9 8\nnewmtl unused\n");
    const std::string model = folder.write("room.obj",
                                           "mtllib room.mtl\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\n"
                                           "v -0.3 1.9 -0.3\nv 0.3 1.9 -0.3\nv 0.3 1.9 0.3\nv -0.3 1.9 "
                                           "0.3\nusemtl floor\nf 4 3 2 1\nusemtl lamp\nf 5 6 7 8\n");
    test::expectSameFilmWhenSaved(model);
    const auto opened = loadScene(model);
    ASSERT_TRUE(opened && saveSceneJson(*opened, folder.path("room.json")));
    const auto scene = loadScene(folder.path("room.json"));
    ASSERT_TRUE(scene) << scene.error().format();
    ASSERT_EQ(scene->materials.size(), 2u) << "one for each that faces have";
    EXPECT_EQ(scene->materials[1].name, "lamp");
    EXPECT_EQ(scene->materials[1].emission.value, Vec3(10, 9, 8));
    EXPECT_EQ(scene->meshes[0].data->triangleCount(), 2u) << "the quad";
}

TEST(FilmIdentity, AStoppedPassLeavesNoTrace) {
    const SceneDescription scene = test::cornellBox();
    const auto built = buildScene({std::make_shared<SceneDescription>(scene), EditKind::Everything}, nullptr,
                                  2, nullptr, nullptr);
    ASSERT_TRUE(built.ok());
    const auto backend = makeCpuBackend(2);
    ASSERT_TRUE(backend->setScene(*built).ok());
    const std::atomic<bool> stopped{true};
    std::vector<PixelSample> samples;
    EXPECT_FALSE(*renderPathPass(*backend, passParamsOf(scene), stopped, &samples));
    EXPECT_FALSE(renderPathPass(*makeCpuBackend(1), passParamsOf(scene), kNever, &samples).ok())
        << "there is no scene";
}

}  // namespace
}  // namespace glint
