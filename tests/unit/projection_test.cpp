// Parallel rays against closed forms, and shifted pictures against larger ones that they are parts of.
#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/builders/camera_builder.h"
#include "engine/kernels/camera_ray.h"
#include "engine/kernels/ray_cone.h"
#include "engine/render/first_hits.h"
#include "tests/support/render_scene.h"
#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

/// A shining ball of radius 1 before a camera of parallel rays at the origin, 0.1 m a pixel.
SceneDescription ballAt(const Vec3& center) {
    SceneDescription scene = emptyScene(Vec3(0.0f), Vec3(0, 0, -1), 40.0f, 48);
    scene.resolution = {64, 48};
    scene.camera.kind = ProjectionKind::Orthographic;
    scene.camera.viewHeight = 4.8f;
    scene.options.maxDepth = 0;
    addObject(&scene, ShapeKind::Sphere, translate(center), emissiveMaterial(Vec3(1.0f)));
    return scene;
}

TEST(Projection, ParallelRaysShowABallOfOneSize) {
    for (const float distance : {1.5f, 20.0f, 3000.0f}) {
        const Film film = renderFilm(ballAt({1.0f, 0.5f, -distance}), 64);
        double covered = 0.0;
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 64; ++x) {
                const double value = film.pixels()[static_cast<size_t>(y * 64 + x)].mean[0];
                covered += value;
                // Of the pixel's middle, in metres from the ball's.
                const double off = std::hypot((x + 0.5 - 32.0) * 0.1 - 1.0, (24.0 - y - 0.5) * 0.1 - 0.5);
                if (off < 0.92) { EXPECT_EQ(value, 1.0) << x << " " << y; }
                if (off > 1.08) { EXPECT_EQ(value, 0.0) << x << " " << y; }
            }
        }
        EXPECT_NEAR(covered, M_PI * 100.0, 0.5) << distance;
    }
}

TEST(Projection, WhatIsBehindTheCameraIsNotSeen) {
    const Film film = renderFilm(ballAt({0.0f, 0.0f, 3.0f}), 1);
    EXPECT_EQ(meanLuminance(film).mean, 0.0);
}

std::vector<float> depthsOf(const SceneDescription& scene) {
    const std::atomic<bool> never{false};
    return firstDepths(*buildAll(scene), scene.resolution.width, scene.resolution.height, never);
}

TEST(Projection, AShiftShowsThePixelsBesideThePicture) {
    constexpr int kRight = 7, kDown = 5;
    for (const ProjectionKind kind : {ProjectionKind::Perspective, ProjectionKind::Orthographic}) {
        for (const float horizontalScale : {1.0f, 1.25f}) {
            SceneDescription scene = cornellBox();
            scene.resolution = {60, 40};
            scene.camera.kind = kind;
            scene.camera.viewHeight = 1.7f;
            scene.camera.horizontalScale = horizontalScale;
            scene.camera.up = {0.1f, 1.0f, 0.0f};
            const std::vector<float> whole = depthsOf(scene);
            scene.camera.shift = {kRight / 40.0f, -kDown / 40.0f};
            const std::vector<float> shifted = depthsOf(scene);
            for (int y = 0; y + kDown < 40; ++y) {
                for (int x = 0; x + kRight < 60; ++x) {
                    const float expected = whole[static_cast<size_t>((y + kDown) * 60 + x + kRight)];
                    EXPECT_NEAR(shifted[static_cast<size_t>(y * 60 + x)], expected, 2e-5f * expected)
                        << x << " " << y;
                }
            }
            EXPECT_NE(shifted, whole);
        }
    }
}

/// A crop window has its part of the angle, and its middle off the axis.
TEST(Projection, ACropWindowIsAPartOfThePicture) {
    SceneDescription scene = cornellBox();
    scene.resolution = {60, 40};
    const std::vector<float> whole = depthsOf(scene);
    const float tangent = std::tan(scene.camera.verticalFovDeg * kPi / 360.0f);
    scene.resolution = {16, 12};
    scene.camera.verticalFovDeg = std::atan(tangent * 12.0f / 40.0f) * 360.0f / kPi;
    scene.camera.shift = {(35 + 8 - 30) / 12.0f, -(4 + 6 - 20) / 12.0f};
    const std::vector<float> part = depthsOf(scene);
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 16; ++x) {
            const float expected = whole[static_cast<size_t>((y + 4) * 60 + x + 35)];
            EXPECT_NEAR(part[static_cast<size_t>(y * 16 + x)], expected, 2e-5f * expected) << x << " " << y;
        }
    }
}

TEST(Projection, PixelsOfParallelRaysAreAsWideFarAway) {
    Camera camera;
    camera.kind = ProjectionKind::Orthographic;
    camera.viewHeight = 3.0f;
    RayCone cone = pixelCone(*buildCamera(camera, 1.0f), 30);
    cone.travel(100.0f);
    EXPECT_FLOAT_EQ(cone.width, 0.1f);
    camera.kind = ProjectionKind::Perspective;
    cone = pixelCone(*buildCamera(camera, 1.0f), 30);
    cone.travel(100.0f);
    EXPECT_FLOAT_EQ(cone.width, heightOfView(camera, 100.0f) / 30.0f);
}

}  // namespace
}  // namespace glint::test
