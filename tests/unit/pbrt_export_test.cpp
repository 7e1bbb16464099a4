// Scenes written as pbrt-v4: opened again they show the same picture, bit for bit where nothing
// is approximated.
#include "engine/scene/metals.h"
#include "tests/support/export_test.h"
#include "tests/support/pbrt_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::IsEmpty;

class PbrtExport : public ExportTest<PbrtTest> {
  protected:
    PbrtExport() : ExportTest("out.pbrt") {}
};

TEST_F(PbrtExport, GlintScenesKeepTheirBits) {
    expectSamePicture(repositoryScene("cornell.json"));
    SceneDescription glass = repositoryScene("sppm_glass_mesh.json");
    glass.options.integrator = IntegratorKind::PathTracing;
    expectSamePicture(std::move(glass));
}

TEST_F(PbrtExport, PbrtScenesKeepTheirBits) {
    expectSamePicture(loadText(sceneText(
        R"(LightSource "point" "point3 from" [2 3 2] "rgb I" [3 3 3]
LightSource "infinite" "rgb L" [0.2 0.3 0.4] "float scale" 0.5
LightSource "spot" "point3 from" [0 4 0] "point3 to" [0 0 1] "float scale" 9
LightSource "distant" "point3 to" [1 -2 -1]
Texture "board" "spectrum" "checkerboard" "rgb tex1" [0.9 0.2 0.1] "float uscale" 8 "float vscale" 4
Material "diffuse" "texture reflectance" "board" Translate 0 -1 0 Rotate -90 1 0 0
Shape "bilinearmesh" "point3 P" [-3 -3 0 3 -3 0 -3 3 0 3 3 0] Shape "sphere" "float radius" 0.8
Material "coateddiffuse" "rgb reflectance" [0.1 0.5 0.2] "float roughness" 0.01 Translate 1.5 0 1 Shape "cylinder" "float radius" 0.3
Material "conductor" "float roughness" 0.04 Translate -3 0 0
Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 0 1 2] "normal N" [0 0 1 0 1 1 1 0 1]
Material "dielectric" "spectrum eta" "glass-SF11" Shape "sphere" "float radius" 0.5 "float alpha" 0.75
AreaLightSource "diffuse" "rgb L" [5 4 3] "bool twosided" true Translate 0 0 3 Shape "disk" "float radius" 0.4)",
        std::string("Scale -1 1 1 LookAt 1 2 6  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 50 \"float "
                    "lensradius\" 0.05 \"float focaldistance\" 6 "))));
}

TEST_F(PbrtExport, CamerasAndSheetsKeepTheirBits) {
    const std::string world =
        R"(LightSource "infinite" "rgb L" [0.2 0.3 0.4] LightSource "point" "point3 from" [0 3 0]
Material "diffusetransmission" "rgb reflectance" [0.1 0.4 0.2] "rgb transmittance" [0.3 0.5 0.1]
Shape "bilinearmesh" "point3 P" [-1 -1 0 1 -1 0 -1 1 0 1 1 0] Translate 1 0 -2 Shape "sphere")";
    const std::string look = "Scale -1 1 1 LookAt 1 2 6  0 0 0  0 1 0 ";
    expectSamePicture(
        loadText(sceneText(world, look + "Camera \"orthographic\" \"float screenwindow\" [-2 2 -1.5 1.5] ")));
    SceneDescription aside = loadText(sceneText(world, look + "Camera \"perspective\" \"float fov\" 40 "));
    aside.camera.shift = {0.25f, -0.5f};
    const Camera opened = exported(aside).camera;
    expectNear(Vec3(opened.shift, 0.0f), Vec3(0.25f, -0.5f, 0.0f), 1e-6f);
    EXPECT_NEAR(opened.verticalFovDeg, 40.0f, 1e-4f);
}

TEST_F(PbrtExport, GlassKeepsWhatItAbsorbs) {
    SceneDescription scene = load("Material \"dielectric\" Shape \"sphere\"");
    scene.materials.at(0).attenuationColor = {0.5f, 0.25f, 0.125f};
    scene.materials[0].attenuationDistance = 3.0f;
    const SceneDescription opened = exported(scene);
    EXPECT_THAT(warnings, IsEmpty());
    expectNear(absorptionOf(opened.materials.at(0)), absorptionOf(scene.materials[0]), 1e-5f);
}

/// What is laid out anew keeps its light.
TEST_F(PbrtExport, EnvironmentsKeepTheirLight) {
    SceneDescription scene = repositoryScene("cornell.json");
    scene = load("LightSource \"infinite\" Shape \"sphere\"");
    auto sky = std::make_shared<ImageF>(ImageF{64, 32, std::vector<float>(size_t{3} * 64 * 32, 0.1f)});
    for (size_t i = 0; i < 64; ++i) {  // a bright patch
        sky->rgb[3 * (8 * 64 + 20 + i % 8 + i / 8 * 64)] = 20.0f;
    }
    scene.environmentImages = {{.source = {}, .bytes = {}, .floats = sky}};
    scene.environment.image = 0;
    scene.environment.rotationDeg = 40.0f;
    scene.resolution = {16, 16};
    const SceneDescription opened = exported(scene);
    EXPECT_THAT(warnings, Contains("approximated: the environment is laid out anew"));
    const Estimate before = meanLuminance(renderFilm(scene, 256)),
                   after = meanLuminance(renderFilm(opened, 256));
    EXPECT_TRUE(agree(before, after, 0.02)) << before.mean << " " << after.mean;
}

/// Constants go through the coat's index and back, by name or as numbers.
TEST_F(PbrtExport, CoatedMetalsStayCoated) {
    for (
        const char* metal :
        {R"("float interface.eta" 1.7 "float conductor.roughness" 0.04)",
         R"("spectrum conductor.eta" "metal-Au-eta" "spectrum conductor.k" "metal-Au-k" "float thickness" 0.25)",
         R"("rgb conductor.eta" [0.2 0.37 1.1] "rgb conductor.k" [3.9 2.4 2.1] "float interface.eta" 1.37)",
         R"("rgb reflectance" [0.9 0.6 0.3] "float conductor.uroughness" 0.01 "float conductor.vroughness" 0.09
             "float interface.roughness" 0.02)"}) {
        SceneDescription scene =
            load(std::string("LightSource \"point\" \"point3 from\" [1 2 5] Material \"coatedconductor\" ") +
                 metal + " Shape \"sphere\"");
        scene.resolution = {16, 12};
        const SceneDescription opened = exported(scene);
        EXPECT_THAT(warnings, Contains("approximated: light goes back and forth under coats over metal"));
        const Material &a = scene.materials.at(0), &b = opened.materials.at(0);
        EXPECT_EQ(b.kind, MaterialKind::Coated);
        EXPECT_EQ(a.eta.value, b.eta.value) << metal;
        EXPECT_EQ(a.k.value, b.k.value) << metal;
        EXPECT_EQ(a.coatAbsorption, b.coatAbsorption) << metal;
        expectSameBits(renderPasses(scene, 2, 2), renderPasses(opened, 2, 2));
    }
    SceneDescription tinted = load("Material \"coatedconductor\" Shape \"sphere\"");
    Material& metal = tinted.materials.at(0);
    metal.color.value = {0.5f, 0.8f, 0.9f};
    metal.coatAbsorption.value = {0.1f, 0.2f, 0.3f};
    const Material opened = exported(tinted).materials.at(0);
    expectNear(reflectanceHeadOn(opened), metal.color.value * reflectanceHeadOn(metal), 1e-4f);
    EXPECT_NEAR(opened.coatAbsorption.value.x, 0.186f, 0.01f) << "its luminance";
    EXPECT_THAT(warnings, Contains("approximated: coats over metal absorb all colours alike, everywhere"));
    EXPECT_THAT(
        warnings,
        Contains("approximated: tinted metals under coats have the colour that they show from the front"));
}

TEST_F(PbrtExport, WhatPbrtDoesNotHaveIsSaid) {
    SceneDescription scene = repositoryScene("cornell_glass_mirror.json");
    scene.options.filter = FilterKind::BlackmanHarris;
    scene.camera.apertureDiameter = 0.1f;
    scene.camera.apertureBlades = 6;
    scene.materials[0].kind = MaterialKind::Mixture;
    scene.materials[0].name = "a \"name\"";
    const SceneDescription opened = exported(scene);
    EXPECT_THAT(warnings, Contains("approximated: the filter is a Gaussian"));
    EXPECT_THAT(warnings, Contains("approximated: the aperture is round"));
    EXPECT_THAT(warnings, Contains("approximated: mixtures are their heaviest part"));
    EXPECT_THAT(warnings, Contains("approximated: mirrors are metals of their colour"));
    EXPECT_EQ(opened.objects.size(), scene.objects.size());
}

TEST_F(PbrtExport, CapsOfTurnedProfilesAreKept) { expectCapsAreKept(load("Shape \"sphere\"")); }

TEST_F(PbrtExport, TexturedPlanesAreKept) { expectTexturedPlanesAreKept(); }

TEST_F(PbrtExport, LightsOfRayCastingAreLeftOut) { expectCastLightsAreLeftOut(load("Shape \"sphere\"")); }

}  // namespace
}  // namespace glint::test
