// Directions that light sampling finds in environments are distributed as their density says. Chi-square at
// significance 1e-6 each.

#include <gtest/gtest.h>

#include "engine/kernels/light_sampling.h"
#include "engine/math/color.h"
#include "tests/support/cone_grid.h"
#include "tests/support/light_scene.h"
#include "tests/support/statistics.h"
#include "tests/support/uniform_numbers.h"

namespace glint {
namespace {

using test::chiSquare;
using test::ChiSquare;
using test::ConeGrid;
using test::expectedCounts;
using test::LightScene;
using test::UniformNumbers;

/// A dark image with a bright texel, a bright corner at the seam and some texture.
SceneImage spottedImage() {
    auto image = std::make_shared<ImageF>();
    image->width = 16;
    image->height = 8;
    image->rgb.assign(16 * 8 * 3, 0.0f);
    const auto set = [&](int x, int y, float value) {
        for (int c = 0; c < 3; ++c) {
            image->rgb[static_cast<size_t>(3 * (y * 16 + x) + c)] = value;
        }
    };
    for (int x = 0; x < 16; ++x) {
        set(x, 5, 0.5f + 0.1f * static_cast<float>(x % 3));
    }
    set(4, 2, 50.0f);
    set(15, 6, 20.0f);
    set(7, 0, 10.0f);
    return {.floats = image};
}

SceneDescription environmentScene(bool image, float rotationDeg) {
    SceneDescription scene;
    scene.environment.color = Vec3(2.0f);
    scene.environment.rotationDeg = rotationDeg;
    if (image) {
        scene.environmentImages.push_back(spottedImage());
        scene.environment.image = 0;
    }
    return scene;
}

void checkEnvironment(const SceneDescription& description, const LightContext& at) {
    const LightScene scene(description);
    UniformNumbers random(11);
    const ConeGrid grid{Frame::fromNormal(glm::normalize(Vec3(0.2f, 0.9f, -0.3f))), 2.0};
    std::vector<double> counts(ConeGrid::kCells, 0.0);
    constexpr int kImageSamples = 40000;
    for (int i = 0; i < kImageSamples; ++i) {
        const LightSample s = sampleLight<kAllFeatures>(scene.view, at, random.next(), random.next2());
        ASSERT_GT(s.pdfSolidAngle, 0.0f);
        EXPECT_NEAR(pdfLightEnvironment<kAllFeatures>(scene.view, at, s.wiWorld) / s.pdfSolidAngle, 1.0f,
                    2e-2f)
            << "at a cell's edge both sides are right, but hardly ever: sample " << i;
        EXPECT_GE(minComponent(s.radiance), 0.0f);
        counts[grid.cell(s.wiWorld)] += 1.0;
    }
    const auto density = [&](const Vec3& w) {
        return static_cast<double>(pdfLightEnvironment<kAllFeatures>(scene.view, at, w));
    };
    const ChiSquare result = chiSquare(counts, expectedCounts(grid, random, kImageSamples, density));
    EXPECT_TRUE(result.passes()) << result.statistic << " > " << result.critical();
}

TEST(Environment, ImageDirectionsFollowTheirDensity) {
    checkEnvironment(environmentScene(true, 0.0f), {Vec3(0.0f), Vec3(0, 1, 0), false});
    checkEnvironment(environmentScene(true, 77.0f), {Vec3(0.0f), Vec3(0, 1, 0), true});
}

TEST(Environment, ConstantDirectionsFollowTheirDensity) {
    checkEnvironment(environmentScene(false, 0.0f), {Vec3(0.0f), glm::normalize(Vec3(1, 1, 0.3f)), false});
    checkEnvironment(environmentScene(false, 0.0f), {Vec3(0.0f), glm::normalize(Vec3(1, 1, 0.3f)), true});
}

TEST(Environment, EveryBrightDirectionHasDensity) {
    const LightScene scene(environmentScene(true, 30.0f));
    const LightContext at{Vec3(0.0f), Vec3(0, 1, 0), true};
    UniformNumbers random(3);
    int bright = 0;
    for (int i = 0; i < 100000; ++i) {
        const Vec3 w = sampleSphere(random.next2());
        if (luminance(environmentRadiance<kAllFeatures>(scene.view, w)) <= 1e-4f) { continue; }
        ++bright;
        EXPECT_GT(pdfLightEnvironment<kAllFeatures>(scene.view, at, w), 0.0f);
    }
    EXPECT_GT(bright, 1000);
}

TEST(Environment, MiddleLooksAlongMinusZAndRotationTurnsCounterClockwise) {
    SceneDescription scene = environmentScene(true, 0.0f);
    auto image = std::make_shared<ImageF>();
    image->width = 4;
    image->height = 1;
    image->rgb = {1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4};
    scene.environmentImages[0].floats = image;
    scene.environment.color = Vec3(1.0f);
    // Column centres lie at -135, -45, 45 and 135 degrees from -z towards +x.
    const Vec3 right45 = glm::normalize(Vec3(1, 0, -1));
    const Vec3 left45 = glm::normalize(Vec3(-1, 0, -1));
    EXPECT_NEAR(environmentRadiance<kAllFeatures>(LightScene(scene).view, right45).x, 3.0f, 1e-4f);
    EXPECT_NEAR(environmentRadiance<kAllFeatures>(LightScene(scene).view, left45).x, 2.0f, 1e-4f);
    // Seen from above, counter-clockwise takes +x to -z: what was at right45 moves to left45.
    scene.environment.rotationDeg = 90.0f;
    EXPECT_NEAR(environmentRadiance<kAllFeatures>(LightScene(scene).view, left45).x, 3.0f, 1e-4f);
}

}  // namespace
}  // namespace glint
