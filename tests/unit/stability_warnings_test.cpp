// What the loader warns of before a scene that float cannot hold is rendered.

#include "engine/scene/stability_warnings.h"

#include <gtest/gtest.h>

#include "engine/builders/repeated_triangles.h"
#include "engine/io/scene_loader.h"
#include "engine/stress/stress_scene.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

bool warnsOf(const SceneDescription& scene, const std::string& words) {
    for (const std::string& warning : stabilityWarnings(scene)) {
        if (warning.find(words) != std::string::npos) { return true; }
    }
    return false;
}

TEST(StabilityWarnings, OrdinaryScenesHaveNone) {
    EXPECT_TRUE(stabilityWarnings(stressRoom()).empty());
    EXPECT_TRUE(stabilityWarnings(SceneDescription{}).empty());
    for (const float factor : {1e-6f, 1e6f}) {
        EXPECT_TRUE(stabilityWarnings(scaledScene(stressRoom(), factor, StressChange::Vertices)).empty());
    }
    SceneDescription plane;
    addObject(&plane, ShapeKind::Plane, {}, diffuseMaterial(0.5f));
    EXPECT_TRUE(stabilityWarnings(plane).empty());
}

TEST(StabilityWarnings, NamesTheObjectFarFromTheOrigin) {
    SceneDescription scene = movedScene(stressRoom(), Vec3(1e6f, 0, 0), StressChange::Transforms);
    scene.objects[0].name = "walls";
    const std::vector<std::string> warnings = stabilityWarnings(scene);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("object 'walls' lies"), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[0].find("and 4 more objects"), std::string::npos) << warnings[0];
    EXPECT_FALSE(warnsOf(movedScene(stressRoom(), Vec3(1e3f, 0, 0), StressChange::Vertices), "origin"));
}

TEST(StabilityWarnings, WarnsOfTheSpanAndOfLengthsOutOfRange) {
    SceneDescription scene = stressRoom();
    addObject(&scene, ShapeKind::Sphere, scale(Vec3(1e-9f)), diffuseMaterial(0.5f));
    EXPECT_TRUE(warnsOf(scene, "the scene spans"));
    EXPECT_TRUE(warnsOf(scaledScene(stressRoom(), 1e15f, StressChange::Vertices), "use a larger unit"));
    EXPECT_TRUE(warnsOf(scaledScene(stressRoom(), 1e-15f, StressChange::Transforms), "use a smaller unit"));
}

TEST(StabilityWarnings, WarnsOfRadianceThatSumsCannotHold) {
    SceneDescription scene = stressRoom();
    scene.materials[1].emissionStrength = 1e31f;
    EXPECT_TRUE(warnsOf(scene, "emits a radiance"));
}

TEST(StabilityWarnings, NamesObjectsInOnePlaceWithDifferentMaterials) {
    SceneDescription scene = stressRoom();
    scene.objects.push_back(scene.objects[3]);
    EXPECT_TRUE(stabilityWarnings(scene).empty()) << "the same surface twice is no matter";
    scene.objects.back().material = 0;
    scene.objects.back().name = "copy";
    EXPECT_TRUE(warnsOf(scene, "object 4 and object 'copy' lie in one place"));
    scene.objects.back().objectToWorld.translation.y += 1e-3f;
    EXPECT_TRUE(stabilityWarnings(scene).empty());
}

/// Front and back of a surface with two materials.
TEST(StabilityWarnings, ObjectsInOnePlaceMayFaceOppositeSides) {
    SceneDescription scene = stressRoom();
    addObject(&scene, ShapeKind::Rectangle, translate(Vec3(0.1f)), diffuseMaterial(0.5f));
    addObject(&scene, ShapeKind::Rectangle, translate(Vec3(0.1f)) * rotate(Vec3(1, 0, 0), kPi),
              diffuseMaterial(0.2f));
    EXPECT_TRUE(warnsOf(scene, "lie in one place"));
    for (Object& object : scene.objects) {
        object.frontOnly = true;
    }
    EXPECT_FALSE(warnsOf(scene, "lie in one place"));
}

TEST(StabilityWarnings, NamesBodiesOfGlassThatTouch) {
    const auto withGap = [](float gap) {
        SceneDescription scene;
        for (const float y : {0.0f, 1.0f + gap}) {
            MeshData body;
            addBox(&body, {-1, y, -1}, {1, y + 1, 1}, false);
            addMeshObject(&scene, std::move(body), {}, glass(1.5f));
        }
        return scene;
    };
    EXPECT_TRUE(warnsOf(withGap(0.0f), "object 1 and object 2 are glass and touch"));
    EXPECT_TRUE(stabilityWarnings(withGap(1e-4f)).empty());
    EXPECT_TRUE(stabilityWarnings(withGap(-0.5f)).empty()) << "what overlaps is another matter";
    SceneDescription opaque = withGap(0.0f);
    opaque.materials[1] = diffuseMaterial(0.5f);
    EXPECT_TRUE(stabilityWarnings(opaque).empty());
}

TEST(StabilityWarnings, MeshesWithoutAreaAreNamed) {
    SceneDescription scene;
    scene.materials.resize(1);
    for (const auto& corners :
         {std::vector<Vec3>(3, Vec3(0, 1, 0)), std::vector<Vec3>{Vec3(0), Vec3(1), Vec3(2)}}) {
        auto mesh = std::make_shared<MeshData>();
        mesh->positions = corners;
        mesh->indices = {0, 1, 2};
        scene.meshes = {{"flat", {}, mesh}};
        Object object;
        object.name = "flat";
        object.shape = ShapeKind::Mesh;
        object.mesh = 0;
        scene.objects = {object};
        const std::vector<std::string> warnings = stabilityWarnings(scene);
        ASSERT_EQ(warnings.size(), 1u);
        EXPECT_NE(warnings[0].find("object 'flat' has no area"), std::string::npos) << warnings[0];
    }
}

TEST(StabilityWarnings, ProfilesThatTurnIntoNothingAreNamed) {
    using Profile = std::vector<Vec2>;
    for (const Profile& profile : {Profile{{1, 0}, {1, 0}}, Profile{{0, 0}, {0, 1}}}) {
        SceneDescription scene = stressRoom();
        addObject(&scene, ShapeKind::Revolved, {}, diffuseMaterial(0.5f));
        scene.objects.back().profile = profile;
        EXPECT_TRUE(warnsOf(scene, "has no area"));
        scene.objects.back().profile.push_back({1, 1});
        EXPECT_FALSE(warnsOf(scene, "has no area"));
    }
}

TEST(StabilityWarnings, TheLoaderPassesThemOn) {
    const test::TempFolder folder;
    const std::string far = folder.write("far.obj", "v 1000000 0 0\nv 1000001 0 0\nv 1000000 1 0\nf 1 2 3\n");
    const auto scene = loadScene(far, {});
    ASSERT_TRUE(scene);
    ASSERT_EQ(scene->warnings.size(), 1u);
    EXPECT_NE(scene->warnings[0].find("from the origin"), std::string::npos) << scene->warnings[0];
}

MeshData triangles(std::vector<uint32_t> indices) {
    MeshData mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 0}};
    mesh.indices = std::move(indices);
    return mesh;
}

TEST(RepeatedTriangles, AreFoundByPositionAndTurn) {
    const MeshData mesh = triangles({0, 1, 2, 1, 3, 2, 1, 2, 4, 2, 1, 0, 0, 1, 2});
    EXPECT_EQ(firstOfRepeatedTriangles(mesh, false), (std::vector<uint32_t>{0, 1, 0, 3, 0}));
    EXPECT_EQ(firstOfRepeatedTriangles(mesh, true), (std::vector<uint32_t>{0, 1, 0, 0, 0}));
    EXPECT_TRUE(firstOfRepeatedTriangles(MeshData{}, true).empty());
}

}  // namespace
}  // namespace glint
