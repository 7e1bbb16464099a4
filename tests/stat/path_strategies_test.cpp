// Light sampling, BSDF sampling and their combination have one expectation; so do few lights and many,
// and every feature mask. Blocks of pictures are compared at significance 1e-6 with errors estimated from
// the films.

#include <gtest/gtest.h>

#include "engine/kernels/light_sampling.h"
#include "engine/render/cpu_variants.h"
#include "engine/render/pass_params.h"
#include "engine/render/path_replay.h"
#include "tests/support/light_scene.h"
#include "tests/support/render_scene.h"
#include "tests/support/test_scenes.h"

namespace glint {
namespace {

using test::Estimate;

constexpr int kSize = 32;
constexpr int kBlock = 8;

void expectSameBlocks(const Film& a, const Film& b, const char* what) {
    for (int y = 0; y < a.height(); y += kBlock) {
        for (int x = 0; x < a.width(); x += kBlock) {
            const Estimate ea = test::meanLuminance(a, x, y, x + kBlock, y + kBlock);
            const Estimate eb = test::meanLuminance(b, x, y, x + kBlock, y + kBlock);
            EXPECT_TRUE(test::agree(ea, eb, 1e-3))
                << what << " block " << x << "," << y << ": " << ea.mean << " +- " << ea.standardError
                << " and " << eb.mean << " +- " << eb.standardError;
        }
    }
}

/// A floor and a back wall.
SceneDescription corner() {
    SceneDescription scene = emptyScene({0, 1.2f, 4}, {0, 0.6f, 0}, 45, kSize);
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0, 0, 0}, {0, 1, 0}, 3, 3),
              diffuseMaterial(0.6f));
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0, 1, -2}, {0, 0, 1}, 3, 3),
              diffuseMaterial(0.4f));
    scene.options.maxDepth = 4;
    return scene;
}

/// Lamps that are large, so that BSDF sampling alone finds them as well.
SceneDescription emittersOfEveryShape() {
    SceneDescription scene = corner();
    const auto emitter = [](float radiance, bool both = false) {
        return emissiveMaterial(Vec3(radiance), both);
    };
    Affine sheared = translate({1.6f, 1.6f, -0.5f}) * scale(Vec3(0.5f));
    sheared.linear[1] += 0.6f * sheared.linear[0];
    addObject(&scene, ShapeKind::Sphere, translate({-1.5f, 1.5f, 0}) * scale(Vec3(0.5f)), emitter(2));
    addObject(&scene, ShapeKind::Sphere, translate({0, 1.8f, -1}) * scale(Vec3(0.9f, 0.2f, 0.5f)),
              emitter(3));
    addObject(&scene, ShapeKind::Rectangle, sheared, emitter(3, true));
    addObject(&scene, ShapeKind::Disc, placeFlatShape({-0.6f, 2.2f, 1}, {0.3f, -1, -0.2f}, 0.8f, 0.4f),
              emitter(4));
    addMeshObject(&scene, *test::triangleSoup(3, 0.6f, 5),
                  translate({0.8f, 0.9f, 0.6f}) * scale(Vec3(-0.4f, 0.4f, 0.4f)), emitter(5, true));
    return scene;
}

/// Rough metal, rough glass, plastic and coated paint under an environment image and one lamp.
SceneDescription glossyUnderSky() {
    SceneDescription scene = corner();
    Material metal = diffuseMaterial(1.0f);
    metal.kind = MaterialKind::Conductor;
    metal.roughness.value = 0.4f;
    Material glass = diffuseMaterial(1.0f);
    glass.kind = MaterialKind::Dielectric;
    glass.roughness.value = 0.4f;
    Material plastic = diffuseMaterial(0.6f);
    plastic.kind = MaterialKind::Plastic;
    plastic.roughness.value = 0.3f;
    Material paint = diffuseMaterial(0.6f);
    paint.kind = MaterialKind::Principled;
    paint.roughness.value = 0.4f;
    paint.metallic.value = 0.5f;
    paint.clearcoat.value = 1.0f;
    paint.clearcoatRoughness.value = 0.2f;
    paint.sheenColor.value = Vec3(0.5f);
    addObject(&scene, ShapeKind::Sphere, translate({0, 0.5f, 1.2f}) * scale(Vec3(0.5f)), paint);
    addObject(&scene, ShapeKind::Sphere, translate({-1.1f, 0.5f, 0}) * scale(Vec3(0.5f)), metal);
    addObject(&scene, ShapeKind::Sphere, translate({0, 0.5f, 0}) * scale(Vec3(0.5f)), glass);
    addObject(&scene, ShapeKind::Sphere, translate({1.1f, 0.5f, 0}) * scale(Vec3(0.5f)), plastic);
    addObject(&scene, ShapeKind::Sphere, translate({0, 2, 0.5f}) * scale(Vec3(0.4f)),
              emissiveMaterial(Vec3(4.0f), false));
    auto image = std::make_shared<ImageF>();
    image->width = 16;
    image->height = 8;
    for (int i = 0; i < 16 * 8; ++i) {
        const float value = i % 16 > 5 && i % 16 < 9 && i / 16 < 4 ? 2.0f : 0.3f;
        image->rgb.insert(image->rgb.end(), {value, value, 0.5f * value});
    }
    scene.environmentImages.push_back({.floats = image});
    scene.environment.image = 0;
    scene.environment.color = Vec3(1.0f);
    scene.environment.rotationDeg = 160.0f;
    return scene;
}

void expectStrategiesAgree(const SceneDescription& scene, uint32_t passes) {
    const Film mis = test::renderFilm(scene, passes, DirectLightTag::Mis);
    const Film light = test::renderFilm(scene, passes, DirectLightTag::LightOnly);
    const Film bsdf = test::renderFilm(scene, passes, DirectLightTag::BsdfOnly);
    EXPECT_GT(test::meanLuminance(mis).mean, 0.01);
    expectSameBlocks(mis, light, "light");
    expectSameBlocks(mis, bsdf, "bsdf");
}

TEST(Strategies, AgreeOnEmittersOfEveryShape) { expectStrategiesAgree(emittersOfEveryShape(), 128); }
TEST(Strategies, AgreeOnGlossySurfacesUnderSky) { expectStrategiesAgree(glossyUnderSky(), 128); }

TEST(Strategies, AgreeOnManyLights) {
    SceneDescription scene = corner();
    addMeshObject(&scene, *test::triangleSoup(300, 0.3f, 9), translate({0, 1.4f, 0}),
                  emissiveMaterial(Vec3(0.8f), false));
    Light point;
    point.position = {1, 0.3f, 1};
    scene.lights.push_back(point);
    scene.environment.color = Vec3(0.1f);
    expectStrategiesAgree(scene, 64);
}

/// MIS is there for its variance: no worse than the better of the two by much, anywhere.
TEST(Strategies, CombiningThemKeepsTheBetterOnesVariance) {
    const SceneDescription scene = emittersOfEveryShape();
    const double mis = test::renderFilm(scene, 64, DirectLightTag::Mis).relativeErrorEstimate();
    const double light = test::renderFilm(scene, 64, DirectLightTag::LightOnly).relativeErrorEstimate();
    const double bsdf = test::renderFilm(scene, 64, DirectLightTag::BsdfOnly).relativeErrorEstimate();
    EXPECT_LT(mis, 1.05 * std::min(light, bsdf));
}

TEST(Roulette, ChangesNoExpectation) {
    SceneDescription scene = test::cornellBox();
    scene.options.rouletteStartDepth = 0;
    const Film early = test::renderFilm(scene, 64);
    scene.options.rouletteStartDepth = 100;
    const Film never = test::renderFilm(scene, 64);
    expectSameBlocks(early, never, "roulette");
    EXPECT_LT(early.rays(), never.rays());
}

/// Masks leave code out; what stays may round differently in a last place, and paths part there now and then.
TEST(Variants, LargerMasksGiveTheSameImageButForRounding) {
    const SceneDescription scene = test::cornellBox();
    const auto built = test::buildAll(scene);
    ASSERT_NE(built, nullptr);
    PassParams params = passParamsOf(scene);
    const PixelRect all{0, 0, params.width, params.height};
    const auto count = static_cast<size_t>(params.width * params.height);
    const KernelVariant& smallest = chooseVariant(kernelVariants(), built->features, params.sampler);
    EXPECT_NE(smallest.mask, kAllFeatures);
    std::vector<PixelSample> expected(count), found(count);
    smallest.renderTile(built->view(), params, all, expected.data());
    for (const KernelVariant& variant : kernelVariants()) {
        if ((built->features & ~variant.mask) != 0) { continue; }
        variant.renderTile(built->view(), params, all, found.data());
        size_t different = 0;
        for (size_t i = 0; i < count; ++i) {
            different += glm::length(found[i].radiance - expected[i].radiance) > 1e-3f ||
                         found[i].rays != expected[i].rays;
        }
        EXPECT_LE(different, count / 100) << variant.name;
    }
}

TEST(Replay, RepeatsTheSampleAndNamesEveryVertex) {
    const SceneDescription scene = test::allMaterials();
    const auto built = test::buildAll(scene);
    ASSERT_NE(built, nullptr);
    PassParams params = passParamsOf(scene);
    params.pass = 3;
    const auto count = static_cast<size_t>(params.width * params.height);
    std::vector<PixelSample> samples(count);
    chooseVariant(kernelVariants(), built->features, params.sampler)
        .renderTile(built->view(), params, {0, 0, params.width, params.height}, samples.data());
    for (int y = 0; y < params.height; y += 7) {
        for (int x = 0; x < params.width; x += 5) {
            const PathReplay replay = replayPath(built->view(), built->features, params, x, y);
            const PixelSample& sample = samples[static_cast<size_t>(y * params.width + x)];
            ASSERT_EQ(replay.sample.radiance, sample.radiance) << x << "," << y;
            ASSERT_EQ(replay.sample.rays, sample.rays);
            Vec3 sum(0.0f);
            for (const PathEvent& event : replay.events) {
                const bool adds = event.kind == PathEventKind::Emission ||
                                  event.kind == PathEventKind::Escape || event.kind == PathEventKind::Light;
                if (adds) { sum += event.value; }
            }
            EXPECT_EQ(sum, replay.events.back().value)
                << "the events tell where all of the radiance came from";
        }
    }
    const std::string text =
        formatPathLog(replayPath(built->view(), built->features, params, params.width / 2, params.height / 2),
                      params, params.width / 2, params.height / 2);
    EXPECT_NE(text.find("camera ray from"), std::string::npos);
    EXPECT_NE(text.find("vertex 0: object"), std::string::npos);
    EXPECT_NE(text.find("radiance ("), std::string::npos);
}

TEST(Faults, OverflowIsDroppedCountedAndReplayed) {
    SceneDescription scene = emptyScene({0, 0, 0.5f}, {1, 0, 0}, 40, 8);
    Material material = emissiveMaterial(Vec3(3e38f), true);
    material.color.value = Vec3(0.9f);
    addObject(&scene, ShapeKind::Sphere, scale(Vec3(2.0f)), material);
    const Film film = test::renderFilm(scene, 2);
    EXPECT_EQ(film.faultCounts()[static_cast<size_t>(SampleFault::Infinite)], 128u);
    EXPECT_EQ(film.pixels()[0].count, 0u);
    const auto built = test::buildAll(scene);
    const PassParams params = passParamsOf(scene);
    const PathReplay replay = replayPath(built->view(), built->features, params, 1, 2);
    EXPECT_EQ(replay.sample.fault, SampleFault::Infinite);
    EXPECT_EQ(replay.sample.radiance, Vec3(0.0f));
    EXPECT_NE(formatPathLog(replay, params, 1, 2).find("dropped: infinite"), std::string::npos);
}

TEST(FireflyClamp, LimitsSamplesAndNothingElse) {
    SceneDescription scene = test::cornellBox();
    const double full = test::meanLuminance(test::renderFilm(scene, 8)).mean;
    scene.options.fireflyClamp = 1e6f;
    EXPECT_EQ(test::meanLuminance(test::renderFilm(scene, 8)).mean, full);
    scene.options.fireflyClamp = 0.5f;
    const Film clamped = test::renderFilm(scene, 8);
    EXPECT_LT(test::meanLuminance(clamped).mean, full);
    for (const FilmPixel& pixel : clamped.pixels()) {
        EXPECT_LE(pixel.mean[0], 0.5001);
    }
}

TEST(Aovs, ShowTheFirstHit) {
    SceneDescription scene = emptyScene({0, 0, 5}, {0, 0, 0}, 20, 8);
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0, 0, -1}, {0, 0, 1}, 0.4f, 9),
              diffuseMaterial(0.3f));
    const auto built = test::buildAll(scene);
    ASSERT_NE(built, nullptr);
    const PassParams params = passParamsOf(scene);
    std::vector<AovSample> aovs(64);
    chooseVariant(kernelVariants(), built->features, params.sampler)
        .renderAovTile(built->view(), params, {0, 0, 8, 8}, aovs.data());
    const AovSample& hit = aovs[4 * 8 + 4];
    EXPECT_NEAR(hit.depth, 6.0f, 1e-5f);
    EXPECT_EQ(hit.shadingNormal, Vec3(0, 0, 1));
    EXPECT_EQ(hit.geometricNormal, Vec3(0, 0, 1));
    EXPECT_EQ(hit.albedo, Vec3(0.3f));
    EXPECT_EQ(hit.objectId, 1u);
    EXPECT_EQ(hit.materialId, 1u);
    EXPECT_EQ(aovs[0].objectId, 0u);
    EXPECT_EQ(aovs[0].depth, 0.0f);
}

}  // namespace
}  // namespace glint
