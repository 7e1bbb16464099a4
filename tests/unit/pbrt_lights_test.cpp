// pbrt's lights: their units, and environments laid out anew.
#include <cmath>

#include "engine/io/image_io.h"
#include "engine/io/pbrt_environment.h"
#include "engine/math/color.h"
#include "engine/math/equal_area.h"
#include "tests/support/pbrt_test.h"
#include "tests/support/render_scene.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class PbrtLightsTest : public PbrtTest {
  protected:
    Light lightOf(const std::string& directives) {
        const SceneDescription scene = load(directives);
        warnings = scene.warnings;
        return scene.lights.empty() ? Light() : scene.lights[0];
    }
    Material shining(const std::string& light, const std::string& shape = "Shape \"sphere\"") {
        const SceneDescription scene = load("AreaLightSource \"diffuse\" " + light + " " + shape);
        warnings = scene.warnings;
        return scene.materials.empty() ? Material() : scene.materials[0];
    }
};

TEST_F(PbrtLightsTest, PointsSpotsAndDistantLights) {
    Light light = lightOf(
        "Translate 1 2 3 LightSource \"point\" \"rgb I\" [1 2 3] \"float scale\" 5 \"point3 from\" [0 0 1]");
    EXPECT_EQ(light.kind, LightKind::Point);
    EXPECT_EQ(light.position, Vec3(1, 2, 4));
    EXPECT_EQ(light.color, Vec3(1, 2, 3));
    EXPECT_EQ(light.strength, 5.0f);
    EXPECT_NEAR(lightOf("LightSource \"point\" \"float power\" 100").strength, 100.0f / (4.0f * kPi), 1e-4f);
    light = lightOf(
        "LightSource \"spot\" \"point3 from\" [0 5 0] \"point3 to\" [0 0 0] \"float coneangle\" 40 \"float "
        "conedeltaangle\" 10");
    EXPECT_EQ(light.kind, LightKind::Spot);
    EXPECT_EQ(light.position, Vec3(0, 5, 0));
    EXPECT_EQ(glm::normalize(light.direction), Vec3(0, -1, 0));
    EXPECT_EQ(light.coneAngleDeg, 40.0f);
    EXPECT_EQ(light.coneFalloffStartDeg, 30.0f);
    light = lightOf(
        "LightSource \"distant\" \"rgb L\" [1 1 2] \"point3 from\" [0 1 0] \"point3 to\" [0 0 0] \"float "
        "illuminance\" 3");
    EXPECT_EQ(light.kind, LightKind::Directional);
    EXPECT_EQ(light.direction, Vec3(0, -1, 0));
    EXPECT_EQ(light.strength, 3.0f);
    EXPECT_THAT(warnings, IsEmpty());
    light = lightOf("Translate 0 0 2 LightSource \"goniometric\"");
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_EQ(light.kind, LightKind::Point);
    EXPECT_EQ(light.position, Vec3(0, 0, 2));
    EXPECT_THAT(errorOf("LightSource \"distant\" \"point3 to\" [0 0 0]"), HasSubstr("no direction"));
    EXPECT_THAT(errorOf("LightSource \"candle\""), HasSubstr("Glint has no light \"candle\""));
}

/// pbrt-v4 scales light that is no rgb to luminance 1.
TEST_F(PbrtLightsTest, SpectraOfLightHaveLuminanceOne) {
    for (const char* value : {"\"blackbody L\" 3000", "\"spectrum L\" [300 7 900 7]",
                              "\"spectrum L\" \"stdillum-A\"", "\"spectrum L\" \"stdillum-D65\"",
                              "\"spectrum L\" \"illum-acesD60\"", "\"spectrum L\" \"stdillum-F2\""}) {
        EXPECT_NEAR(luminance(shining(value).emission.value), 1.0f, 1e-3f) << value;
    }
    expectNear(shining("\"spectrum L\" \"stdillum-D65\"").emission.value, Vec3(1.0f), 2e-3f);
    const Vec3 warm = shining("\"blackbody L\" 3000").emission.value;
    EXPECT_TRUE(warm.x > 1.5f * warm.y && warm.y > 2.0f * warm.z);
    EXPECT_EQ(shining("\"rgb L\" [4 5 6]").emission.value, Vec3(4, 5, 6));
    EXPECT_EQ(shining("").emission.value, Vec3(1.0f));
    EXPECT_EQ(shining("\"blackbody L\" 3000 \"float scale\" 10").emissionStrength, 10.0f);
    EXPECT_NEAR(luminance(shining("\"blackbody L\" [3000 2.5]").emission.value), 2.5f, 1e-3f);
}

TEST_F(PbrtLightsTest, AreaLightsShineFromTheirFronts) {
    EXPECT_FALSE(shining("").emitsBothSides);
    EXPECT_TRUE(shining("\"bool twosided\" true").emitsBothSides);
    EXPECT_NEAR(shining("\"float power\" 100", "Shape \"sphere\" \"float radius\" 2").emissionStrength,
                100.0f / (kPi * 16.0f * kPi), 1e-4f);
    EXPECT_NEAR(shining("\"float power\" 100 \"bool twosided\" true", "Shape \"disk\" \"float radius\" 2")
                    .emissionStrength,
                100.0f / (2.0f * kPi * 4.0f * kPi), 1e-4f);
    // Each triangle is a light of that power.
    EXPECT_NEAR(shining("\"float power\" 10", R"(Shape "trianglemesh" "point3 P" [0 0 0 2 0 0 2 2 0 0 2 0]
"integer indices" [0 1 2 0 2 3])")
                    .emissionStrength,
                10.0f / (kPi * 2.0f), 1e-4f);
    const SceneDescription scene = load(R"(AreaLightSource "diffuse" Material "interface" Shape "sphere"
AttributeBegin AreaLightSource "diffuse" "rgb L" [2 2 2] Material "diffuse" Shape "disk" AttributeEnd)");
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.materials[0].color.value, Vec3(0.0f));
    EXPECT_EQ(scene.objects[1].shape, ShapeKind::Disc);
}

TEST_F(PbrtLightsTest, EqualAreasAreEqualSolidAngles) {
    for (int i = 0; i < 400; ++i) {
        const Vec2 point((static_cast<float>(i % 20) + 0.5f) / 20.0f,
                         (static_cast<float>(i / 20) + 0.5f) / 20.0f);
        const Vec3 direction = equalAreaDirection(point);
        EXPECT_NEAR(glm::length(direction), 1.0f, 1e-5f);
        const Vec2 back = equalAreaPoint(direction);
        EXPECT_NEAR(back.x, point.x, 1e-4f);
        EXPECT_NEAR(back.y, point.y, 1e-4f);
    }
    expectNear(equalAreaDirection({0.5f, 0.5f}), Vec3(0, 0, 1), 1e-5f);
    expectNear(equalAreaDirection({1.0f, 0.5f}), Vec3(1, 0, 0), 1e-5f);
    expectNear(equalAreaDirection({0.5f, 1.0f}), Vec3(0, 1, 0), 1e-5f);
    expectNear(equalAreaDirection({0.0f, 0.0f}), Vec3(0, 0, -1), 1e-3f);
}

/// A map that holds its own directions: Glint's environment then says where each lies.
TEST_F(PbrtLightsTest, MapsTurnWithTheirTransform) {
    constexpr int kSize = 64;
    ImageF map{kSize, kSize, {}};
    for (int i = 0; i < kSize * kSize; ++i) {
        const Vec3 d = equalAreaDirection(Vec2((static_cast<float>(i % kSize) + 0.5f) / kSize,
                                               (static_cast<float>(i / kSize) + 0.5f) / kSize));
        map.rgb.insert(map.rgb.end(), {d.x + 1.0f, d.y + 1.0f, d.z + 1.0f});
    }
    const Affine turns[] = {Affine(), rotate(Vec3(1, 2, 3), 1.0f),
                            scale(Vec3(-1, 1, 1)) * rotate(Vec3(1, 0, 0), -1.5f)};
    for (const Affine& turn : turns) {
        const ImageF laidOut = latLongOfEqualArea(map, turn);
        ASSERT_EQ(laidOut.width, 128);
        for (int k = 0; k < 200; ++k) {
            const int x = k * 37 % laidOut.width, y = k * 11 % laidOut.height;
            const float theta = (static_cast<float>(y) + 0.5f) / static_cast<float>(laidOut.height) * kPi;
            const float phi =
                ((static_cast<float>(x) + 0.5f) / static_cast<float>(laidOut.width) - 0.5f) * kTwoPi;
            const Vec3 world(std::sin(theta) * std::sin(phi), std::cos(theta),
                             -std::sin(theta) * std::cos(phi));
            const float* rgb = &laidOut.rgb[static_cast<size_t>(3 * (y * laidOut.width + x))];
            expectNear(Vec3(rgb[0], rgb[1], rgb[2]) - Vec3(1.0f), glm::normalize(inverse(turn).vector(world)),
                       0.04f);
        }
    }
    const ImageF half{kSize, kSize, std::vector<float>(size_t{3} * kSize * kSize, 2.0f)};
    EXPECT_NEAR(illuminanceOfEqualArea(half), 3.14159265, 0.01);  // half of what a surface gets
}

/// A single bright texel keeps its light.
TEST_F(PbrtLightsTest, SmallSunsKeepTheirLight) {
    constexpr int kSize = 32;
    for (const int at : {5 * kSize + 7, 16 * kSize + 16, 31 * kSize + 3}) {
        ImageF map{kSize, kSize, std::vector<float>(size_t{3} * kSize * kSize, 0.0f)};
        std::fill_n(&map.rgb[static_cast<size_t>(3 * at)], 3, 1000.0f);
        const ImageF laidOut = latLongOfEqualArea(map, rotate(Vec3(1, 1, 0), 0.7f));
        double power = 0.0;
        for (int y = 0; y < laidOut.height; ++y) {
            const double ring = std::sin((y + 0.5) / laidOut.height * 3.14159265358979);
            for (int x = 0; x < laidOut.width; ++x) {
                power +=
                    ring * static_cast<double>(laidOut.rgb[static_cast<size_t>(3 * (y * laidOut.width + x))]);
            }
        }
        power *= 3.14159265358979 / laidOut.height * 2.0 * 3.14159265358979 / laidOut.width;
        EXPECT_NEAR(power / (1000.0 * 4.0 * 3.14159265358979 / (kSize * kSize)), 1.0, 0.03) << at;
    }
}

TEST_F(PbrtLightsTest, Environments) {
    const auto environmentOf = [this](const std::string& parameters) {
        const SceneDescription scene = load("LightSource \"infinite\" " + parameters);
        warnings = scene.warnings;
        return scene.environment;
    };
    EXPECT_EQ(environmentOf("").color, Vec3(1.0f));
    EXPECT_EQ(environmentOf("\"rgb L\" [1 2 3] \"float scale\" 4").strength, 4.0f);
    EXPECT_NEAR(environmentOf("\"float illuminance\" 10").strength, 10.0f / kPi, 1e-5f);
    ImageF map{8, 8, std::vector<float>(size_t{3} * 64, 0.25f)};
    ASSERT_TRUE(saveHdr(folder.path("sky.hdr"), map));
    const SceneDescription scene = load(
        "LightSource \"infinite\" \"string filename\" \"sky.hdr\" \"float scale\" 2 \"point3 portal\" "
        "[0 0 0 1 0 0 1 1 0 0 1 0]");
    ASSERT_EQ(scene.environment.image, 0);
    EXPECT_EQ(scene.environment.strength, 2.0f);
    EXPECT_TRUE(scene.environmentImages.at(0).isRead());
    EXPECT_NEAR(scene.environmentImages[0].floats->rgb[0], 0.25f, 0.01f);
    EXPECT_EQ(scene.environment.portal.size(), 4u);
    environmentOf("LightSource \"infinite\"");
    EXPECT_THAT(warnings, Contains(HasSubstr("environments after the first")));
    ASSERT_TRUE(saveHdr(folder.path("wide.hdr"), {4, 2, std::vector<float>(24, 0.25f)}));
    EXPECT_THAT(errorOf("LightSource \"infinite\" \"string filename\" \"wide.hdr\""),
                HasSubstr("expected a square"));
    EXPECT_EQ(environmentOf("\"string mapname\" \"wide.hdr\"").image, 0);
    ASSERT_TRUE(savePng(folder.path("sky.png"), {4, 4, std::vector<uint8_t>(48, 255)}));
    EXPECT_EQ(environmentOf("\"string filename\" \"sky.png\"").image, 0) << "of 8 bits";
    EXPECT_THAT(errorOf("LightSource \"infinite\" \"string filename\" \"none.hdr\""),
                HasSubstr("cannot be read"));
}

/// A small white floor of albedo 1/2 reflects E / (2 pi) of an irradiance E.
TEST_F(PbrtLightsTest, FloorsReflectTheirIrradiance) {
    const auto irradiance = [this](const std::string& light) {
        const SceneDescription scene = loadText(sceneText(
            light +
                R"( Material "diffuse" "rgb reflectance" [0.5 0.5 0.5] Shape "bilinearmesh" "point3 P" [-0.1 -0.1 0 0.1
-0.1 0 -0.1 0.1 0 0.1 0.1 0])",
            R"(LookAt 0 -1 1 0 0 0 0 0 1 Camera "perspective" "float fov" 1 Film "rgb" "integer xresolution" 4 "integer
yresolution" 4 PixelFilter "box" Integrator "path" "integer maxdepth" 1 )"));
        return 2.0 * 3.14159265 * meanLuminance(renderFilm(scene, 256)).mean;
    };
    EXPECT_NEAR(irradiance("LightSource \"point\" \"point3 from\" [0 0 2] \"rgb I\" [8 8 8]"), 2.0, 1e-3);
    EXPECT_NEAR(irradiance("LightSource \"point\" \"point3 from\" [0 0 2] \"float power\" 100"),
                100.0 / (4.0 * 3.14159265 * 4.0), 1e-3);
    EXPECT_NEAR(
        irradiance("LightSource \"spot\" \"point3 from\" [0 0 2] \"point3 to\" [0 0 0] \"rgb I\" [8 8 8]"),
        2.0, 1e-3);
    EXPECT_NEAR(
        irradiance("LightSource \"distant\" \"point3 from\" [0 1 1] \"point3 to\" [0 0 0] \"float scale\" 3"),
        3.0 / std::sqrt(2.0), 1e-3);
    EXPECT_NEAR(irradiance("LightSource \"infinite\" \"float illuminance\" 5"), 5.0, 1e-2);
    // A disk of radius 1 at a height of 2: pi L sin^2 of its half angle.
    EXPECT_NEAR(irradiance("AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [3 3 3] Translate 0 0 2 "
                           "ReverseOrientation Shape \"disk\" AttributeEnd"),
                3.0 * 3.14159265 / 5.0, 0.02);
    EXPECT_EQ(
        irradiance("AttributeBegin AreaLightSource \"diffuse\" Translate 0 0 2 Shape \"disk\" AttributeEnd"),
        0.0);
}

/// In a closed sphere of albedo a that shines with L everywhere, radiance is L (1 + a + ... + a^n).
TEST_F(PbrtLightsTest, AFurnaceHasItsRadiance) {
    const SceneDescription scene = loadText(sceneText(
        R"(AreaLightSource "diffuse" "rgb L" [1 1 1] "bool twosided" true
Material "diffuse" "rgb reflectance" [0.5 0.5 0.5] Shape "sphere" "float radius" 4)",
        R"(Camera "perspective" "float fov" 60 Film "rgb" "integer xresolution" 8 "integer yresolution" 8 "float iso" 200
Integrator "path" "integer maxdepth" 3 )"));
    const Estimate mean = meanLuminance(renderFilm(scene, 64));
    EXPECT_NEAR(mean.mean, 2.0 * (1.0 + 0.5 + 0.25 + 0.125), 0.01);
}

/// Light of the temperature that the film says is white; sensors of cameras say 6500 K.
TEST_F(PbrtLightsTest, FilmsBalanceWhite) {
    const auto colorOf = [this](const std::string& film, const std::string& light) {
        return loadText(
                   sceneText("LightSource \"point\" " + light, "Camera \"perspective\" Film \"rgb\" " + film))
            .lights.at(0)
            .color;
    };
    struct Case {
        const char *film, *light;
    };
    constexpr Case kWhite[] = {{"\"float whitebalance\" 5000", "\"spectrum I\" \"stdillum-D50\""},
                               {"\"float whitebalance\" 3000", "\"blackbody I\" 3000"},
                               {"\"string sensor\" \"nikon_d850\"", "\"spectrum I\" \"stdillum-D65\""}};
    for (const auto& [film, light] : kWhite) {
        expectNear(colorOf(film, light), Vec3(1.0f), 0.005f);
    }
    const Vec3 warm = colorOf("", "\"blackbody I\" 3000"), cold = colorOf("\"float whitebalance\" 3000", "");
    EXPECT_GT(warm.x, 2.0f * warm.z);
    EXPECT_GT(cold.z, 2.0f * cold.x);
    // D50 lies at x = 0.3457, y = 0.3585 (CIE 15: 2004), and turns D65's white into this.
    expectNear(colorOf("\"float whitebalance\" 5000", ""), Vec3(0.8270f, 1.0224f, 1.3703f), 0.01f);
}

}  // namespace
}  // namespace glint::test
