// A scene without a camera is framed whole and lit.
#include "engine/io/default_view.h"

#include <gtest/gtest.h>

namespace glint {
namespace {

SceneDescription sceneWithBox(const Vec3& lo, const Vec3& hi) {
    SceneDescription scene;
    auto mesh = std::make_shared<MeshData>();
    mesh->positions = {lo, {hi.x, lo.y, lo.z}, {lo.x, hi.y, lo.z}, {lo.x, lo.y, hi.z}, hi};
    mesh->indices = {0, 1, 2, 0, 3, 4};
    scene.meshes.push_back({.name = "box", .source = {}, .data = mesh});
    Object object;
    object.shape = ShapeKind::Mesh;
    object.mesh = 0;
    scene.objects.push_back(object);
    return scene;
}

/// Where a point lands in the picture, [-1, 1] in both directions.
Vec2 projected(const SceneDescription& scene, const Vec3& p) {
    const Camera& camera = scene.camera;
    const Vec3 forward = glm::normalize(camera.target - camera.position);
    const Vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const Vec3 up = glm::cross(right, forward);
    const Vec3 to = p - camera.position;
    const float half = std::tan(0.5f * camera.verticalFovDeg * kPi / 180.0f) * glm::dot(to, forward);
    const float aspect =
        static_cast<float>(scene.resolution.width) / static_cast<float>(scene.resolution.height);
    return {glm::dot(to, right) / (half * aspect), glm::dot(to, up) / half};
}

TEST(DefaultView, FramesEveryCornerAtAnyScaleAndPlace) {
    const Vec3 boxes[][2] = {{Vec3(-1), Vec3(1)},
                             {Vec3(0), Vec3(1e-5f)},
                             {Vec3(1000, 2000, 3000), Vec3(1100, 2001, 3010)},
                             {Vec3(-1e6f), Vec3(1e6f, 0, 0)}};
    for (const auto& [lo, hi] : boxes) {
        SceneDescription scene = sceneWithBox(lo, hi);
        applyDefaultView(&scene, true);
        float largest = 0.0f;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 p{(corner & 1) != 0 ? hi.x : lo.x, (corner & 2) != 0 ? hi.y : lo.y,
                         (corner & 4) != 0 ? hi.z : lo.z};
            const Vec2 where = projected(scene, p);
            EXPECT_LT(std::fabs(where.x), 1.0f);
            EXPECT_LT(std::fabs(where.y), 1.0f);
            largest = std::fmax(largest, std::fmax(std::fabs(where.x), std::fabs(where.y)));
        }
        EXPECT_GT(largest, 0.4f);  // not lost in the middle either
        EXPECT_FLOAT_EQ(scene.camera.focalDistance, glm::length(scene.camera.target - scene.camera.position));
        EXPECT_EQ(scene.resolution, (Resolution{800, 600}));
        EXPECT_TRUE(scene.environment.emissive());
        EXPECT_EQ(scene.materials.size(), 1u);
    }
}

TEST(DefaultView, KeepsLightAndMaterialsThatAreThere) {
    SceneDescription scene = sceneWithBox(Vec3(0), Vec3(1));
    scene.materials.resize(2);
    scene.materials[0].emission.value = Vec3(1.0f);
    applyDefaultView(&scene, false);
    EXPECT_FALSE(scene.environment.emissive());
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_TRUE(scene.notes.empty());
    SceneDescription dark = sceneWithBox(Vec3(0), Vec3(1));
    applyDefaultView(&dark, false);
    ASSERT_EQ(dark.notes.size(), 1u) << "what is added is said";
    EXPECT_NE(dark.notes[0].find("--no-studio"), std::string::npos);
    SceneDescription empty;
    applyDefaultView(&empty, false);
    EXPECT_FALSE(empty.environment.emissive());
}

}  // namespace
}  // namespace glint
