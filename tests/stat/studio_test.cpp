// Models that bring no light get a studio that shows their form.
#include "engine/io/studio.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"
#include "engine/scene/object_box.h"
#include "tests/support/render_scene.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::meanLuminance;
using test::TempFolder;

const std::string kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

SceneDescription cube(const LoadOptions& options = {}) {
    const TempFolder folder;
    auto scene = loadScene(folder.write("cube.obj", kCube), options);
    EXPECT_TRUE(scene) << scene.error().format();
    return scene ? std::move(*scene) : SceneDescription{};
}

/// Of the cube's face that looks along `axis`, in the middle of the picture.
double faceLuminance(SceneDescription scene, const Vec3& axis) {
    scene.resolution = {24, 24};
    scene.camera.position = 4.0f * axis;
    scene.camera.target = Vec3(0.0f);
    return meanLuminance(test::renderFilm(scene, 64), 10, 10, 14, 14).mean;
}

TEST(Studio, FacesOfACubeDiffer) {
    const SceneDescription scene = cube();
    const double front = faceLuminance(scene, {0, 0, 1});
    const double top = faceLuminance(scene, {0, 1, 0});
    const double right = faceLuminance(scene, {1, 0, 0});
    EXPECT_NEAR(front, 0.7, 0.7 * 0.06);
    EXPECT_GT(top, 1.1 * front);
    EXPECT_LT(right, 0.75 * front);
    for (const double face : {front, top}) {
        EXPECT_GT(face, 1.2 * 0.35);  // the background's radiance
    }
}

TEST(Studio, TheGroundCatchesTheShadow) {
    const SceneDescription with = cube();
    SceneDescription without = with;
    std::erase_if(without.objects, [](const Object& object) { return object.shape == ShapeKind::Mesh; });
    const auto ground = [](SceneDescription scene, const Vec3& at) {
        scene.resolution = {8, 8};
        scene.camera.verticalFovDeg = 2.0f;
        scene.camera.position = Vec3(8, 8, -8);
        scene.camera.target = at;
        return meanLuminance(test::renderFilm(scene, 256)).mean;
    };
    const Vec3 behind(0, -1, -1.3f);  // away from the key light
    EXPECT_LT(ground(with, behind), 0.7 * ground(without, behind));
    EXPECT_NEAR(ground(without, behind), 0.35, 0.03);  // as the background, without a horizon
}

TEST(Studio, IsSwitchedOffAndOn) {
    SceneDescription scene = cube({.noStudio = true});
    EXPECT_FALSE(hasStudio(scene));
    EXPECT_EQ(scene.environment.image, -1);
    addStudio(&scene);
    EXPECT_TRUE(hasStudio(scene));
    EXPECT_EQ(sceneBounds(scene).lo, Vec3(-1.0f)) << "the ground is no part of what is framed";
    removeStudio(&scene);
    EXPECT_FALSE(hasStudio(scene));
    EXPECT_EQ(scene.objects.size(), 1u);
    EXPECT_TRUE(scene.environment.emissive());
}

TEST(Studio, IsSavedAndLeftOutWhereThereIsLight) {
    const TempFolder folder;
    const auto scene = loadScene(folder.write("cube.obj", kCube));
    ASSERT_TRUE(scene);
    ASSERT_TRUE(saveSceneJson(*scene, folder.path("cube.json")));
    const auto loaded = loadScene(folder.path("cube.json"));
    ASSERT_TRUE(loaded) << loaded.error().format();
    EXPECT_TRUE(hasStudio(*loaded));
    folder.write("lit.mtl", "newmtl l\nKe 1 1 1\n");
    const auto lit =
        loadScene(folder.write("lit.obj", "mtllib lit.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl l\nf 1 2 3\n"));
    ASSERT_TRUE(lit);
    EXPECT_FALSE(hasStudio(*lit));
    EXPECT_FALSE(lit->environment.emissive());
}

}  // namespace
}  // namespace glint
