// Projectors of Mitsuba and pbrt, and of Glint's own scenes: which way their pictures lie, how bright they
// are, and what becomes of them in other formats.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/exporter.h"
#include "engine/io/image_io.h"
#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"
#include "engine/kernels/light_sampling.h"
#include "tests/support/render_scene.h"
#include "tests/support/temp_folder.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class ProjectorFiles : public testing::Test {
  protected:
    ProjectorFiles() {
        // Red, green, blue; white, black, yellow.
        const Image8 image{3, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 0, 0, 0, 255, 255, 0}};
        EXPECT_TRUE(savePng(folder.path("p.png"), image));
    }
    SceneDescription load(const std::string& name, const std::string& text) {
        auto scene = loadScene(folder.write(name, text), {.noStudio = true});
        EXPECT_TRUE(scene) << scene.error().format();
        warnings = scene ? scene->warnings : std::vector<std::string>();
        return scene ? std::move(*scene) : SceneDescription();
    }
    SceneDescription mitsuba(const std::string& properties, const std::string& turn = "") {
        return load("a.xml",
                    "<scene version='3.0.0'><shape type='sphere'/><emitter type='projector'>" + properties +
                        "<transform name='to_world'>" + turn +
                        "<lookat origin='0,0,5' target='0,0,0' up='0,1,0'/></transform></emitter></scene>");
    }
    /// From (0, 0, 5) towards -z, in a file whose camera mirrors the scene or not.
    SceneDescription pbrt(const std::string& parameters, bool isMirrored) {
        return load("a.pbrt",
                    std::string(isMirrored ? "Scale -1 1 1 " : "") +
                        "LookAt 0 0 5  0 0 0  0 1 0 Camera \"perspective\" WorldBegin Shape \"sphere\" "
                        "AttributeBegin Translate 0 0 5 Rotate 180 0 1 0 LightSource \"projection\" "
                        "\"string filename\" \"p.png\" " +
                        parameters + " AttributeEnd");
    }
    /// Where the picture's pixel lies on the plane z = 4, on the whole scene's own axes.
    static Vec3 placeOf(const Light& light, float column, float row) {
        const float half = std::tan(0.5f * light.fovDeg * kPi / 180.0f);
        const float x = half * (2.0f * (column + 0.5f) / 3.0f - 1.0f);
        const float y = half / light.aspect * (1.0f - 2.0f * (row + 0.5f) / 2.0f);
        return {x, y, -1.0f};
    }
    static Vec3 intensityAt(const SceneDescription& scene, Vec3 direction) {
        const auto built = buildAll(scene);
        float cosine = 0.0f;
        return projectedIntensity<kAllFeatures>(built->view(), built->view().lights.emitters[0],
                                                glm::normalize(direction), &cosine);
    }
    static void expectNear(const Vec3& a, const Vec3& b, float tolerance, const std::string& what) {
        EXPECT_LT(glm::length(a - b), tolerance) << what << ": " << a.x << ' ' << a.y << ' ' << a.z;
    }

    TempFolder folder;
    std::vector<std::string> warnings;
};

constexpr struct {
    float column, row;
    Vec3 color;
} kPixels[] = {{0, 0, {1, 0, 0}}, {1, 0, {0, 1, 0}}, {2, 0, {0, 0, 1}},
               {0, 1, {1, 1, 1}}, {1, 1, {0, 0, 0}}, {2, 1, {1, 1, 0}}};

/// Upright as seen from (0, 0, 5): what it says is what a white surface reflects at a distance of 1.
TEST_F(ProjectorFiles, MitsubasHaveTheirPictures) {
    const SceneDescription scene = mitsuba(
        "<texture type='bitmap' name='irradiance'><string name='filename' value='p.png'/></texture>"
        "<float name='fov' value='30'/><float name='scale' value='7'/>");
    EXPECT_THAT(warnings, IsEmpty());
    const Light& light = scene.lights.at(0);
    EXPECT_EQ(light.kind, LightKind::Projector);
    EXPECT_EQ(light.position, Vec3(0, 0, 5));
    EXPECT_NEAR(light.fovDeg, 30.0f, 1e-4f);
    EXPECT_EQ(light.aspect, 1.5f);
    EXPECT_FLOAT_EQ(light.strength, 7.0f * kPi);
    for (const auto& [column, row, color] : kPixels) {
        const Vec3 place = placeOf(light, column, row);
        const float cosine = 1.0f / glm::length(place);
        expectNear(intensityAt(scene, place) * (cosine * cosine * cosine / kPi), 7.0f * color, 1e-3f,
                   std::to_string(column) + " " + std::to_string(row));
    }
    const SceneDescription mirrored = mitsuba(
        "<texture type='bitmap' name='irradiance'><string name='filename' value='p.png'/></texture>"
        "<float name='fov' value='30'/>",
        "<scale x='-1'/>");
    expectNear(glm::normalize(intensityAt(mirrored, placeOf(light, 0, 0))), Vec3(0, 0, 1), 1e-3f, "mirrored");
    const Light plain = mitsuba(
                            "<rgb name='irradiance' value='1 2 3'/><string name='fov_axis' value='y'/>"
                            "<float name='fov' value='20'/>")
                            .lights.at(0);
    EXPECT_EQ(plain.image, ColorInput{Vec3(1.0f)});
    EXPECT_EQ(plain.color, Vec3(1, 2, 3));
    EXPECT_NEAR(plain.fovDeg, 20.0f, 1e-4f);
}

/// pbrt's picture is an intensity, alike for all angles; its fov is of the shorter side, and its nearest
/// texels have hard edges.
TEST_F(ProjectorFiles, PbrtsHaveTheirPictures) {
    for (const bool isMirrored : {false, true}) {
        const SceneDescription scene = pbrt("\"float fov\" 60 \"float scale\" 3", isMirrored);
        EXPECT_THAT(warnings, IsEmpty());
        const Light& light = scene.lights.at(0);
        EXPECT_EQ(light.aspect, 1.5f);
        EXPECT_NEAR(std::tan(0.5f * light.fovDeg * kPi / 180.0f), 1.5f * std::tan(kPi / 6.0f), 1e-5f);
        for (const auto& [column, row, color] : kPixels) {
            // On the right in pbrt's left-handed space: -x where its camera looks along -z, +x where the
            // scene or the camera is mirrored, as every picture of it shows.
            Vec3 place = placeOf(light, column, row);
            if (isMirrored) { place.x = -place.x; }
            expectNear(intensityAt(scene, place), 3.0f * color, 0.01f,
                       std::to_string(column) + " " + std::to_string(row));
        }
    }
    // The power of an intensity over 1.5 by 1 times tan^2, by its cubed cosines: as photons have it.
    const SceneDescription bright = pbrt("\"float power\" 80", true);
    double sum = 0.0;
    constexpr int kSteps = 100;
    const float half = std::tan(0.5f * bright.lights.at(0).fovDeg * kPi / 180.0f);
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const Vec2 at((static_cast<float>(i % kSteps) + 0.5f) / kSteps,
                      (static_cast<float>(i / kSteps) + 0.5f) / kSteps);
        const Vec3 place(half * (2.0f * at.x - 1.0f), half / 1.5f * (2.0f * at.y - 1.0f), -1.0f);
        sum +=
            static_cast<double>(luminance(intensityAt(bright, place)) * std::pow(glm::length(place), -3.0f));
    }
    const double area = 4.0 * static_cast<double>(half) * static_cast<double>(half) / 1.5;
    EXPECT_NEAR(sum * area / (kSteps * kSteps), 80.0, 0.4);
}

TEST_F(ProjectorFiles, SavedAndOpenedAgain) {
    const SceneDescription scene = mitsuba(
        "<texture type='bitmap' name='irradiance'><string name='filename' value='p.png'/></texture>"
        "<float name='scale' value='7'/><float name='fov' value='30'/>");
    ASSERT_TRUE(saveSceneJson(scene, folder.path("out.json")));
    const auto json = loadScene(folder.path("out.json"));
    ASSERT_TRUE(json) << json.error().format();
    const Light &before = scene.lights.at(0), &after = json->lights.at(0);
    EXPECT_EQ(after.direction, before.direction);
    EXPECT_EQ(after.up, before.up);
    EXPECT_EQ(after.fovDeg, before.fovDeg);
    EXPECT_EQ(after.aspect, before.aspect);
    EXPECT_EQ(after.strength, before.strength);
    ASSERT_GE(after.image.texture, 0);
    for (const char* name : {"out.xml", "out.pbrt", "out.gltf"}) {
        std::vector<std::string> said;
        ASSERT_TRUE(exporterOf(name)->save(scene, folder.path(name), &said));
        const auto opened = loadScene(folder.path(name));
        ASSERT_TRUE(opened) << opened.error().format();
        const Light& light = opened->lights.at(0);
        const bool isGltf = std::string(name) == "out.gltf";
        EXPECT_EQ(light.kind, isGltf ? LightKind::Spot : LightKind::Projector) << name;
        expectNear(light.position, {0, 0, 5}, 1e-5f, name);
        expectNear(glm::normalize(light.direction), {0, 0, -1}, 1e-5f, name);
        if (isGltf) {
            EXPECT_THAT(said, Contains(HasSubstr("approximated: projectors are spots"))) << name;
            continue;
        }
        EXPECT_NEAR(light.fovDeg, before.fovDeg, 1e-4f);
        EXPECT_NEAR(light.aspect, before.aspect, 1e-6f);
        EXPECT_FLOAT_EQ(light.strength, 7.0f * kPi);
        for (const Vec3& place : {Vec3(0.05f, 0.03f, -1), Vec3(-0.2f, 0.1f, -1), Vec3(0.21f, -0.12f, -1)}) {
            const Vec3 shown = intensityAt(*opened, place), wanted = intensityAt(scene, place);
            EXPECT_GT(maxComponent(wanted), 0.1f);
            expectNear(shown, wanted, 0.01f * glm::length(wanted), name);
        }
        expectNear(glm::normalize(light.up), {0, 1, 0}, 1e-5f, name);
    }
}

TEST_F(ProjectorFiles, WhatIsWrongIsSaid) {
    const auto errorOf = [this](const char* name, const std::string& text) {
        const auto scene = loadScene(folder.write(name, text));
        return scene ? "no error" : scene.error().format();
    };
    EXPECT_THAT(errorOf("a.pbrt", "WorldBegin Shape \"sphere\" LightSource \"projection\""),
                HasSubstr("has no \"filename\""));
    EXPECT_THAT(errorOf("a.json", R"({"glint": 1, "objects": [], "lights": [{"type": "projector",
"position": [0, 0, 0], "fovDeg": 180}]})"),
                HasSubstr("between 0 and 180"));
    const SceneDescription lost = load("b.pbrt", R"(WorldBegin Shape "sphere" LightSource "point"
LightSource "projection" "string filename" "none.png")");
    EXPECT_EQ(lost.lights.size(), 1u);
    EXPECT_THAT(warnings, Contains(HasSubstr("cannot be read")));
}

}  // namespace
}  // namespace glint::test
