// The lens in the words of photographers, against published figures and against the rays of the renderer.
#include "viewer/model/lens.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/builders/camera_builder.h"
#include "engine/kernels/camera_ray.h"
#include "viewer/model/focus_overlay.h"

namespace glint {
namespace {

Camera someCamera() {
    Camera camera;
    camera.position = {0.0f, 0.0f, 5.0f};
    camera.target = {0.0f, 0.0f, 0.0f};
    camera.apertureDiameter = 0.02f;
    camera.focalDistance = 2.0f;
    return camera;
}

TEST(Lens, FocalLengthsAreThoseOfTables) {
    Camera camera;
    // A 50 mm lens on full frame sees 26.99 degrees of height, on APS-C (15.7 mm) 17.85.
    camera.verticalFovDeg = fovDegForFocalLength(50.0f, 24.0f);
    EXPECT_NEAR(camera.verticalFovDeg, 26.99f, 0.005f);
    EXPECT_NEAR(focalLengthMm(camera, 24.0f), 50.0f, 1e-3f);
    EXPECT_NEAR(fovDegForFocalLength(50.0f, 15.7f), 17.85f, 0.005f);
    EXPECT_EQ(sensorSizes().front().heightMm, 24.0f);
    EXPECT_EQ(sensorSizes().back().heightMm, 0.0f);
}

TEST(Lens, FStopAndApertureAreInverse) {
    Camera camera;
    EXPECT_TRUE(std::isinf(fStop(camera, 24.0f)));
    camera.apertureDiameter = apertureForFStop(camera, 2.8f, 24.0f);
    EXPECT_NEAR(fStop(camera, 24.0f), 2.8f, 1e-4f);
    // 24 mm of sensor at 40 degrees: f = 12 mm / tan 20 = 32.97 mm.
    EXPECT_NEAR(camera.apertureDiameter, 0.03297f / 2.8f, 1e-5f);
    EXPECT_EQ(apertureForFStop(camera, kInfinity, 24.0f), 0.0f);
}

TEST(Lens, ThirdsOfStops) {
    const float nominal[] = {2.8f, 3.2f, 3.5f, 4.0f, 4.5f, 5.0f, 5.6f};
    for (int i = 0; i < 7; ++i) {
        EXPECT_NEAR(fStopInThirds(2.8f, i), nominal[i], 0.02f * nominal[i]);
    }
    EXPECT_NEAR(fStopInThirds(3.0f, -1), 2.8284f, 1e-3f) << "from what lies between, the nearest counts";
}

TEST(Lens, CirclesOfConfusionAreThoseOfTheRays) {
    const Camera camera = someCamera();
    constexpr int kHeight = 720;
    const CameraData data = *buildCamera(camera, 1.0f);
    for (const float depth : {0.5f, 1.0f, 1.9f, 2.0f, 2.1f, 4.0f, 50.0f}) {
        // The pixel whose ray through the lens's right edge meets the axis at that depth: its distance from
        // the middle is half the circle.
        double low = -2.0, high = 2.0;
        for (int step = 0; step < 60; ++step) {
            const double middle = 0.5 * (low + high);
            CameraData edge = data;
            edge.position = data.position + data.frame.s * data.lensRadius;
            const Vec3 inFocus = data.position +
                                 data.frame.s * (static_cast<float>(middle) * data.halfWidth * 2.0f) -
                                 data.frame.n * camera.focalDistance;
            const Vec3 direction = inFocus - edge.position;
            const float across = data.lensRadius + glm::dot(direction, data.frame.s) * depth /
                                                       -glm::dot(direction, data.frame.n);
            (across < 0.0f ? low : high) = middle;
        }
        const double circle = 2.0 * low * 0.5 * kHeight;
        EXPECT_NEAR(blurPixels(camera, depth, kHeight), circle, 1e-3 * std::fabs(circle) + 1e-3) << depth;
    }
}

/// As wide as what the rays of the picture's middle meet at that depth.
TEST(Lens, ParallelRaysHaveCirclesOfConfusion) {
    Camera camera = someCamera();
    camera.kind = ProjectionKind::Orthographic;
    camera.viewHeight = 0.8f;
    const CameraData data = *buildCamera(camera, 1.0f);
    for (const float depth : {0.5f, 1.9f, 2.1f, 5.0f}) {
        float radius = 0.0f;
        for (int i = 0; i < 4096; ++i) {
            const Vec2 uLens((static_cast<float>(i % 64) + 0.5f) / 64.0f,
                             (static_cast<float>(i / 64) + 0.5f) / 64.0f);
            const Ray ray = cameraRay<kFeatureCameraArea>(data, Vec2(0.0f), uLens);
            const Vec3 met = ray.at(depth / -glm::dot(ray.direction, data.frame.n)) - data.position;
            radius = std::max(radius, std::hypot(glm::dot(met, data.frame.s), glm::dot(met, data.frame.t)));
        }
        const float circle = 2.0f * radius / camera.viewHeight * 720.0f;
        EXPECT_NEAR(std::fabs(blurPixels(camera, depth, 720)), circle, 0.02f * circle) << depth;
    }
    const SharpRange range = sharpRange(camera, 3.0f, 720);
    EXPECT_NEAR(blurPixels(camera, range.nearLimit, 720), -3.0f, 1e-3f);
    EXPECT_NEAR(blurPixels(camera, range.farLimit, 720), 3.0f, 1e-3f);
}

TEST(Lens, LimitsAreWhereTheCircleIsThatLarge) {
    Camera camera = someCamera();
    constexpr int kHeight = 720;
    const SharpRange range = sharpRange(camera, 3.0f, kHeight);
    EXPECT_NEAR(blurPixels(camera, range.nearLimit, kHeight), -3.0f, 1e-3f);
    EXPECT_NEAR(blurPixels(camera, range.farLimit, kHeight), 3.0f, 1e-3f);
    camera.focalDistance = range.hyperfocal * 1.0001f;
    const SharpRange far = sharpRange(camera, 3.0f, kHeight);
    EXPECT_TRUE(std::isinf(far.farLimit));
    EXPECT_NEAR(far.nearLimit, 0.5f * range.hyperfocal, 1e-3f * range.hyperfocal);
    camera.apertureDiameter = 0.0f;
    EXPECT_TRUE(std::isinf(sharpRange(camera, 3.0f, kHeight).farLimit));
    EXPECT_EQ(sharpRange(camera, 3.0f, kHeight).nearLimit, 0.0f);
    EXPECT_EQ(blurPixels(camera, 1.0f, kHeight), 0.0f);
}

TEST(FocusOverlay, ColoursSayWhatIsSharp) {
    const Camera camera = someCamera();
    const auto at = [](const std::vector<uint8_t>& colors, size_t i) {
        return std::vector<int>(colors.begin() + 4 * static_cast<ptrdiff_t>(i),
                                colors.begin() + 4 * static_cast<ptrdiff_t>(i) + 4);
    };
    // In front, before the cut, behind it, behind, nothing.
    const std::vector<float> depths{1.0f, 1.99f, 2.01f, 8.0f, 0.0f};
    const auto sharp = focusColors(depths, 5, camera, FocusOverlayKind::Sharp, 2.0f, 720);
    EXPECT_EQ(at(sharp, 1), (std::vector<int>{255, 240, 60, 255})) << "the plane in focus cuts here";
    EXPECT_GT(at(sharp, 2)[1], at(sharp, 2)[0]) << "green";
    EXPECT_EQ(at(sharp, 0), at(sharp, 4)) << "blurred";
    const auto blur = focusColors(depths, 5, camera, FocusOverlayKind::Blur, 2.0f, 720);
    EXPECT_EQ(at(blur, 1)[3], 0);
    EXPECT_EQ(at(blur, 2)[3], 0);
    EXPECT_GT(at(blur, 0)[2], at(blur, 0)[0]) << "blue in front";
    EXPECT_GT(at(blur, 3)[0], at(blur, 3)[2]) << "orange behind";
    EXPECT_GT(at(blur, 4)[3], 0) << "the sky is far behind";
    const auto coarse = focusColors({1.5f, 2.5f}, 2, camera, FocusOverlayKind::Sharp, 2.0f, 720);
    EXPECT_NE(at(coarse, 0), at(sharp, 1)) << "two surfaces, not one that is cut";
}

}  // namespace
}  // namespace glint
