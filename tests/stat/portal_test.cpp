// Environments that shine through a rectangle alone: what comes through it, how directions are
// distributed within it, and that a room with one window looks as it does without the portal, which only
// says where to look.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/builders/light_table.h"
#include "engine/builders/power_distribution.h"
#include "engine/builders/scene_builder.h"
#include "engine/kernels/photon_emission.h"
#include "engine/math/color.h"
#include "tests/support/cone_grid.h"
#include "tests/support/render_scene.h"
#include "tests/support/sppm_scenes.h"
#include "tests/support/statistics.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

constexpr float kRadiance = 2.0f;

/// A rectangle of 1 by 0.6 at a height of 1, whose light goes down.
std::vector<Vec3> windowAbove() {
    return {{-0.5f, 1.0f, -0.3f}, {0.5f, 1.0f, -0.3f}, {0.5f, 1.0f, 0.3f}, {-0.5f, 1.0f, 0.3f}};
}

/// Far brighter in some texels than in others, and black in half of them.
SceneImage unevenSky() {
    auto sky = std::make_shared<ImageF>(ImageF{32, 16, {}});
    for (int i = 0; i < 32 * 16; ++i) {
        const float light =
            i % 2 == 0 ? 0.0f : (i % 37 == 3 ? 30.0f : 0.5f + 0.1f * static_cast<float>(i % 5));
        sky->rgb.insert(sky->rgb.end(), {light, light, 0.5f * light});
    }
    return {.floats = sky};
}

SceneDescription underWindow(bool hasImage) {
    SceneDescription scene = emptyScene({0.0f, 0.5f, 0.0f}, {0.01f, 0.0f, 0.0f}, 1.0f, 8);
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape(Vec3(0.0f), {0, 1, 0}, 9.0f, 9.0f),
              diffuseMaterial(0.5f));
    scene.environment.color = Vec3(kRadiance);
    scene.environment.portal = windowAbove();
    scene.options.maxDepth = 1;
    if (hasImage) {
        scene.environmentImages.push_back(unevenSky());
        scene.environment.image = 0;
        scene.environment.rotationDeg = 25.0f;
    }
    return scene;
}

/// Of a rectangle of half sides a and b, seen from a patch below its middle at a distance of 1 (Hottel 1931).
double formFactor(double a, double b) {
    const double x = std::sqrt(1.0 + a * a), y = std::sqrt(1.0 + b * b);
    return 4.0 / (2.0 * std::numbers::pi) * (a / x * std::atan(b / x) + b / y * std::atan(a / y));
}

/// The floor's light is that of a lamp as large as the portal, by each way to find it.
TEST(Portal, LightsAFloorAsALampOfItsShapeWould) {
    const double expected = static_cast<double>(kRadiance) * 0.5 * formFactor(0.5, 0.3);
    for (const DirectLightTag way :
         {DirectLightTag::Mis, DirectLightTag::LightOnly, DirectLightTag::BsdfOnly}) {
        const Estimate floor =
            meanLuminance(renderFilm(underWindow(false), way == DirectLightTag::BsdfOnly ? 1024 : 64, way));
        EXPECT_NEAR(floor.mean, expected, kNormalQuantile * floor.standardError + 1e-3 * expected);
        EXPECT_LT(floor.standardError, 0.02 * expected);
    }
}

/// Above it the sky is black, beside it and from behind no light comes.
TEST(Portal, NothingComesButThroughIt) {
    const auto built = buildAll(underWindow(false));
    const SceneView view = built->view();
    EXPECT_TRUE(built->features & kFeaturePortal);
    const auto seen = [&](const Vec3& from, const Vec3& towards) {
        return environmentRadiance<kAllFeatures>(view, from, glm::normalize(towards - from)).x;
    };
    EXPECT_EQ(seen({0, 0, 0}, {0.49f, 1.0f, 0.29f}), kRadiance);
    EXPECT_EQ(seen({0, 0, 0}, {0.49f, 1.0f, 0.31f}), 0.0f);
    EXPECT_EQ(seen({0, 0, 0}, {0.51f, 1.0f, 0.29f}), 0.0f);
    EXPECT_EQ(seen({3, -2, 1}, {-0.49f, 1.0f, -0.29f}), kRadiance);
    EXPECT_EQ(seen({0, 2, 0}, {0, 3, 0}), 0.0f);
    EXPECT_EQ(seen({0, 2, 0}, {0, 1, 0}), 0.0f);
    const LightContext above{{0, 2, 0}, {0, -1, 0}, true};
    EXPECT_EQ(sampleLight<kAllFeatures>(view, above, 0.5f, Vec2(0.5f)).pdfSolidAngle, 0.0f);
}

void expectDensity(const SceneDescription& scene, const Vec3& from) {
    const auto built = buildAll(scene);
    const SceneView view = built->view();
    const LightContext at{from, {0, 1, 0}, true};
    // A cone around all corners.
    const Vec3 axis = glm::normalize(Vec3(0, 1, 0) - from);
    double oneMinusCos = 0.0;
    for (const Vec3& corner : scene.environment.portal) {
        oneMinusCos =
            std::max(oneMinusCos, 1.0 - static_cast<double>(glm::dot(axis, glm::normalize(corner - from))));
    }
    const ConeGrid grid{Frame::fromNormal(axis), 1.001 * oneMinusCos};
    UniformNumbers random(7);
    constexpr int kSamples = 60000;
    std::vector<double> counts(ConeGrid::kCells, 0.0);
    int unlike = 0;
    for (int i = 0; i < kSamples; ++i) {
        const LightSample s = sampleLight<kAllFeatures>(view, at, random.next(), random.next2());
        ASSERT_GT(s.pdfSolidAngle, 0.0f);
        const float pdf = pdfLightEnvironment<kAllFeatures>(view, at, s.wiWorld);
        unlike += std::fabs(pdf / s.pdfSolidAngle - 1.0f) > 1e-3f;
        counts[grid.cell(s.wiWorld)] += 1.0;
    }
    EXPECT_LT(unlike, 20) << "samples at the edges of cells or of the portal";
    const auto density = [&](const Vec3& w) {
        return static_cast<double>(pdfLightEnvironment<kAllFeatures>(view, at, w));
    };
    std::vector<double> expected = expectedCounts(grid, random, kSamples, density);
    double sum = 0.0;
    for (const double count : expected) {
        sum += count;
    }
    EXPECT_NEAR(sum, kSamples, 0.01 * kSamples) << "the density does not integrate to one";
    for (double& count : expected) {
        count *= kSamples / sum;
    }
    const ChiSquare result = chiSquare(counts, expected, 20.0);
    EXPECT_TRUE(result.passes()) << result.statistic << " > " << result.critical();
}

TEST(Portal, DirectionsFollowTheirDensity) {
    for (const bool hasImage : {false, true}) {
        const SceneDescription scene = underWindow(hasImage);
        expectDensity(scene, {0.0f, 0.0f, 0.0f});
        expectDensity(scene, {2.0f, 0.3f, -1.0f});
        expectDensity(scene, {0.1f, 0.8f, 0.1f});
    }
}

/// What light sampling finds, by uniform directions.
TEST(Portal, SamplingIsUnbiased) {
    for (const bool hasImage : {false, true}) {
        const auto built = buildAll(underWindow(hasImage));
        const SceneView view = built->view();
        const LightContext at{{0.3f, 0.2f, -0.2f}, {0, 1, 0}, false};
        UniformNumbers random(9);
        RunningMean sampled, uniform;
        for (int i = 0; i < 400'000; ++i) {
            const LightSample s = sampleLight<kAllFeatures>(view, at, random.next(), random.next2());
            ASSERT_GT(s.pdfSolidAngle, 0.0f);
            sampled.add(static_cast<double>(luminance(s.radiance) * s.wiWorld.y / s.pdfSolidAngle));
            for (int k = 0; k < 6; ++k) {
                const Vec3 w = sampleCosineHemisphere(random.next2());
                uniform.add(static_cast<double>(
                    luminance(environmentRadiance<kAllFeatures>(view, at.p, Vec3(w.x, w.z, w.y))) * kPi));
            }
        }
        EXPECT_NEAR(sampled.mean(), uniform.mean(),
                    kNormalQuantile * std::hypot(sampled.standardError(), uniform.standardError()));
        EXPECT_LT(uniform.standardError(), 0.006 * uniform.mean());
        EXPECT_LT(sampled.standardError(), uniform.standardError()) << "of a sixth of the samples";
    }
}

/// What falls on the portal, by uniform directions, is the power that photons are shared out by, and what
/// they carry; they fly away from its front, and begin on it.
TEST(Portal, PhotonsCarryItsPower) {
    for (const bool hasImage : {false, true}) {
        const auto built = buildAll(underWindow(hasImage));
        const SceneView view = built->view();
        const PowerDistribution power = buildPowerDistribution(view);
        UniformNumbers random(3);
        RunningMean falling, photons;
        for (int i = 0; i < 400'000; ++i) {
            const Vec3 w = sampleCosineHemisphere(random.next2());
            falling.add(static_cast<double>(
                luminance(environmentRadiance<kAllFeatures>(view, Vec3(w.x, w.z, w.y))) * kPi * 0.6f));
            const EmittedPhoton photon =
                emitPhoton<kAllFeatures>(view, power.view(), random.next(), random.next2(), random.next2());
            photons.add(static_cast<double>(luminance(photon.flux)));
            ASSERT_LT(photon.ray.direction.y, 0.0f);
            ASSERT_TRUE(photon.ray.origin.y == 1.0f && std::fabs(photon.ray.origin.x) <= 0.5f &&
                        std::fabs(photon.ray.origin.z) <= 0.3f);
        }
        EXPECT_NEAR(photons.mean(), falling.mean(),
                    kNormalQuantile * std::hypot(photons.standardError(), falling.standardError()) + 1e-6);
        EXPECT_LT(falling.standardError(), 0.01 * falling.mean());
        EXPECT_NEAR(static_cast<double>(power.totalPower), falling.mean(),
                    kNormalQuantile * falling.standardError() + 2e-3 * falling.mean());
    }
}

/// A closed room whose only opening has the portal.
TEST(Portal, ARoomWithOneWindowLooksAsWithout) {
    SceneDescription scene = portalBox();
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0.0f, 1.0f, 1.0f}, {0, 0, -1}, 1.0f, 1.0f),
              diffuseMaterial(0.6f));
    scene.camera.position = {0.0f, 1.0f, 0.95f};
    scene.camera.target = {0.0f, 1.0f, 0.0f};
    scene.camera.verticalFovDeg = 85.0f;
    scene.options.sampler = SamplerKind::Independent;
    const Film through = renderFilm(scene, 256);
    scene.environment.portal.clear();
    const Film everywhere = renderFilm(scene, 1024);
    for (int block = 0; block < 16; ++block) {
        const int x = block % 4 * 8, y = block / 4 * 8;
        const Estimate a = meanLuminance(through, x, y, x + 8, y + 8),
                       b = meanLuminance(everywhere, x, y, x + 8, y + 8);
        EXPECT_TRUE(agree(a, b)) << "block " << block << ": " << a.mean << " and " << b.mean << " +- "
                                 << a.standardError << " and " << b.standardError;
        EXPECT_LT(b.standardError, 0.05 * b.mean);
    }
    const Estimate a = meanLuminance(through), b = meanLuminance(everywhere);
    EXPECT_LT(a.standardError, b.standardError) << "in a quarter of the passes";
}

TEST(Portal, AnotherSkyOrTurnIsSeenByTheLight) {
    SceneDescription scene = underWindow(true);
    const auto before = buildAll(scene);
    scene.environment.portal[0].x -= 1.0f;
    scene.environment.portal[3].x -= 1.0f;
    SceneEdit edit;
    edit.kinds = EditKind::Lights;
    edit.scene = std::make_shared<SceneDescription>(scene);
    const auto wider = buildScene(edit, before.get(), 1, nullptr, nullptr);
    ASSERT_TRUE(wider);
    EXPECT_EQ((*wider)->lights->portalSums, before->lights->portalSums) << "it is turned as before";
    EXPECT_FLOAT_EQ((*wider)->lights->portal.area, 1.2f);
    scene.environment.rotationDeg += 10.0f;
    edit.scene = std::make_shared<SceneDescription>(scene);
    const auto turned = buildScene(edit, before.get(), 1, nullptr, nullptr);
    ASSERT_TRUE(turned);
    EXPECT_NE((*turned)->lights->portalSums, before->lights->portalSums);
    scene.environment.portal[0].y += 0.1f;
    edit.scene = std::make_shared<SceneDescription>(scene);
    const auto bent = buildScene(edit, before.get(), 1, nullptr, nullptr);
    ASSERT_FALSE(bent);
    EXPECT_NE(bent.error().message.find("no rectangle"), std::string::npos);
}

}  // namespace
}  // namespace glint::test
