// Lights that show a picture: it lies upright on what they light, sampling and photons carry the same light,
// and its power is what leaves them.
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

constexpr float kStrength = 5.0f;

/// Red and green above, blue and white below.
Texture quarters() {
    Texture texture;
    texture.name = "quarters";
    texture.encoding = ColorEncoding::Linear;
    texture.wrapU = texture.wrapV = WrapMode::Clamp;
    texture.filter = TexelFilter::Nearest;
    texture.image.floats = std::make_shared<const ImageF>(ImageF{2, 2, {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}});
    return texture;
}

/// 53.13 degrees across: half a unit each side at a distance of 1.
Light projector(const Vec3& position, const Vec3& direction) {
    Light light;
    light.kind = LightKind::Projector;
    light.position = position;
    light.direction = direction;
    light.strength = kStrength;
    light.fovDeg = 2.0f * std::atan(0.5f) * 180.0f / kPi;
    return light;
}

/// A wall at z = -3, seen from where the projector stands, as wide as its picture and half as wide again.
SceneDescription wallScene(bool hasImage) {
    SceneDescription scene = emptyScene(Vec3(0.0f), {0, 0, -1}, 2.0f * std::atan(0.75f) * 180.0f / kPi, 24);
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0, 0, -3}, {0, 0, 1}, 9.0f, 9.0f),
              diffuseMaterial(0.5f));
    scene.lights.push_back(projector(Vec3(0.0f), {0, 0, -4}));
    if (hasImage) {
        scene.textures.push_back(quarters());
        scene.lights[0].image.texture = 0;
    }
    scene.options.maxDepth = 1;
    return scene;
}

Vec3 meanColor(const Film& film, int x0, int y0, int x1, int y1) {
    glm::dvec3 sum(0.0);
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
            const auto& mean = film.pixels()[static_cast<size_t>(y * film.width() + x)].mean;
            sum += glm::dvec3(mean[0], mean[1], mean[2]);
        }
    }
    return Vec3(sum / static_cast<double>((x1 - x0) * (y1 - y0)));
}

/// The wall has its strength over the square of its distance, everywhere, times its albedo over pi.
TEST(Projector, LightsAWallEvenlyAndUpright) {
    const float even = 0.5f / kPi * kStrength / 9.0f;
    const Film film = renderFilm(wallScene(true), 4);
    // Of 24 pixels, the picture takes the 16 in the middle.
    const struct {
        int x, y;
        Vec3 color;
    } places[] = {{5, 5, {1, 0, 0}}, {13, 5, {0, 1, 0}}, {5, 13, {0, 0, 1}}, {13, 13, {1, 1, 1}}};
    for (const auto& [x, y, color] : places) {
        const Vec3 seen = meanColor(film, x, y, x + 6, y + 6);
        EXPECT_LT(glm::length(seen - even * color), 1e-4f * even) << x << ' ' << y;
    }
    EXPECT_EQ(meanColor(film, 0, 0, 24, 3), Vec3(0.0f));
    EXPECT_EQ(meanColor(film, 21, 0, 24, 24), Vec3(0.0f));
    SceneDescription plain = wallScene(false);
    plain.lights[0].image.value = Vec3(0.5f, 1.0f, 0.25f);
    plain.lights[0].aspect = 2.0f;
    const Film flat = renderFilm(plain, 4);
    EXPECT_LT(glm::length(meanColor(flat, 5, 9, 19, 15) - even * Vec3(0.5f, 1.0f, 0.25f)), 1e-4f * even);
    EXPECT_EQ(meanColor(flat, 0, 0, 24, 7), Vec3(0.0f));
}

/// Its intensity over all directions, by uniform ones, is the power that photons are shared out by, and what
/// they carry.
TEST(Projector, PhotonsCarryItsPower) {
    SceneDescription scene = wallScene(true);
    scene.lights[0].aspect = 1.5f;
    scene.lights[0].direction = {1, -2, -1};
    const auto built = buildAll(scene);
    const SceneView view = built->view();
    const PowerDistribution power = buildPowerDistribution(view);
    UniformNumbers random(3);
    RunningMean directions, photons;
    for (int i = 0; i < 400'000; ++i) {
        float cosine = 0.0f;
        const Vec3 intensity = projectedIntensity<kAllFeatures>(view, view.lights.emitters[0],
                                                                sampleSphere(random.next2()), &cosine);
        directions.add(static_cast<double>(luminance(intensity) * 4.0f * kPi));
        const EmittedPhoton photon =
            emitPhoton<kAllFeatures>(view, power.view(), random.next(), random.next2(), random.next2());
        photons.add(static_cast<double>(luminance(photon.flux)));
    }
    // A plane of 1 by 2/3 at a distance of 1, under the mean of the four colours.
    const double expected = static_cast<double>(kStrength) * (2.0 / 3.0) * 0.5;
    EXPECT_NEAR(directions.mean(), expected, kNormalQuantile * directions.standardError());
    EXPECT_NEAR(photons.mean(), expected, kNormalQuantile * photons.standardError());
    EXPECT_LT(directions.standardError(), 0.01 * expected);
    EXPECT_NEAR(static_cast<double>(power.totalPower), expected, 1e-5 * expected);
}

/// Photons land where sampling says that the picture is: shares of the quarters that they hit, by colour.
TEST(Projector, PhotonsLandWhereSamplingSeesThePicture) {
    const auto built = buildAll(wallScene(true));
    const SceneView view = built->view();
    const PowerDistribution power = buildPowerDistribution(view);
    UniformNumbers random(5);
    for (int i = 0; i < 10'000; ++i) {
        const EmittedPhoton photon =
            emitPhoton<kAllFeatures>(view, power.view(), random.next(), random.next2(), random.next2());
        const Vec3 d = photon.ray.direction;
        ASSERT_LT(d.z, 0.0f);
        const LightSample sample =
            sampleDeltaLight<kAllFeatures>(view, view.lights.emitters[0], 3.0f * d / -d.z);
        EXPECT_LT(glm::length(glm::normalize(photon.flux) - glm::normalize(sample.radiance)), 1e-5f);
    }
}

TEST(Projector, AnotherPictureIsSeenByTheLight) {
    SceneDescription scene = wallScene(false);
    const auto before = buildAll(scene);
    EXPECT_EQ(before->lights->emitters[0].original, kNone);
    scene.textures.push_back(quarters());
    scene.lights[0].image.texture = 0;
    SceneEdit edit;
    edit.scene = std::make_shared<SceneDescription>(scene);
    edit.kinds = EditKind::Lights;
    const auto after = buildScene(edit, before.get(), 1, nullptr, nullptr);
    ASSERT_TRUE(after);
    EXPECT_EQ((*after)->lights->emitters[0].original, 0u);
    EXPECT_EQ((*after)->view().textures.count, 1u);
}

}  // namespace
}  // namespace glint::test
