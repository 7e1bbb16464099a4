// Cameras around a target and from view to view.
#include "engine/scene/camera_path.h"

#include <cmath>

#include <gtest/gtest.h>

namespace glint {
namespace {

TEST(CameraPath, ATurnKeepsDistanceAndHeightAndComesBack) {
    Camera camera;
    camera.position = {3.0f, 2.0f, 0.0f};
    camera.target = {1.0f, 1.0f, 0.0f};
    camera.up = {0.0f, 2.0f, 0.0f};
    for (const float turns : {0.0f, 0.1f, 0.5f, 0.9f, 1.0f, -0.25f, 7.3f}) {
        const Camera turned = turnedCamera(camera, turns);
        EXPECT_NEAR(turned.position.y, 2.0f, 1e-5f) << turns;
        EXPECT_NEAR(glm::distance(turned.position, camera.target), std::sqrt(5.0f), 1e-5f) << turns;
        EXPECT_EQ(turned.target, camera.target);
    }
    EXPECT_NEAR(turnedCamera(camera, 0.25f).position.z, -2.0f, 1e-5f) << "counterclockwise seen from above";
    EXPECT_NEAR(turnedCamera(camera, 0.5f).position.x, -1.0f, 1e-5f);
    EXPECT_EQ(turnedCamera(camera, 1.0f).position, camera.position);
}

TEST(CameraPath, PassesThroughItsViewsWithoutCornersAndStaysInRange) {
    std::vector<Camera> views(4);
    for (size_t i = 0; i < views.size(); ++i) {
        const auto x = static_cast<float>(i);
        views[i].position = {x, x * x, 5.0f};
        views[i].apertureDiameter = i % 2 == 0 ? 0.0f : 0.1f;
        views[i].apertureBlades = static_cast<int>(i);
    }
    for (size_t i = 0; i < views.size(); ++i) {
        const Camera at = cameraBetween(views, static_cast<float>(i));
        EXPECT_EQ(at.position, views[i].position);
        EXPECT_EQ(at.apertureBlades, views[i].apertureBlades);
    }
    constexpr float kStep = 1e-3f;
    for (const float along : {1.0f, 2.0f}) {
        const Vec3 before =
            cameraBetween(views, along).position - cameraBetween(views, along - kStep).position;
        const Vec3 after =
            cameraBetween(views, along + kStep).position - cameraBetween(views, along).position;
        EXPECT_NEAR(glm::distance(before, after), 0.0f, 0.02f * kStep);
    }
    EXPECT_NEAR(cameraBetween(views, 1.5f).position.y, 2.25f, 1e-5f) << "a parabola stays one";
    for (float along = 0.0f; along <= 3.0f; along += 0.05f) {
        const Camera at = cameraBetween(views, along);
        EXPECT_GE(at.apertureDiameter, 0.0f);
        EXPECT_LE(at.apertureDiameter, 0.1f);
    }
    EXPECT_EQ(cameraBetween(std::span(views).first(1), 0.7f).position, views[0].position);
}

}  // namespace
}  // namespace glint
