// Preetham's sky and sun, and their map.
#include "engine/io/mitsuba_sky.h"

#include <cmath>

#include "engine/math/color.h"
#include "tests/support/mitsuba_test.h"

namespace glint::test {
namespace {

/// Candela or lux for Mitsuba's units.
constexpr float kLumens = 683.0f * 106.857f;

Vec3 directionOf(float elevationDeg, float azimuthDeg = 0.0f) {
    const float e = elevationDeg * kPi / 180.0f, a = azimuthDeg * kPi / 180.0f;
    return {std::cos(e) * std::cos(a), std::sin(e), std::cos(e) * std::sin(a)};
}

/// The zenith of the published model at turbidity 2 and 45 degrees: (4.0453 T - 4.9710) tan chi - 0.2155 T +
/// 2.4192 kcd/m^2.
TEST(MitsubaSky, TheZenithIsAsPublished) {
    const PreethamSky sky(directionOf(45.0f), 2.0f);
    const float chi = (4.0f / 9.0f - 2.0f / 120.0f) * (kPi - 0.5f * kPi);
    const float expected = 1000.0f * ((4.0453f * 2.0f - 4.9710f) * std::tan(chi) - 0.2155f * 2.0f + 2.4192f);
    EXPECT_NEAR(luminance(sky.radiance(Vec3(0, 1, 0))) * kLumens, expected, 0.01f * expected);
    const Vec3 zenith = sky.radiance(Vec3(0, 1, 0));
    EXPECT_GT(zenith.z, 1.5f * zenith.x) << "blue";
    EXPECT_GT(luminance(sky.radiance(directionOf(44.0f))), 3.0f * luminance(zenith))
        << "bright about the sun";
    EXPECT_EQ(sky.radiance(Vec3(0, -0.1f, 1)), Vec3(0.0f));
}

/// A clear day's sun brings some 100 klx when it is high, and is red when it is low.
TEST(MitsubaSky, TheSunIsAsBrightAsItIs) {
    const Vec3 high = PreethamSky(directionOf(70.0f), 2.5f).sunIrradiance();
    EXPECT_GT(luminance(high) * kLumens, 85e3f);
    EXPECT_LT(luminance(high) * kLumens, 125e3f);
    const Vec3 low = PreethamSky(directionOf(3.0f), 2.5f).sunIrradiance();
    EXPECT_GT(low.x / low.z, 3.0f * high.x / high.z);
    EXPECT_LT(luminance(low), 0.4f * luminance(high));
}

TEST(MitsubaSky, TheMapBringsTheSunsIrradiance) {
    const PreethamSky sky(directionOf(50.0f, 130.0f), 3.0f);
    for (const float radiusDeg : {0.01f, 0.27f, 5.0f}) {
        const ImageF map = skyMap(sky, Mat3(1.0f), 0.0f, Vec3(1, 2, 3), radiusDeg, 256);
        Vec3 sum(0.0f), middle(0.0f);
        for (int y = 0; y < map.height; ++y) {
            const float theta = (static_cast<float>(y) + 0.5f) * kPi / 128.0f;
            const float area = kTwoPi / 256.0f * kPi / 128.0f * std::sin(theta);
            for (int x = 0; x < map.width; ++x) {
                const float* rgb = &map.rgb[3 * (static_cast<size_t>(y) * 256 + static_cast<size_t>(x))];
                const float phi = ((static_cast<float>(x) + 0.5f) / 256.0f - 0.5f) * kTwoPi;
                const Vec3 color(rgb[0], rgb[1], rgb[2]);
                sum += area * color;
                middle +=
                    area * color.x *
                    Vec3(std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi));
            }
        }
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(sum[c], static_cast<float>(c + 1), 1e-3f * static_cast<float>(c + 1));
        }
        EXPECT_GT(glm::dot(glm::normalize(middle), sky.sun()), std::cos(0.02f));
    }
}

/// Almanac: at the solstice in Greenwich the sun is 62 degrees high at noon, in the south; at the equinox it
/// rises in the east at six.
TEST(MitsubaSky, TheSunStandsWhereItStands) {
    SunTime time{2015, 6, 21, 12.0, 51.48, 0.0, 0.0};
    Vec3 sun = sunDirection(time);
    EXPECT_NEAR(std::asin(sun.y) * 180.0f / kPi, 61.95f, 0.3f);
    EXPECT_GT(sun.z, 0.4f) << "south is +z";
    time = {2015, 3, 20, 6.13, 0.0, 0.0, 0.0};
    sun = sunDirection(time);
    EXPECT_NEAR(sun.y, 0.0f, 0.01f);
    EXPECT_GT(sun.x, 0.99f);
}

using MitsubaSkyScene = MitsubaTest;

TEST_F(MitsubaSkyScene, SkiesAreEnvironmentsAndSunsAreLights) {
    const SceneDescription scene = load(
        "<emitter type='sunsky'><vector name='sun_direction' x='0' y='0' z='1'/></emitter>"
        "<shape type='sphere'/>");
    ASSERT_EQ(scene.environmentImages.size(), 1u);
    const ImageF& map = *scene.environmentImages[0].floats;
    // Version 3 has z up: its zenith is at +z, the middle of the map's lower and upper half's border.
    const auto at = [&](int x, int y) {
        return map.rgb[3 * (static_cast<size_t>(y) * 1024 + static_cast<size_t>(x))];
    };
    EXPECT_GT(at(200, 256), 0.0f);
    EXPECT_GT(at(0, 256), 100.0f * at(200, 256)) << "the sun at +z";
    EXPECT_EQ(at(512, 256), 0.0f) << "the ground at -z";
    const SceneDescription sun = load(
        "<emitter type='sun'><vector name='sun_direction' y='1' z='1'/></emitter>"
        "<shape type='sphere'/>");
    ASSERT_EQ(sun.lights.size(), 1u);
    expectNear(glm::normalize(sun.lights[0].direction), glm::normalize(Vec3(0, -1, -1)), 1e-5f);
}

}  // namespace
}  // namespace glint::test
