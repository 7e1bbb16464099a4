// Surfaces of revolution that shine: their power, and light sampling against rays that merely find them.
#include <numbers>

#include <gtest/gtest.h>

#include "engine/builders/power_distribution.h"
#include "engine/kernels/photon_emission.h"
#include "tests/support/render_scene.h"
#include "tests/support/statistics.h"
#include "tests/support/test_scenes.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

/// A floor under a lamp of the given profile, which is turned over, sheared and stretched.
SceneDescription lampOverFloor(std::vector<Vec2> profile, int degree, const Affine& place, bool bothSides) {
    SceneDescription scene = emptyScene({0, 2.5f, 3.5f}, {0, 0.2f, 0}, 40.0f, 24);
    scene.options.maxDepth = 3;
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape(Vec3(0.0f), {0, 1, 0}, 2, 2),
              diffuseMaterial(0.7f));
    const auto lamp = addObject(&scene, ShapeKind::Revolved, place, emissiveMaterial(Vec3(3.0f), bothSides));
    scene.objects[lamp].profile = std::move(profile);
    scene.objects[lamp].curveDegree = degree;
    return scene;
}

const std::vector<Vec2> kVase{{0.0f, 0.0f}, {0.5f, 0.0f}, {0.7f, 0.5f}, {0.15f, 0.7f},
                              {0.3f, 1.0f}, {0.6f, 1.1f}, {0.0f, 1.3f}};

Affine sheared() {
    Affine place = translate({0.1f, 0.6f, -0.1f}) * rotate(glm::normalize(Vec3(1, 0.3f, 0.2f)), 0.7f) *
                   scale(Vec3(0.8f, 0.5f, 1.1f));
    place.linear[0] += 0.3f * place.linear[1];
    return place;
}

TEST(RevolvedLight, SamplingAgreesWithRaysThatFindIt) {
    constexpr uint32_t kPasses = 96;
    bool bothSides = false;
    for (const Affine& place : {translate({0.0f, 0.7f, 0.0f}) * scale(Vec3(0.7f)), sheared(),
                                sheared() * scale(Vec3(-1.0f, 1.0f, 1.0f))}) {
        const SceneDescription scene = lampOverFloor(kVase, 3, place, bothSides);
        const Estimate found = meanLuminance(renderFilm(scene, kPasses, DirectLightTag::BsdfOnly));
        const Estimate sampled = meanLuminance(renderFilm(scene, kPasses, DirectLightTag::LightOnly));
        const Estimate both = meanLuminance(renderFilm(scene, kPasses));
        EXPECT_TRUE(agree(found, sampled)) << found.mean << " " << sampled.mean;
        EXPECT_TRUE(agree(found, both)) << found.mean << " " << both.mean;
        EXPECT_LT(found.standardError, 0.02 * found.mean);
        bothSides = !bothSides;
    }
}

/// A cone frustum, whose area is known: pi (r + R) times its slant height.
TEST(RevolvedLight, PhotonsCarryRadianceTimesPiTimesArea) {
    constexpr double kInner = 0.2, kOuter = 0.5, kHeight = 0.4;
    const SceneDescription scene =
        lampOverFloor({{0.2f, 0.0f}, {0.5f, 0.4f}}, 1, translate({0, 1, 0}) * scale(Vec3(2.0f)), false);
    const auto built = buildAll(scene);
    const SceneView view = built->view();
    const PowerDistribution power = buildPowerDistribution(view);
    UniformNumbers uniform(7);
    RunningMean flux, height;
    for (int i = 0; i < 20000; ++i) {
        const float uChoice = uniform.next();
        const EmittedPhoton photon =
            emitPhoton<kAllFeatures>(view, power.view(), uChoice, uniform.next2(), uniform.next2());
        flux.add(static_cast<double>(photon.flux.x));
        height.add(static_cast<double>(photon.ray.origin.y - 1.0f) / 2.0);
    }
    const double slant = std::hypot(kHeight, kOuter - kInner);
    const double area = 4.0 * std::numbers::pi * (kInner + kOuter) * slant;
    // The steps of the table are chosen by area, and uniform within: the flux varies by a few per cent.
    EXPECT_NEAR(flux.mean(), 3.0 * std::numbers::pi * area, 4.9 * flux.standardError() + 1e-5 * flux.mean());
    EXPECT_LT(flux.variance(), 0.01 * flux.mean() * flux.mean());
    EXPECT_NEAR(power.totalPower, 3.0 * std::numbers::pi * area, 1e-3 * flux.mean());
    // Flux-weighted mean height: more of the area is where the ring is wide.
    const double weighted = kHeight * (kInner + 2.0 * kOuter) / (3.0 * (kInner + kOuter));
    EXPECT_NEAR(height.mean(), weighted, 4.9 * height.standardError() + 2e-3);
}

}  // namespace
}  // namespace glint::test
