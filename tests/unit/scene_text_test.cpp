// 6.837-style scenes: what their fields mean.
#include "engine/io/scene_text.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/builders/camera_builder.h"
#include "engine/io/image_io.h"
#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using testing::HasSubstr;

SceneDescription mustRead(const std::string& text, bool allowMissing = false) {
    auto scene = readSceneText({"scene.txt", text}, {.allowMissing = allowMissing});
    EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().format());
    return scene.ok() ? std::move(*scene) : SceneDescription();
}

float distanceBetween(const Vec3& a, const Vec3& b) { return glm::length(a - b); }

constexpr const char* kTwoMaterials =
    "Materials { numMaterials 2 Material { } Material { color 1 0 0 emission 2 2 2 } }\n";

TEST(SceneText, CameraNarrowsByTheSineBetweenDirectionAndUp) {
    const SceneDescription scene = mustRead(
        "PerspectiveCamera { center 0 0 10 direction 0 -3 -10 up 0 1 0 angle 50 width 30 height 20 }");
    const float sine = 10.0f / std::sqrt(109.0f);
    EXPECT_NEAR(std::tan(scene.camera.verticalFovDeg * kPi / 360.0f), sine * std::tan(25.0f * kPi / 180.0f),
                1e-6f);
    EXPECT_EQ(scene.resolution, (Resolution{30, 20}));
    EXPECT_EQ(scene.camera.horizontalScale, 1.0f);
}

TEST(SceneText, MirrorsReflectMirrorsToDepth64) { EXPECT_EQ(mustRead(kTwoMaterials).options.maxDepth, 64); }

/// A shallow roof of two triangles: the original shows its edge, other files without normals hide it.
TEST(SceneText, MeshesWithoutNormalsStayFlat) {
    const test::TempFolder folder;
    folder.write("roof.obj", "v 0 0 0\nv 0 0 1\nv 1 -0.2 0\nv -1 -0.2 0\nf 1 2 3\nf 1 4 2\n");
    folder.write("smooth.obj",
                 "v 0 0 0\nv 0 0 1\nv 1 -0.2 0\nvn 0 1 0\nvn 1 1 0\nvn 0 1 1\nf 1//1 2//2 3//3\n");
    const auto scene = loadScene(
        folder.write("s.txt",
                     "Materials { numMaterials 1 Material { } }\nGroup { numObjects 2 MaterialIndex 0 "
                     "TriangleMesh { obj_file roof.obj } TriangleMesh { obj_file smooth.obj } }"));
    ASSERT_TRUE(scene.ok()) << scene.error().format();
    EXPECT_TRUE(scene->meshes.at(0).data->normals.empty());
    EXPECT_FALSE(scene->meshes.at(1).data->normals.empty()) << "its own";
    EXPECT_THAT(scene->notes, testing::Not(testing::Contains(HasSubstr("smooth ones"))));
    const std::string json = folder.path("s.json");
    ASSERT_TRUE(saveSceneJson(*scene, json));
    const auto again = loadScene(json);
    ASSERT_TRUE(again.ok()) << again.error().format();
    EXPECT_TRUE(again->meshes.at(0).data->normals.empty());
    const auto alone = loadScene(folder.path("roof.obj"));
    ASSERT_TRUE(alone.ok());
    EXPECT_FALSE(alone->meshes.at(0).data->normals.empty());
}

TEST(SceneText, ACameraMayLookAlongItsUp) {
    for (const char* view : {"direction 0 -1 0", "direction 0 3 0", "direction 0 0 -2 up 0 0 5"}) {
        const SceneDescription scene =
            mustRead(std::string("PerspectiveCamera { center 0 9 0 angle 50 ") + view + " }");
        EXPECT_EQ(scene.camera.verticalFovDeg, 50.0f) << view;
        EXPECT_TRUE(buildCamera(scene.camera, 1.0f)) << view;
        EXPECT_THAT(scene.warnings, testing::IsEmpty()) << view;
        EXPECT_THAT(scene.notes, testing::ElementsAre(HasSubstr("scene.txt:1: the camera looks along 'up'")))
            << view;
    }
}

TEST(SceneText, BumpsHaveATenthOfTheOriginalsHeightButOnMeshes) {
    const test::TempFolder folder;
    ASSERT_TRUE(savePng(folder.path("b.png"), {1, 1, {9, 9, 9}}));
    folder.write("m.obj", "v 0 0 0\nv 3 0 0\nv 0 3 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    const auto scene = loadScene(
        folder.write("s.txt",
                     "Materials { numMaterials 2 Material { bump b.png } Material { bump b.png } }\n"
                     "Group { numObjects 2 MaterialIndex 0 Sphere { center 0 0 0 radius 1 }\n"
                     "MaterialIndex 1 Transform { UniformScale 2 TriangleMesh { obj_file m.obj } } }"));
    ASSERT_TRUE(scene) << scene.error().format();
    for (const Material& material : scene->materials) {
        EXPECT_EQ(material.bump.texture, 0);
    }
    EXPECT_FLOAT_EQ(scene->materials[0].bumpHeight, 0.2f);
    EXPECT_NEAR(scene->materials[1].bumpHeight, 0.02f * 6.0f, 1e-5f) << "6 m a width of the image";
    EXPECT_EQ(scene->textures[0].encoding, ColorEncoding::Linear);
}

TEST(SceneText, ApertureIsTheHalfSideOfASquareLens) {
    const SceneDescription scene = mustRead(
        "PerspectiveCamera { center 0 0 1 direction 0 0 -1 up 0 1 0 angle 30 "
        "focalLength 220 aperture 6 }");
    EXPECT_FLOAT_EQ(scene.camera.focalDistance, 220.0f);
    EXPECT_EQ(scene.camera.apertureBlades, 4);
    // The polygon's corner is where both coordinates are 6.
    EXPECT_NEAR(0.5f * scene.camera.apertureDiameter * std::sqrt(0.5f), 6.0f, 1e-5f);
    EXPECT_FLOAT_EQ(scene.camera.bladeRotationDeg, 45.0f);
}

TEST(SceneText, EmissionLeavesBothSides) {
    const SceneDescription scene = mustRead(kTwoMaterials);
    EXPECT_FALSE(scene.materials[0].emissive());
    ASSERT_TRUE(scene.materials[1].emissive());
    EXPECT_TRUE(scene.materials[1].emitsBothSides);
}

TEST(SceneText, RayCastingGetsHighlightsAmbientLightAndLightsAsTheOriginalHasThem) {
    const SceneDescription scene = mustRead(
        "Background { color 0 0 1 ambientLight 0.1 0.2 0.3 }"
        "Lights { numLights 1 PointLight { position 0 3 0 color 1 1 1 } }"
        "Materials { numMaterials 3 Material { specularColor 1 2 3 shininess 20} Material { }"
        "  Material { specularColor 1 1 1 } }"
        "Group { numObjects 1 Sphere { center 0 0 0 radius 1 } }");
    EXPECT_EQ(scene.materials[0].phongSpecular, Vec3(1, 2, 3));
    EXPECT_EQ(scene.materials[0].phongExponent, 20.0f);
    EXPECT_EQ(scene.materials[1].phongSpecular, Vec3(0));
    EXPECT_EQ(scene.materials[2].phongExponent, 0.0f);
    EXPECT_EQ(scene.rayCast.ambient, Vec3(0.1f, 0.2f, 0.3f));
    EXPECT_FALSE(scene.rayCast.shadows);
    EXPECT_FALSE(scene.rayCast.falloff);
}

TEST(SceneText, MaterialIndexStaysInForceAcrossGroups) {
    const SceneDescription scene =
        mustRead(std::string(kTwoMaterials) +
                 "Group { numObjects 3 Sphere { center 0 0 0 radius 1 }"
                 " Group { numObjects 1 MaterialIndex 1 Sphere { center 0 0 0 radius 1 } }"
                 " Sphere { center 0 0 0 radius 1 } }");
    ASSERT_EQ(scene.objects.size(), 3u);
    EXPECT_EQ(scene.objects[0].material, 0);
    EXPECT_EQ(scene.objects[1].material, 1);
    EXPECT_EQ(scene.objects[2].material, 1);
}

TEST(SceneText, TheFirstTransformListedIsTheOutermost) {
    const SceneDescription scene =
        mustRead(std::string(kTwoMaterials) +
                 "Group { numObjects 1 Transform { Translate 5 0 0 ZRotate 90 Scale 2 1 1"
                 " Sphere { center 1 0 0 radius 1 } } }");
    EXPECT_LT(distanceBetween(scene.objects.at(0).objectToWorld.point({0, 0, 0}), {5, 2, 0}), 1e-5f);
}

TEST(SceneText, MatricesGoColumnByColumnAndMultiplyFromTheLeft) {
    const SceneDescription scene = mustRead(
        std::string(kTwoMaterials) +
        "Group { numObjects 1 Transform { Translate 1 0 0 Matrix4f { 0 1 0 0  -1 0 0 0  0 0 1 0  0 0 7 1 }"
        " Sphere { center 0 0 0 radius 1 } } }");
    EXPECT_LT(distanceBetween(scene.objects.at(0).objectToWorld.point({0, 0, 0}), {0, 1, 7}), 1e-5f);
}

TEST(SceneText, PlanesLieAtTheirOffsetAndCarryWorldTextureCoordinates) {
    const SceneDescription scene = mustRead(std::string(kTwoMaterials) +
                                            "Group { numObjects 2 Plane { normal 3 0.3 0 offset -2 }"
                                            " Plane { normal 0 -2 0 offset -4 } }");
    for (const Object& object : scene.objects) {
        EXPECT_TRUE(object.frontOnly);
    }
    const Vec3 n = glm::normalize(Vec3(3, 0.3f, 0));
    const Affine& wall = scene.objects.at(0).objectToWorld;
    for (const Vec2 uv : {Vec2(0, 0), Vec2(2, 3), Vec2(-1, 5)}) {
        const Vec3 p = wall.point({uv, 0});
        EXPECT_NEAR(glm::dot(p, n), -2.0f, 1e-5f);
        EXPECT_NEAR(p.y, uv.y, 1e-5f);
        EXPECT_NEAR(glm::dot(p + 2.0f * n, glm::cross(Vec3(0, 1, 0), n)), uv.x, 1e-5f);
    }
    EXPECT_GT(glm::dot(wall.vector({0, 0, 1}), n), 0.9f);
    EXPECT_NEAR(scene.objects[1].objectToWorld.point({2, 3, 0}).y, 4.0f, 1e-5f);
}

TEST(SceneText, TypesBecomeMaterialKinds) {
    const SceneDescription scene = mustRead(
        "Materials { numMaterials 4 Material { type 2 0 0 } Material { type 0 1 0 } Material { type 0 0 3 "
        "refr 1.5 }"
        " Material { type 1 1 2 refr 1.3 } }");
    EXPECT_EQ(scene.materials[0].kind, MaterialKind::Diffuse);
    EXPECT_EQ(scene.materials[1].kind, MaterialKind::Mirror);
    EXPECT_EQ(scene.materials[2].kind, MaterialKind::Dielectric);
    EXPECT_FLOAT_EQ(scene.materials[2].ior.value, 1.5f);
    EXPECT_EQ(scene.materials[3].kind, MaterialKind::Mixture);
    EXPECT_EQ(scene.materials[3].mixtureWeights.value, Vec3(0.25f, 0.25f, 0.5f));
}

/// Otherwise ray casting alone has them, and the background is light, too.
TEST(SceneText, LightsShineOnlyWhenNothingEmits) {
    const std::string lights =
        "Lights { numLights 2 PointLight { position 0 3 0 color 1 1 1 }"
        " DirectionalLight { direction 0 -1 0 color 2 2 2 } }";
    const std::string group = "Group { numObjects 1 MaterialIndex ";
    const std::string sphere = " Sphere { center 0 0 0 radius 1 } }";
    const SceneDescription lit = mustRead(lights + kTwoMaterials + group + "0" + sphere);
    ASSERT_EQ(lit.lights.size(), 2u);
    EXPECT_FLOAT_EQ(lit.lights[0].strength, 9.0f * kPi);
    EXPECT_FLOAT_EQ(lit.lights[1].strength, kPi);
    EXPECT_THAT(lit.notes, testing::ElementsAre(HasSubstr("no material emits")));
    EXPECT_THAT(lit.warnings, testing::IsEmpty()) << "--strict takes it";
    EXPECT_FALSE(lit.lights[0].onlyRayCast);
    EXPECT_TRUE(lit.environment.seenOnly);
    const SceneDescription glowing = mustRead(lights + kTwoMaterials + group + "1" + sphere);
    ASSERT_EQ(glowing.lights.size(), 2u);
    EXPECT_TRUE(glowing.lights[0].onlyRayCast && glowing.lights[1].onlyRayCast);
    EXPECT_FLOAT_EQ(glowing.lights[0].strength, 9.0f * kPi);
    EXPECT_FALSE(glowing.rayCast.shadows);
    EXPECT_FALSE(glowing.environment.seenOnly);
}

TEST(SceneText, RevSurfacesAreTurnedProfiles) {
    const SceneDescription scene = mustRead(
        std::string(kTwoMaterials) +
        "Group { numObjects 3 Transform { Translate 0 5 0 RevSurface { profile BsplineCurve {"
        " controls [ 1 0 0 ] [ 1 1 0 ] [ 1 2 0 ] [ 1 3 0 ] } } }\n RevSurface { profile BezierCurve {"
        " controls [ 0 0 0 ] [ 1 0 0 ] [ 1 2 0 ] [ 0 2 0 ] } }\n"
        "BezierCurve { controls [ 0 0 0 ] [ 1 0 0 ] [ 1 2 0 ] [ 0 2 0 ] } }");
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.objects[0].shape, ShapeKind::Revolved);
    EXPECT_EQ(scene.objects[0].curve, CurveKind::Bspline);
    EXPECT_EQ(scene.objects[0].objectToWorld.translation, Vec3(0, 5, 0));
    EXPECT_EQ(scene.objects[1].curve, CurveKind::Bezier);
    EXPECT_EQ(scene.objects[1].profile, (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 2}, {0, 2}}));
    EXPECT_THAT(
        scene.warnings,
        testing::Contains(HasSubstr("curves have no surface, so nothing of them is drawn: \"BezierCurve\"")));
    std::string points;
    for (int i = 0; i < 19; ++i) {
        points += "[ 1 " + std::to_string(i) + " 0 ] ";
    }
    const auto refused =
        readSceneText({"scene.txt", std::string(kTwoMaterials) +
                                        "Group { numObjects 1 RevSurface { profile BezierCurve { controls " +
                                        points + "} } }"},
                      {});
    ASSERT_FALSE(refused.ok());
    EXPECT_THAT(refused.error().format(), HasSubstr("degree 18; expected at most 16 points"));
}

}  // namespace
}  // namespace glint
