// Scenes far from the origin: what is moved, what stays, and that the picture is that of the same scene at
// the origin, to the bit where the move is exact.
#include "engine/builders/recentring.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "engine/builders/instance_builder.h"
#include "engine/builders/light_table.h"
#include "engine/builders/mesh_builder.h"
#include "engine/builders/scene_builder.h"
#include "engine/io/scene_loader.h"
#include "engine/stress/stress_scene.h"
#include "tests/support/render_scene.h"

namespace glint {
namespace {

/// A multiple of the grid that origins lie on for a room of 5 units, and a million times its size away.
const Vec3 kExactOffset{3500032.0f, 1500000.0f, -3250048.0f};

SceneDescription farRoom(StressChange change = StressChange::Vertices) {
    return movedScene(gridRoom(), kExactOffset, change);
}

std::shared_ptr<const BuiltScene> edited(const SceneDescription& scene, EditKind kinds,
                                         const BuiltScene* previous, BuildReport* report = nullptr) {
    auto built = buildScene({std::make_shared<SceneDescription>(scene), kinds}, previous, 1, nullptr, report);
    EXPECT_TRUE(built.ok()) << (built.ok() ? "" : built.error().format());
    return built.ok() ? *built : nullptr;
}

void expectSameFilm(const SceneDescription& a, const SceneDescription& b) {
    const Film filmA = test::renderFilm(a, 4);
    const Film filmB = test::renderFilm(b, 4);
    ASSERT_EQ(filmA.pixels().size(), filmB.pixels().size());
    for (size_t i = 0; i < filmA.pixels().size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            ASSERT_EQ(filmA.pixels()[i].mean[c], filmB.pixels()[i].mean[c]) << "pixel " << i;
        }
    }
}

TEST(Recentring, LeavesOrdinaryScenesAlone) {
    EXPECT_EQ(findRecentring(gridRoom(), nullptr), nullptr);
    EXPECT_EQ(findRecentring(SceneDescription{}, nullptr), nullptr);
    const SceneDescription near = movedScene(gridRoom(), {200, 0, 0}, StressChange::Vertices);
    EXPECT_EQ(findRecentring(near, nullptr), nullptr) << "40 sizes away is near enough";
}

TEST(Recentring, LeavesTheScenesOfThisRepositoryAlone) {
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(GLINT_SOURCE_DIR "/scenes")) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(".json") || name.ends_with("schema.json")) { continue; }
        const auto scene = loadScene(entry.path().string(), {});
        ASSERT_TRUE(scene) << entry.path();
        EXPECT_EQ(findRecentring(*scene, nullptr), nullptr) << entry.path();
        ++scenes;
    }
    EXPECT_GT(scenes, 5);
}

TEST(Recentring, AFarRoomHasTheSameBitsAsOneAtTheOrigin) {
    expectSameFilm(farRoom(StressChange::Vertices), gridRoom());
    expectSameFilm(farRoom(StressChange::Transforms), gridRoom());
}

/// Lights without a shape, a plane, and a mesh whose far vertices a transform brings back.
TEST(Recentring, EverythingFollows) {
    SceneDescription room = gridRoom();
    Light bulb;
    bulb.position = {-1, 2, 1};
    room.lights.push_back(bulb);
    Light spot = bulb;
    spot.kind = LightKind::Spot;
    spot.position = {1, 2.5f, 0};
    room.lights.push_back(spot);
    room.environment.color = Vec3(0.3f);
    addObject(&room, ShapeKind::Plane, placeFlatShape({0, -1, 0}, {0, 1, 0}, 1, 1), diffuseMaterial(0.5f));
    expectSameFilm(movedScene(room, kExactOffset, StressChange::Vertices), room);
    EXPECT_EQ(edited(movedScene(room, kExactOffset, StressChange::Vertices), EditKind::Everything, nullptr)
                  ->origin(),
              kExactOffset);
}

TEST(Recentring, MeshesFarFromTheirOwnOriginAreCentredToo) {
    const SceneDescription room = gridRoom();
    SceneDescription brought = room;
    for (Mesh& mesh : brought.meshes) {
        auto data = std::make_shared<MeshData>(*mesh.data);
        for (Vec3& p : data->positions) {
            p += kExactOffset;
        }
        mesh.data = std::move(data);
    }
    for (Object& object : brought.objects) {
        if (object.shape != ShapeKind::Mesh) { continue; }
        object.objectToWorld = object.objectToWorld * translate(-kExactOffset);
    }
    const auto found = findRecentring(brought, nullptr);
    ASSERT_NE(found, nullptr);
    EXPECT_TRUE(isZero(found->origin));
    const SceneDescription moved = recentred(brought, *found);
    for (const Mesh& mesh : moved.meshes) {
        for (const Vec3& p : mesh.data->positions) {
            EXPECT_LT(maxComponent(absVec(p)), 20.0f);
        }
    }
    for (const Object& object : moved.objects) {
        EXPECT_LT(maxComponent(absVec(object.objectToWorld.translation)), 20.0f);
    }
}

TEST(Recentring, CameraAndMaterialEditsKeepTheOriginAndRebuildNoMesh) {
    SceneDescription scene = farRoom();
    const auto before = edited(scene, EditKind::Everything, nullptr);
    scene.camera.position += Vec3(50, 0, 0);
    scene.materials[0].color.value = Vec3(0.1f);
    const auto after = edited(scene, EditKind::Camera | EditKind::MaterialParameters, before.get());
    EXPECT_EQ(after->origin(), before->origin());
    EXPECT_EQ(after->meshes, before->meshes);
    EXPECT_EQ(after->instances, before->instances);
    EXPECT_EQ(after->camera.position, scene.camera.position - kExactOffset);
}

TEST(Recentring, AMovedObjectKeepsTheOriginUntilTheSceneGrows) {
    SceneDescription scene = farRoom();
    const auto before = edited(scene, EditKind::Everything, nullptr);
    Object& sphere = scene.objects[2];
    sphere.objectToWorld.translation += Vec3(0.25f, 0, 0.25f);
    BuildReport report;
    const auto after = edited(scene, EditKind::ObjectTransform, before.get(), &report);
    EXPECT_EQ(after->origin(), before->origin());
    EXPECT_EQ(after->meshes, before->meshes);
    EXPECT_EQ(report.meshesBuilt, 0);
    EXPECT_EQ(after->instances->instances[2].objectToWorld.translation,
              sphere.objectToWorld.translation - kExactOffset);
    // Dragged to where world coordinates will do: as if it had been loaded so.
    sphere.objectToWorld.translation = {0, 0, 0};
    const auto home = edited(scene, EditKind::ObjectTransform, after.get());
    EXPECT_TRUE(isZero(home->origin()));
    EXPECT_EQ(home->meshes[0]->data, scene.meshes[0].data);
}

TEST(Recentring, InfinitePlanesFarFromTheGeometryKeepItWhereItIs) {
    SceneDescription scene = emptyStressScene({0, 1, 5}, {0, 1, 0}, 40.0f);
    addObject(&scene, ShapeKind::Sphere, translate({0, 1, 0}) * scale(Vec3(1e-4f)),
              emissiveMaterial(Vec3(1.0f)));
    EXPECT_NE(findRecentring(scene, nullptr), nullptr);
    addObject(&scene, ShapeKind::Plane, placeFlatShape({0, 0, 0}, {0, 1, 0}, 1, 1), diffuseMaterial(0.5f));
    EXPECT_EQ(findRecentring(scene, nullptr), nullptr);
}

}  // namespace
}  // namespace glint
