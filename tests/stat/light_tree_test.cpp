// Choosing among lights: probabilities sum to 1, are met by the frequencies, never miss a light that shines,
// and with thousands of lights give less variance than a uniform choice. Chi-square at significance 1e-6.

#include <gtest/gtest.h>

#include "engine/kernels/light_sampling.h"
#include "engine/math/color.h"
#include "tests/support/light_scene.h"
#include "tests/support/statistics.h"
#include "tests/support/uniform_numbers.h"

namespace glint {
namespace {

using test::LightScene;
using test::RunningMean;
using test::UniformNumbers;

/// A soup of emissive triangles, and one light of every other kind.
SceneDescription mixedLights(uint32_t triangles, bool bothSides) {
    SceneDescription scene;
    scene.materials.push_back(emissiveMaterial(Vec3(1.0f, 2.0f, 0.5f), bothSides));
    if (triangles > 0) {
        scene.meshes.push_back({"soup", {}, test::triangleSoup(triangles, 0.1f, 4)});
        Object soup;
        soup.shape = ShapeKind::Mesh;
        soup.mesh = 0;
        scene.objects.push_back(soup);
    }
    for (const ShapeKind shape : {ShapeKind::Sphere, ShapeKind::Rectangle, ShapeKind::Disc}) {
        Object object;
        object.shape = shape;
        object.objectToWorld = translate({1.5f, 0.3f * static_cast<float>(shape), -0.4f}) * scale(Vec3(0.1f));
        scene.objects.push_back(object);
    }
    Light light;
    light.position = {0.4f, -1.3f, 0.2f};
    scene.lights.push_back(light);
    light.kind = LightKind::Spot;
    light.direction = {0.2f, 1, 0};
    scene.lights.push_back(light);
    light.kind = LightKind::Directional;
    scene.lights.push_back(light);
    scene.environment.color = Vec3(0.2f);
    return scene;
}

LightContext randomContext(UniformNumbers& random, bool bothSides) {
    const Vec3 p(random.next(), random.next(), random.next());
    return {3.0f * p - Vec3(1.5f), sampleSphere(random.next2()), bothSides};
}

double probabilitySum(const LightScene& scene, const LightContext& at) {
    double sum = 0.0;
    for (uint32_t i = 0; i < scene.view.lights.emitters.count; ++i) {
        sum += static_cast<double>(lightProbability<kAllFeatures>(scene.view.lights, at, i));
    }
    return sum;
}

TEST(LightChoice, ProbabilitiesSumToOne) {
    UniformNumbers random(1);
    for (const uint32_t triangles : {0u, 500u}) {
        const LightScene scene(mixedLights(triangles, true));
        EXPECT_EQ(scene.view.lights.usesTree, triangles > 0);
        for (int i = 0; i < 200; ++i) {
            EXPECT_NEAR(probabilitySum(scene, randomContext(random, true)), 1.0, 1e-4);
        }
    }
    // On an opaque surface a branch may turn out to hold no light that reaches it; what is lost there
    // lights nothing.
    const LightScene oneSided(mixedLights(500, false));
    for (int i = 0; i < 200; ++i) {
        EXPECT_LE(probabilitySum(oneSided, randomContext(random, false)), 1.0 + 1e-4);
    }
}

TEST(LightChoice, FrequenciesMeetTheProbabilities) {
    UniformNumbers random(2);
    for (const uint32_t triangles : {0u, 300u}) {
        const LightScene scene(mixedLights(triangles, true));
        const LightView& lights = scene.view.lights;
        for (int trial = 0; trial < 5; ++trial) {
            const LightContext at = randomContext(random, true);
            constexpr int kSamples = 200000;
            std::vector<double> counts(lights.emitters.count, 0.0), expected;
            for (int i = 0; i < kSamples; ++i) {
                const LightChoice choice = chooseLight<kAllFeatures>(lights, at, random.next());
                counts[choice.emitter] += 1.0;
                const float probability = lightProbability<kAllFeatures>(lights, at, choice.emitter);
                ASSERT_NEAR(choice.probability / probability, 1.0f, 1e-3f);
            }
            for (uint32_t i = 0; i < lights.emitters.count; ++i) {
                expected.push_back(kSamples *
                                   static_cast<double>(lightProbability<kAllFeatures>(lights, at, i)));
            }
            const test::ChiSquare result = test::chiSquare(counts, expected);
            EXPECT_TRUE(result.passes()) << result.statistic << " > " << result.critical();
        }
    }
}

TEST(LightChoice, NoLightThatShinesIsMissed) {
    UniformNumbers random(3);
    for (const bool bothSides : {false, true}) {
        const LightScene scene(mixedLights(400, bothSides));
        const LightView& lights = scene.view.lights;
        int shining = 0;
        for (int i = 0; i < 50000; ++i) {
            const LightContext at = randomContext(random, false);
            const auto emitter =
                static_cast<uint32_t>(random.next() * static_cast<float>(lights.emitters.count));
            const LightSample s =
                sampleEmitter<kAllFeatures>(scene.view, at, lights.emitters[emitter], random.next2());
            if (!(s.pdfSolidAngle > 0.0f) || glm::dot(s.wiWorld, at.n) < 1e-3f || isZero(s.radiance)) {
                continue;
            }
            if (!s.isDelta && !s.isInfinite && absDot(s.wiWorld, s.pointNormal) < 1e-3f) { continue; }
            ++shining;
            EXPECT_GT(lightProbability<kAllFeatures>(lights, at, emitter), 0.0f) << emitter;
        }
        EXPECT_GT(shining, 5000);
    }
}

/// Irradiance by one sample with a light from the tree, and with one drawn uniformly.
TEST(LightChoice, TreeBeatsUniformChoiceAmongThousands) {
    SceneDescription description;
    description.materials.push_back(emissiveMaterial(Vec3(1.0f), false));
    description.meshes.push_back({"soup", {}, test::triangleSoup(5000, 0.02f, 8)});
    Object soup;
    soup.shape = ShapeKind::Mesh;
    soup.mesh = 0;
    soup.objectToWorld = scale(Vec3(10.0f, 1.0f, 10.0f));
    description.objects.push_back(soup);
    const LightScene scene(description);
    const LightView& lights = scene.view.lights;
    UniformNumbers random(4);
    for (const float x : {-8.0f, 0.5f, 6.0f}) {
        const LightContext at{Vec3(x, -1.2f, 0.3f), Vec3(0, 1, 0), false};
        RunningMean byTree, uniformly;
        const auto value = [&](const LightSample& s) {
            if (!(s.pdfSolidAngle > 0.0f)) { return 0.0; }
            return static_cast<double>(luminance(s.radiance) * std::fmax(0.0f, glm::dot(s.wiWorld, at.n)) /
                                       s.pdfSolidAngle);
        };
        for (int i = 0; i < 200000; ++i) {
            byTree.add(value(sampleLight<kAllFeatures>(scene.view, at, random.next(), random.next2())));
            const auto emitter = static_cast<uint32_t>(random.next() * 5000.0f);
            LightSample s =
                sampleEmitter<kAllFeatures>(scene.view, at, lights.emitters[emitter], random.next2());
            s.pdfSolidAngle /= 5000.0f;
            uniformly.add(value(s));
        }
        const double error = std::hypot(byTree.standardError(), uniformly.standardError());
        EXPECT_NEAR(byTree.mean(), uniformly.mean(), test::kNormalQuantile * error);
        EXPECT_LT(10.0 * byTree.variance(), uniformly.variance());
    }
}

TEST(LightTree, IsTheSameForAnyNumberOfThreads) {
    const SceneDescription scene = mixedLights(3000, false);
    const auto one = buildLightTable(scene, {}, nullptr, 1);
    const auto three = buildLightTable(scene, {}, nullptr, 3);
    ASSERT_EQ(one->nodes.size(), three->nodes.size());
    for (size_t i = 0; i < one->nodes.size(); ++i) {
        ASSERT_EQ(one->nodes[i].center, three->nodes[i].center);
        ASSERT_EQ(one->nodes[i].child, three->nodes[i].child);
        ASSERT_EQ(one->nodes[i].intensity, three->nodes[i].intensity);
    }
    EXPECT_EQ(one->emitterNodes, three->emitterNodes);
}

}  // namespace
}  // namespace glint
