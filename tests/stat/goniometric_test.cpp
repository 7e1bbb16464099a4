// Lights that shine by a picture of their directions: which part of it goes where, that sampling and photons
// carry the same light, and that its power is what leaves them.
#include <gtest/gtest.h>

#include "engine/builders/light_table.h"
#include "engine/builders/power_distribution.h"
#include "engine/builders/scene_builder.h"
#include "engine/kernels/photon_emission.h"
#include "engine/math/color.h"
#include "tests/support/render_scene.h"
#include "tests/support/statistics.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

constexpr float kIntensity = 5.0f;

Texture imageOf(ImageF image, TexelFilter filter) {
    Texture texture;
    texture.name = "picture";
    texture.encoding = ColorEncoding::Linear;
    texture.wrapU = texture.wrapV = WrapMode::Clamp;
    texture.filter = filter;
    texture.image.floats = std::make_shared<const ImageF>(std::move(image));
    return texture;
}

/// Red and green above, blue and white below: a quarter of all directions each.
Texture quarters() { return imageOf({2, 2, {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}}, TexelFilter::Nearest); }

/// The cosine to the direction in its middle, as a small lamp has it.
Texture cosines() {
    constexpr int kSize = 512;
    ImageF image{kSize, kSize, {}};
    for (int i = 0; i < kSize * kSize; ++i) {
        const Vec2 at((static_cast<float>(i % kSize) + 0.5f) / kSize,
                      (static_cast<float>(i / kSize) + 0.5f) / kSize);
        image.rgb.insert(image.rgb.end(), 3, std::max(equalAreaDirection(at).z, 0.0f));
    }
    return imageOf(std::move(image), TexelFilter::Bilinear);
}

SceneDescription lampScene(Texture image, const Vec3& direction, const Vec3& up) {
    SceneDescription scene = emptyScene({0.0f, 1.0f, 0.0f}, {0.01f, 0.0f, 0.0f}, 90.0f, 16);
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape(Vec3(0.0f), {0, 1, 0}, 9.0f, 9.0f),
              diffuseMaterial(0.5f));
    Light light;
    light.kind = LightKind::Goniometric;
    light.position = {0.0f, 2.0f, 0.0f};
    light.direction = direction;
    light.up = up;
    light.strength = kIntensity;
    light.image.texture = 0;
    scene.textures.push_back(std::move(image));
    scene.lights.push_back(light);
    scene.options.maxDepth = 1;
    return scene;
}

TEST(Goniometric, ShinesUprightByItsPicture) {
    const auto built = buildAll(lampScene(quarters(), {0, 0, -3}, {0, 2, 1}));
    const SceneView view = built->view();
    EXPECT_TRUE(built->features & kFeatureProjectors);
    // Seen along -z, +x lies to the right; forwards and backwards alike.
    const struct {
        Vec3 offset, color;
    } places[] = {{{-1, 2, -3}, {1, 0, 0}}, {{1, 0.5f, -3}, {0, 1, 0}}, {{-1, -1, -1}, {0, 0, 1}},
                  {{2, -1, -1}, {1, 1, 1}}, {{-1, 2, 3}, {1, 0, 0}},    {{1, -1, 2}, {1, 1, 1}}};
    for (const auto& [offset, color] : places) {
        const LightSample s =
            sampleDeltaLight<kAllFeatures>(view, view.lights.emitters[0], Vec3(0, 2, 0) + offset);
        EXPECT_LT(glm::length(s.radiance - kIntensity / lengthSquared(offset) * color), 1e-5f)
            << offset.x << ' ' << offset.y << ' ' << offset.z;
        EXPECT_LT(glm::length(s.wiWorld + glm::normalize(offset)), 1e-5f);
    }
}

/// A floor below a small lamp: I h^2 / (h^2 + r^2)^2.
TEST(Goniometric, ACosineLightsAFloorAsASmallLampDoes) {
    const Film film = renderFilm(lampScene(cosines(), {0, -1, 0}, {1, 0, 0}), 16);
    RunningMean expected;
    for (int i = 0; i < 512 * 512; ++i) {  // the picture is 2 by 2 units of the floor
        const double x = (i % 512 + 0.5) / 256.0 - 1.0, z = (i / 512 + 0.5) / 256.0 - 1.0;
        const double r2 = x * x + z * z;
        expected.add(0.5 / std::numbers::pi * static_cast<double>(kIntensity) * 4.0 /
                     ((4.0 + r2) * (4.0 + r2)));
    }
    // The camera looks 0.01 beside its foot: a shift of a hundredth at the same height.
    EXPECT_NEAR(meanLuminance(film).mean, expected.mean(), 2e-3 * expected.mean());
}

TEST(Goniometric, PhotonsCarryItsPower) {
    const struct {
        Texture image;
        double power;
    } lamps[] = {{quarters(), 4.0 * std::numbers::pi * 0.5}, {cosines(), std::numbers::pi}};
    for (const auto& [image, powerOfOne] : lamps) {
        const auto built = buildAll(lampScene(image, {1, -2, -1}, {0, 1, 0}));
        const SceneView view = built->view();
        const PowerDistribution power = buildPowerDistribution(view);
        UniformNumbers random(3);
        RunningMean photons;
        for (int i = 0; i < 400'000; ++i) {
            const EmittedPhoton photon =
                emitPhoton<kAllFeatures>(view, power.view(), random.next(), random.next2(), random.next2());
            photons.add(static_cast<double>(luminance(photon.flux)));
            const LightSample s = sampleDeltaLight<kAllFeatures>(view, view.lights.emitters[0],
                                                                 photon.ray.origin + photon.ray.direction);
            ASSERT_LT(glm::length(photon.flux - 4.0f * kPi * s.radiance),
                      1e-2f * (1.0f + glm::length(photon.flux)))
                << "photons and sampling see the same picture";
        }
        const double expected = static_cast<double>(kIntensity) * powerOfOne;
        EXPECT_NEAR(photons.mean(), expected, kNormalQuantile * photons.standardError() + 1e-3 * expected);
        EXPECT_LT(photons.standardError(), 0.01 * expected);
        EXPECT_NEAR(static_cast<double>(power.totalPower), expected, 1e-3 * expected);
    }
}

TEST(Goniometric, WithoutAPictureIsAPoint) {
    SceneDescription scene = lampScene(quarters(), {0, -1, 0}, {1, 0, 0});
    scene.lights[0].image = {Vec3(0.5f, 1.0f, 0.25f)};
    const Film even = renderFilm(scene, 4);
    scene.lights[0].kind = LightKind::Point;
    scene.lights[0].color = Vec3(0.5f, 1.0f, 0.25f);
    EXPECT_NEAR(meanLuminance(renderFilm(scene, 4)).mean, meanLuminance(even).mean, 1e-6);
}

}  // namespace
}  // namespace glint::test
