// What the lens's centre sees, against closed forms.
#include "engine/render/first_hits.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "engine/builders/scene_builder.h"
#include "tests/support/test_scenes.h"

namespace glint {
namespace {

/// A sphere of radius 1 in front of the camera, 4 m away, with a wide open lens that is focused elsewhere.
SceneDescription sphereScene() {
    SceneDescription scene;
    scene.resolution = {41, 31};
    scene.camera.position = {0.0f, 0.0f, 4.0f};
    scene.camera.target = {0.0f, 0.0f, 0.0f};
    scene.camera.apertureDiameter = 0.5f;
    scene.camera.focalDistance = 9.0f;
    scene.materials.resize(2);
    Object sphere;
    sphere.shape = ShapeKind::Sphere;
    sphere.material = 1;
    scene.objects.push_back(sphere);
    return scene;
}

std::shared_ptr<const BuiltScene> built(const SceneDescription& scene) {
    auto result = buildScene({std::make_shared<SceneDescription>(scene), EditKind::Everything}, nullptr, 1,
                             nullptr, nullptr);
    EXPECT_TRUE(result);
    return *result;
}

TEST(FirstHits, AreExactWhateverTheLensDoes) {
    const auto scene = built(sphereScene());
    const FirstHit middle = firstHit(*scene, 41, 31, 20, 15);
    EXPECT_NEAR(middle.depth, 3.0f, 1e-5f);
    EXPECT_EQ(middle.object, 1u);
    EXPECT_EQ(middle.material, 2u);
    const FirstHit corner = firstHit(*scene, 41, 31, 0, 0);
    EXPECT_EQ(corner.depth, 0.0f);
    EXPECT_EQ(corner.object, 0u);
}

TEST(FirstHits, DepthIsAlongTheAxis) {
    const auto scene = built(sphereScene());
    // Through pixel (x, 15), the ray leaves the axis by `slope`; with z along the axis, z^2 slope^2 +
    // (z - 4)^2 = 1.
    const double halfHeight = std::tan(20.0 * 3.14159265358979 / 180.0);
    for (int x = 14; x <= 26; ++x) {
        const double slope = (x - 20) / 15.5 * halfHeight;
        const double a = 1.0 + slope * slope;
        const double z = (4.0 - std::sqrt(16.0 - 15.0 * a)) / a;
        EXPECT_NEAR(firstHit(*scene, 41, 31, x, 15).depth, z, 1e-5) << x;
    }
}

TEST(FirstHits, NothingIsHitOnAWayThatFloatCannotTell) {
    auto scene = sphereScene();
    const auto near = built(scene);
    constexpr float kFar = 3.4e38f;
    constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
    for (const Vec3& end : {Vec3(0.0f, kFar, 4.0f), Vec3(0.0f, -kFar, kFar), Vec3(kNoNumber, 0.0f, 0.0f),
                            Vec3(kInfinity, 0.0f, 0.0f)}) {
        EXPECT_EQ(firstHitBetween(*near, end, {0.0f, 0.0f, 0.0f}).object, 0u);
        EXPECT_EQ(firstHitBetween(*near, -end, end).object, 0u);
    }
    scene.camera.position = {0.0f, kFar, 4.0f};
    const FirstHit hit = firstHit(*built(scene), 41, 31, 20, 15);
    EXPECT_LE(hit.object, 1u);
}

TEST(FirstHits, AllDepthsAreThoseOfThePixels) {
    const auto scene = built(test::cornellBox());
    const std::vector<float> depths = firstDepths(*scene, 13, 9, std::atomic<bool>(false));
    ASSERT_EQ(depths.size(), 13u * 9u);
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 13; ++x) {
            EXPECT_EQ(depths[static_cast<size_t>(y * 13 + x)], firstHit(*scene, 13, 9, x, y).depth);
        }
    }
    EXPECT_TRUE(firstDepths(*scene, 13, 9, std::atomic<bool>(true)).empty());
}

}  // namespace
}  // namespace glint
