// Objects that are hidden: kept in scenes, files and checkpoints, and no part of what is read, built
// and exported.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/builders/instance_builder.h"
#include "engine/io/exporter.h"
#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"
#include "engine/io/used_assets.h"
#include "engine/scene/scene_diff.h"
#include "engine/scene/scene_hash.h"
#include "tests/support/obj_square.h"
#include "tests/support/render_scene.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kBall =
    R"({"type": "sphere", "name": "ball", "material": "grey", "center": [0, 1, 0], "radius": 1})";
constexpr const char* kHiddenBall = R"({"hidden": true, "type": "sphere", "name": "second", "material": "red",
    "center": [2, 1, 0], "radius": 0.5})";
constexpr const char* kHiddenMesh = R"({"type": "mesh", "name": "far", "hidden": true, "material": "red",
    "mesh": {"file": "square.obj"}})";

std::string sceneOf(const std::string& objects) {
    return R"({"glint": 1, "resolution": [16, 12], "camera": {"position": [0, 1, 4], "target": [0, 1, 0]},
        "materials": {"grey": {"type": "diffuse"}, "red": {"type": "diffuse", "color": [0.8, 0.1, 0.1]}},
        "objects": [)" +
           objects + R"(], "environment": {"color": 1}})";
}

std::vector<std::string> namesOf(const std::vector<Object>& objects) {
    std::vector<std::string> names;
    std::ranges::transform(objects, std::back_inserter(names), &Object::name);
    return names;
}

class HiddenObjects : public ::testing::Test {
  protected:
    void SetUp() override { folder.write("square.obj", test::kCorners + "f 1 2 3 4\n"); }
    SceneDescription sceneFrom(const std::string& objects) {
        folder.write("scene.json", sceneOf(objects));
        auto scene = loadScene(folder.path("scene.json"));
        EXPECT_TRUE(scene) << scene.error().format();
        return scene ? *scene : SceneDescription();
    }
    SceneDescription several() {
        return sceneFrom(std::string(kHiddenMesh) + ", " + kBall + ", " + kHiddenBall);
    }
    test::TempFolder folder;
};

TEST_F(HiddenObjects, AreNeitherReadNorBuiltNorInTheFingerprint) {
    const SceneDescription scene = several();
    EXPECT_THAT(namesOf(scene.objects), ElementsAre("ball"));
    EXPECT_THAT(namesOf(scene.hiddenObjects), ElementsAre("far", "second"));
    EXPECT_FALSE(scene.meshes[0].data) << "what nothing shows stays on the disk";
    const auto built = test::buildAll(scene);
    EXPECT_EQ(built->instances->instances.size(), 1u);
    SceneDescription without = scene;
    without.hiddenObjects.clear();
    EXPECT_EQ(sceneHash(scene), sceneHash(without));
    EXPECT_EQ(differences(scene, without), EditKind::None);
    EXPECT_FALSE(sameUnseen(scene, without));
    EXPECT_TRUE(sameUnseen(scene, SceneDescription(scene)));
}

TEST_F(HiddenObjects, AreSavedAsTheyAre) {
    const SceneDescription scene = several();
    const std::string path = folder.path("saved.json");
    ASSERT_TRUE(saveSceneJson(scene, path));
    const auto again = loadScene(path);
    ASSERT_TRUE(again) << again.error().format();
    EXPECT_THAT(namesOf(again->objects), ElementsAre("ball"));
    EXPECT_THAT(namesOf(again->hiddenObjects), ElementsAre("far", "second"));
    for (size_t i = 0; i < scene.hiddenObjects.size(); ++i) {
        const Object &before = scene.hiddenObjects[i], &after = again->hiddenObjects[i];
        EXPECT_EQ(after.objectToWorld, before.objectToWorld);
        EXPECT_EQ(after.material, before.material);
        EXPECT_EQ(after.mesh, before.mesh);
    }
    EXPECT_EQ(sceneHash(scene), sceneHash(*again));
}

TEST_F(HiddenObjects, AllPartsOfAMeshFileAreHiddenTogether) {
    const SceneDescription scene = sceneFrom(
        std::string(kBall) + R"(, {"type": "mesh", "hidden": true, "mesh": {"file": "square.obj"}})");
    EXPECT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(scene.hiddenObjects.size(), scene.meshes.size());
    EXPECT_FALSE(scene.hiddenObjects.empty());
}

TEST_F(HiddenObjects, AFalseWordShowsAndAWrongOneIsAnError) {
    std::string shown = kHiddenBall;
    shown.replace(shown.find("true"), 4, "false");
    EXPECT_EQ(sceneFrom(shown).objects.size(), 1u);
    shown.replace(shown.find("false"), 5, "7");
    folder.write("wrong.json", sceneOf(shown));
    const auto wrong = loadScene(folder.path("wrong.json"));
    ASSERT_FALSE(wrong);
    EXPECT_THAT(wrong.error().format(),
                HasSubstr("wrong.json:3:32: \"hidden\" is 7; expected true or false"));
}

TEST_F(HiddenObjects, ExportsLeaveThemOutAndSaySo) {
    for (const char* name : {"out.gltf", "out.xml", "out.pbrt"}) {
        const std::string path = folder.path(name);
        std::vector<std::string> warnings;
        ASSERT_TRUE(exporterOf(path)->save(several(), path, &warnings)) << name;
        EXPECT_THAT(warnings, Contains("left out: hidden objects")) << name;
        const auto opened = loadScene(path, {.noStudio = true});
        ASSERT_TRUE(opened) << opened.error().format();
        EXPECT_EQ(opened->objects.size(), 1u) << name;
    }
    std::vector<std::string> warnings;
    const std::string path = folder.path("out.json");
    ASSERT_TRUE(exporterOf(path)->save(several(), path, &warnings));
    EXPECT_TRUE(warnings.empty());
    EXPECT_EQ(loadScene(path)->hiddenObjects.size(), 2u);
}

TEST_F(HiddenObjects, MeshesThatAreShownAreReadFirst) {
    const SceneDescription before = several();
    SceneDescription shown = before;
    std::ranges::move(shown.hiddenObjects, std::back_inserter(shown.objects));
    shown.hiddenObjects.clear();
    const SceneDescription meanwhile = withoutLacking(shown, before);
    EXPECT_THAT(namesOf(meanwhile.objects), ElementsAre("ball", "second"));
    EXPECT_THAT(namesOf(meanwhile.hiddenObjects), ElementsAre("far"));
    const CompletedScene complete = completeScene(shown);
    ASSERT_FALSE(complete.error) << complete.error->format();
    EXPECT_TRUE(complete.scene.meshes[0].data);
    EXPECT_THAT(namesOf(withoutLacking(complete.scene, before).objects),
                ElementsAre("ball", "far", "second"));
}

}  // namespace
}  // namespace glint
