// Models that bring no light get a studio that shows their form.
#include "engine/io/studio.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
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
    EXPECT_NEAR(front, 0.52, 0.52 * 0.06);
    EXPECT_GT(top, 1.1 * front);
    EXPECT_LT(right, 0.75 * front);
    for (const double face : {front, top}) {
        EXPECT_GT(face, 1.2 * 0.26);  // the background's radiance
    }
}

TEST(Studio, FacesOfAWhiteCubeDifferAndAreNotClipped) {
    SceneDescription scene = cube();
    scene.materials[0].color.value = Vec3(1.0f);
    double last = 0.0;
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, 1, 0)}) {
        const double face = faceLuminance(scene, axis);
        EXPECT_GT(face, 1.1 * last);
        EXPECT_LT(face, 1.0);
        last = face;
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
    EXPECT_NEAR(ground(without, behind), 0.26, 0.025);  // as the background, without a horizon
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

/// A cube with a small quad over its top, of the material that is given.
bool bringsItsLight(const std::string& emission, const std::string& quad) {
    const TempFolder folder;
    folder.write("m.mtl", "newmtl l\nKd 0 0 0\n" + emission);
    EXPECT_TRUE(savePng(folder.path("label.png"), {1, 1, {255, 255, 255}}));
    const auto scene =
        loadScene(folder.write("in.obj", "mtllib m.mtl\n" + kCube + quad + "usemtl l\nf -4 -3 -2 -1\n"));
    EXPECT_TRUE(scene) << scene.error().format();
    return scene && !hasStudio(*scene);
}

TEST(Studio, LightsModelsWhoseOwnLightsAreFaintOrSmall) {
    const std::string diode = "v 0 1.1 0\nv 0 1.1 .1\nv .1 1.1 .1\nv .1 1.1 0\n";
    const std::string ceiling = "v -2 4 -2\nv 2 4 -2\nv 2 4 2\nv -2 4 2\n";
    const std::string point = "v 0 2 0\nv 0 2 0\nv 0 2 0\nv 0 2 0\n";
    EXPECT_FALSE(bringsItsLight("Ke .3 0 0\n", diode));
    EXPECT_FALSE(bringsItsLight("Ke 1 1 1\n", diode));
    EXPECT_FALSE(bringsItsLight("Ke .02 .02 .02\n", ceiling));
    EXPECT_FALSE(bringsItsLight("Ke 50 50 50\n", point)) << "has no area";
    EXPECT_TRUE(bringsItsLight("Ke 1.5 0 0\n", diode)) << "a lamp";
    EXPECT_TRUE(bringsItsLight("Ke .9 .9 .9\n", ceiling));
    EXPECT_FALSE(bringsItsLight("Ke 0 0 0\n", ceiling));
    EXPECT_FALSE(bringsItsLight("Ke .9 .9 .9\nmap_Ke label.png\n", ceiling)) << "a label or a screen";
    EXPECT_TRUE(bringsItsLight("Ke 1.5 1.5 1.5\nmap_Ke label.png\n", ceiling)) << "a lamp with an image";
}

}  // namespace
}  // namespace glint
