// Glint JSON: what the format means, by reading small scenes.
#include "engine/io/scene_json.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/builders/camera_builder.h"
#include "engine/io/scene_loader.h"

namespace glint {
namespace {

using testing::HasSubstr;

Result<SceneDescription> read(std::string text) { return readSceneJson({"scene.json", std::move(text)}, {}); }

SceneDescription mustRead(const std::string& text) {
    auto scene = read(text);
    EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().format());
    return scene.ok() ? std::move(*scene) : SceneDescription();
}

TEST(SceneJson, EmptySceneHasTheDefaults) {
    const SceneDescription scene = mustRead(R"({"glint": 1})");
    EXPECT_EQ(scene.resolution, Resolution());
    EXPECT_EQ(scene.options, RenderOptions());
    EXPECT_TRUE(scene.objects.empty());
    EXPECT_FALSE(scene.environment.emissive());
}

TEST(SceneJson, AnIntegratorHasAnAlias) {
    for (const char* name : {"path", "pt"}) {
        const SceneDescription scene =
            mustRead(fmt::format(R"({{"glint": 1, "render": {{"integrator": "{}"}}}})", name));
        EXPECT_EQ(scene.options.integrator, IntegratorKind::PathTracing);
        EXPECT_NE(writeSceneJson(scene, "scene.json").value().find("\"path\""), std::string::npos)
            << "one name is written";
    }
}

TEST(SceneJson, CommentsAndEscapesAreRead) {
    const SceneDescription scene =
        mustRead("// first\n{/* a */\"glint\": 1, \"title\": \"\\u00e9\\ud83d\\ude00\\n\"}\n// end");
    EXPECT_EQ(scene.title, "\xC3\xA9\xF0\x9F\x98\x80\n");
}

TEST(SceneJson, CameraFocusesOnItsTargetUnlessTold) {
    const SceneDescription scene = mustRead(
        R"({"glint": 1, "camera": {"position": [0, 0, 3], "target": [0, 4, 0], "apertureDiameter": 0.1}})");
    EXPECT_FLOAT_EQ(scene.camera.focalDistance, 5.0f);
    EXPECT_FLOAT_EQ(scene.camera.apertureDiameter, 0.1f);
}

TEST(SceneJson, CamerasMayLookAlongUp) {
    for (const char* camera : {R"("position": [0, 3, 0])", R"("position": [0, -3, 0])",
                               R"("position": [2, 0, 0], "up": [1, 0, 0])"}) {
        const SceneDescription scene =
            mustRead(std::string(R"({"glint": 1, "camera": {"target": [0, 0, 0], )") + camera + "}}");
        const auto built = buildCamera(scene.camera, 1.0f);
        ASSERT_TRUE(built) << built.error().format();
    }
}

TEST(SceneJson, ColoursAreGreyLinearOrHexadecimalSrgb) {
    const SceneDescription scene = mustRead(R"({"glint": 1, "materials": {
        "a": {"type": "diffuse", "color": 0.25},
        "b": {"type": "mirror", "color": [0.1, 0.2, 0.3]},
        "c": {"type": "plastic", "color": "#ff8000"}}})");
    EXPECT_EQ(scene.materials[0].color.value, Vec3(0.25f));
    EXPECT_EQ(scene.materials[1].color.value, Vec3(0.1f, 0.2f, 0.3f));
    EXPECT_NEAR(scene.materials[2].color.value.x, 1.0f, 1e-6f);
    EXPECT_NEAR(scene.materials[2].color.value.y, 0.215861f, 1e-5f);
    EXPECT_EQ(scene.materials[2].color.value.z, 0.0f);
}

TEST(SceneJson, ShapesStandWhereTheirFieldsSay) {
    const SceneDescription scene =
        mustRead(R"({"glint": 1, "materials": {"m": {"type": "diffuse"}}, "objects": [
        {"type": "sphere", "material": "m", "center": [1, 2, 3], "radius": 0.5},
        {"type": "rectangle", "material": "m", "center": [0, 1, 0], "edgeU": [4, 0, 0], "edgeV": [0, 0, -2]},
        {"type": "disc", "material": "m", "center": [0, 3, 0], "normal": [0, -2, 0], "radius": 2},
        {"type": "plane", "material": "m", "point": [0, -1, 0], "normal": [0, 1, 0], "frontOnly": true}]})");
    ASSERT_EQ(scene.objects.size(), 4u);
    EXPECT_EQ(scene.objects[0].objectToWorld.point({1, 0, 0}), Vec3(1.5f, 2, 3));
    EXPECT_EQ(scene.objects[1].objectToWorld.point({1, 1, 0}), Vec3(2, 1, -1));
    EXPECT_GT(scene.objects[1].objectToWorld.vector({0, 0, 1}).y, 0.0f);
    EXPECT_NEAR(glm::length(scene.objects[2].objectToWorld.vector({1, 0, 0})), 2.0f, 1e-6f);
    EXPECT_LT(scene.objects[2].objectToWorld.vector({0, 0, 1}).y, -1.9f);
    EXPECT_NEAR(scene.objects[3].objectToWorld.vector({0, 0, 1}).y, 1.0f, 1e-6f);
    EXPECT_TRUE(scene.objects[3].frontOnly);
}

TEST(SceneJson, TransformStepsApplyInTheOrderListed) {
    const SceneDescription scene =
        mustRead(R"({"glint": 1, "materials": {"m": {"type": "diffuse"}}, "objects": [
        {"type": "sphere", "material": "m",
         "transform": [{"scale": [2, 1, 1]}, {"rotateZDeg": 90}, {"translate": [10, 0, 0]}]},
        {"type": "sphere", "material": "m", "transform": {"matrix": [1, 0, 0, 5, 0, 2, 0, 6, 0, 0, 3, 7]}}]})");
    const Vec3 p = scene.objects[0].objectToWorld.point({1, 0, 0});
    EXPECT_NEAR(glm::length(p - Vec3(10, 2, 0)), 0.0f, 1e-5f);
    EXPECT_EQ(scene.objects[1].objectToWorld.point({1, 1, 1}), Vec3(6, 8, 10));
}

TEST(SceneJson, MaterialsAndMeshesMayStandWhereTheyAreUsed) {
    const SceneDescription scene = mustRead(R"({"glint": 1, "objects": [
        {"type": "mesh", "material": {"type": "dielectric", "ior": 1.3},
         "mesh": {"positions": [[0,0,0],[1,0,0],[0,1,0]], "uvs": [[0,0],[1,0],[0,1]], "triangles": [[0,1,2]]}}]})");
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(scene.materials.at(0).kind, MaterialKind::Dielectric);
    EXPECT_FLOAT_EQ(scene.materials[0].ior.value, 1.3f);
    EXPECT_EQ(scene.meshes.at(0).data->triangleCount(), 1u);
}

TEST(SceneJson, OurOwnScenesLoad) {
    const auto scene = loadScene(GLINT_SOURCE_DIR "/scenes/cornell.json");
    ASSERT_TRUE(scene.ok()) << scene.error().format();
    EXPECT_EQ(scene->objects.size(), 9u);
    EXPECT_EQ(scene->meshes.size(), 2u);
}

}  // namespace
}  // namespace glint
