// Goniometric lights of pbrt and of Glint's own scenes: which way their pictures lie, how bright they are,
// and what becomes of them in other formats.
#include "engine/io/exporter.h"
#include "engine/io/image_io.h"
#include "engine/io/scene_json.h"
#include "engine/kernels/light_sampling.h"
#include "engine/math/color.h"
#include "tests/support/pbrt_test.h"
#include "tests/support/render_scene.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kSize = 8;

class GoniometricFiles : public PbrtTest {
  protected:
    GoniometricFiles() {
        ImageF image{kSize, kSize, {}};
        for (int i = 0; i < kSize * kSize; ++i) {
            image.rgb.insert(image.rgb.end(), {valueOf(i), 2.0f * valueOf(i), 0.0f});
        }
        EXPECT_TRUE(saveHdr(folder.path("g.hdr"), image));
    }
    /// Each pixel has its own, which an HDR file holds exactly.
    static float valueOf(int pixel) { return static_cast<float>(pixel + 1) / 64.0f; }
    static std::string lightText(const std::string& parameters) {
        return "Shape \"sphere\" AttributeBegin Translate 1 2 3 Rotate 40 0 1 0 Rotate 25 1 0 0 LightSource "
               "\"goniometric\" \"string filename\" \"g.hdr\" " +
               parameters + " AttributeEnd";
    }
    static Vec3 intensityAt(const SceneDescription& scene, const Vec3& direction) {
        const auto built = buildAll(scene);
        return goniometricIntensity<kAllFeatures>(built->view(), built->view().lights.emitters[0], direction);
    }
};

/// In its own space, with y and z swapped, by the nearest texel of a square of equal areas.
TEST_F(GoniometricFiles, PbrtsHaveTheirPictures) {
    for (const bool isMirrored : {false, true}) {
        const SceneDescription scene = loadText(
            sceneText(lightText("\"rgb I\" [1 1 2] \"float scale\" 3"),
                      isMirrored ? "LookAt 0 0 5  0 0 0  0 1 0 Camera \"perspective\" " : kRightHanded));
        EXPECT_THAT(scene.warnings, IsEmpty());
        ASSERT_EQ(scene.lights.size(), 1u);
        EXPECT_EQ(scene.lights[0].kind, LightKind::Goniometric);
        EXPECT_EQ(scene.lights[0].position, Vec3(isMirrored ? -1.0f : 1.0f, 2, 3));
        const Affine turn =
            rotate(Vec3(0, 1, 0), 40.0f * kPi / 180.0f) * rotate(Vec3(1, 0, 0), 25.0f * kPi / 180.0f);
        UniformNumbers random(4);
        int near = 0;
        for (int i = 0; i < 200; ++i) {
            const Vec3 local = sampleSphere(random.next2());
            const Vec2 at = static_cast<float>(kSize) * equalAreaPoint(Vec3(local.x, local.z, local.y));
            const auto isEdge = [](float x) { return std::fabs(x - std::round(x)) < 1e-3f; };
            if (isEdge(at.x) || isEdge(at.y)) { continue; }
            ++near;
            const int pixel = static_cast<int>(at.y) * kSize + static_cast<int>(at.x);
            Vec3 world = turn.vector(local);
            if (isMirrored) { world.x = -world.x; }
            // The mean of the channels v, 2 v and 0 is v.
            expectNear(intensityAt(scene, world), 3.0f * valueOf(pixel) * Vec3(1, 1, 2), 1e-4f);
        }
        EXPECT_GT(near, 150);
    }
}

TEST_F(GoniometricFiles, PowersAreOfTheWholeSphere) {
    const SceneDescription scene = load(lightText("\"float power\" 50"));
    UniformNumbers random(8);
    double sum = 0.0;
    const auto built = buildAll(scene);
    for (int i = 0; i < 400 * 400; ++i) {
        const Vec2 at((static_cast<float>(i % 400) + random.next()) / 400.0f,
                      (static_cast<float>(i / 400) + random.next()) / 400.0f);
        sum += static_cast<double>(luminance(goniometricIntensity<kAllFeatures>(
            built->view(), built->view().lights.emitters[0], equalAreaDirection(at))));
    }
    EXPECT_NEAR(sum / (400.0 * 400.0) * 4.0 * static_cast<double>(kPi), 50.0, 0.05);
}

/// pbrt-v3's, by longitude and latitude: bright around its own +y, which is the map's upper edge.
TEST_F(GoniometricFiles, MapsOfVersion3AreLaidOutAnew) {
    ImageF map{64, 32, {}};
    for (int i = 0; i < 64 * 32; ++i) {
        map.rgb.insert(map.rgb.end(), 3, i / 64 < 16 ? 1.0f : 0.25f);
    }
    ASSERT_TRUE(saveHdr(folder.path("v3.hdr"), map));
    const SceneDescription scene =
        load("Shape \"sphere\" LightSource \"goniometric\" \"string mapname\" \"v3.hdr\"");
    ASSERT_EQ(scene.lights.size(), 1u);
    expectNear(intensityAt(scene, glm::normalize(Vec3(0.2f, 1.0f, 0.1f))), Vec3(1.0f), 1e-3f);
    expectNear(intensityAt(scene, glm::normalize(Vec3(0.9f, -0.3f, 0.1f))), Vec3(0.25f), 1e-3f);
}

TEST_F(GoniometricFiles, SavedAndOpenedAgain) {
    const SceneDescription scene = load(lightText("\"rgb I\" [1 1 2] \"float scale\" 3"));
    ASSERT_TRUE(saveSceneJson(scene, folder.path("out.json")));
    std::vector<std::string> said;
    ASSERT_TRUE(exporterOf("out.pbrt")->save(scene, folder.path("out.pbrt"), &said));
    EXPECT_THAT(said, IsEmpty());
    for (const char* name : {"out.json", "out.pbrt"}) {
        const auto opened = loadScene(folder.path(name));
        ASSERT_TRUE(opened) << opened.error().format();
        EXPECT_EQ(opened->lights.at(0).kind, LightKind::Goniometric) << name;
        expectNear(opened->lights[0].position, scene.lights[0].position, 1e-6f);
        UniformNumbers random(6);
        int unlike = 0;
        for (int i = 0; i < 300; ++i) {
            const Vec3 w = sampleSphere(random.next2());
            unlike += glm::length(intensityAt(scene, w) - intensityAt(*opened, w)) > 1e-4f;
        }
        EXPECT_LE(unlike, 2) << name << ": but at the edges of texels";
    }
    for (const char* name : {"out.xml", "out.gltf"}) {
        said.clear();
        ASSERT_TRUE(exporterOf(name)->save(scene, folder.path(name), &said));
        EXPECT_THAT(said, Contains(HasSubstr("goniometric lights shine alike"))) << name;
        const auto opened = loadScene(folder.path(name));
        ASSERT_TRUE(opened) << opened.error().format();
        EXPECT_EQ(opened->lights.at(0).kind, LightKind::Point) << name;
        const Vec3 mean = 3.0f * (65.0f / 128.0f) * Vec3(1, 1, 2);
        expectNear(opened->lights[0].strength * opened->lights[0].color, mean, 1e-3f);
    }
}

TEST_F(GoniometricFiles, WhatIsWrongIsSaid) {
    ASSERT_TRUE(saveHdr(folder.path("wide.hdr"), {4, 2, std::vector<float>(24, 0.25f)}));
    EXPECT_THAT(errorOf("LightSource \"goniometric\" \"string filename\" \"wide.hdr\""),
                HasSubstr("expected a square"));
    const SceneDescription even = load("Shape \"sphere\" LightSource \"goniometric\" \"float scale\" 2");
    EXPECT_EQ(even.lights.at(0).kind, LightKind::Point);
    EXPECT_EQ(even.lights[0].strength, 2.0f);
    const auto json = loadScene(folder.write("bad.json", R"({"glint": 1, "objects": [], "lights": [{"type":
"goniometric", "position": [0, 0, 0], "fovDeg": 40}]})"));
    ASSERT_FALSE(json);
    EXPECT_THAT(json.error().format(), HasSubstr("unknown key \"fovDeg\" of goniometric"));
}

}  // namespace
}  // namespace glint::test
