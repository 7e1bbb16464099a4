// Glass that absorbs, sheets that light passes and layers, in the Materials panel: edited live, and saved.
#include <filesystem>

#include <gtest/gtest.h>

#include "engine/io/scene_loader.h"
#include "tests/viewer/play_script.h"

namespace glint::test {
namespace {

Material editedBy(const std::string& edits) {
    std::filesystem::remove("saved.json");
    write("ball.json", R"({
  "glint": 1, "resolution": [64, 48],
  "camera": { "position": [0, 1, 4], "target": [0, 1, 0] },
  "materials": { "grey": { "type": "diffuse", "color": 0.5 } },
  "objects": [{ "type": "sphere", "material": "grey", "center": [0, 1, 0], "radius": 1 }],
  "environment": { "color": 1 }
})");
    write("script.txt", "wait picture\nopen \"Materials\"\nopen \"Checkpoint\"\nwait frames 2\n" + edits +
                            "wait picture\nset \"Scene file\" saved.json\nclick \"Save scene\"\nwait jobs\n");
    expectPlayed(run("view ball.json --headless --threads 1 --script script.txt"));
    const auto saved = loadScene("saved.json");
    EXPECT_TRUE(saved.ok()) << saved.error().format();
    return saved ? saved->materials.at(0) : Material();
}

TEST(MaterialsViewer, GlassAbsorbs) {
    const Material glass = editedBy(R"(
set "Materials/Kind" Dielectric
expect no-widget "Attenuation distance"
set "Attenuation" 0.5 0.25 1
wait frames 2
set "Attenuation distance" 0.2
)");
    EXPECT_EQ(glass.kind, MaterialKind::Dielectric);
    EXPECT_EQ(glass.attenuationColor, Vec3(0.5f, 0.25f, 1.0f));
    EXPECT_FLOAT_EQ(glass.attenuationDistance, 0.2f);
}

/// They begin with those of the glass that was shown.
TEST(MaterialsViewer, GlassHasThreeIndicesWhereOneAsksForThem) {
    const Material glass = editedBy(R"(
set "Materials/Kind" Dielectric
wait frames 2
set "Materials/Glass" SF11
wait frames 2
set "Materials/Glass" "three indices"
wait frames 2
expect no-widget "Abbe number"
)");
    EXPECT_TRUE(glass.glass.empty());
    EXPECT_NEAR(glass.iorRgb.x, 1.7814f, 2e-4f) << "SF11 at 611 nm, by Schott's Sellmeier coefficients";
    EXPECT_NEAR(glass.iorRgb.z, 1.8134f, 2e-4f) << "at 465 nm";
    const Material plain = editedBy(R"(
set "Materials/Kind" Dielectric
wait frames 2
set "Materials/Glass" "three indices"
wait frames 2
set "IOR RGB" 1.4 1.6 1.7
set "Materials/Glass" "own index"
wait frames 2
expect "IOR" 1.6
)");
    EXPECT_EQ(plain.iorRgb, Vec3(0.0f));
}

TEST(MaterialsViewer, SheetsLetLightThrough) {
    const Material sheet = editedBy(R"(
set "Materials/Kind" Translucent
wait frames 2
set "Transmission" 0.5 0.25 0.125
)");
    EXPECT_EQ(sheet.kind, MaterialKind::Translucent);
    EXPECT_EQ(sheet.transmission.value, Vec3(0.5f, 0.25f, 0.125f));
}

TEST(MaterialsViewer, PrincipledMaterialsLetLightPass) {
    const Material bottle = editedBy(R"(
set "Materials/Kind" Principled
expect no-widget "Root tint"
set "Transmission" 0.5
wait frames 2
set "Root tint" on
set "Attenuation" 0.5 0.25 1
wait frames 2
set "Attenuation distance" 2
)");
    EXPECT_EQ(bottle.specularTransmission.value, 0.5f);
    EXPECT_TRUE(bottle.rootTint);
    EXPECT_EQ(bottle.attenuationColor, Vec3(0.5f, 0.25f, 1.0f));
    EXPECT_EQ(bottle.attenuationDistance, 2.0f);
}

TEST(MaterialsViewer, MetalsAreCoated) {
    const Material lacquer = editedBy(R"(
set "Materials/Kind" Coated
wait frames 2
set "IOR" 1.75
set "Roughness" 0.25
set "Coat roughness" 0.125
set "Coat absorption" 0.5 0.25 2
)");
    EXPECT_EQ(lacquer.kind, MaterialKind::Coated);
    EXPECT_EQ(lacquer.ior.value, 1.75f);
    EXPECT_EQ(lacquer.roughness.value, 0.25f);
    EXPECT_EQ(lacquer.clearcoatRoughness.value, 0.125f);
    EXPECT_EQ(lacquer.coatAbsorption.value, Vec3(0.5f, 0.25f, 2.0f));
}

TEST(MaterialsViewer, HighlightsAreEdited) {
    const Material phong = editedBy(R"(
set "Materials/Kind" Phong
wait frames 2
set "Specular reflectance" 0.5 0.25 0.125
set "Exponent" 200
)");
    EXPECT_EQ(phong.kind, MaterialKind::Phong);
    EXPECT_EQ(phong.specularReflectance.value, Vec3(0.5f, 0.25f, 0.125f));
    EXPECT_EQ(phong.exponent.value, 200.0f);
    const Material ward = editedBy(R"(
set "Materials/Kind" Ward
expect no-widget "Exponent"
wait frames 2
set "Form" "Ward 1992"
set "Roughness" 0.25
set "Anisotropic" on
wait frames 2
set "Roughness across" 0.5
)");
    EXPECT_EQ(ward.kind, MaterialKind::Ward);
    EXPECT_EQ(ward.wardForm, WardForm::Ward);
    EXPECT_EQ(ward.roughness.value, 0.25f);
    EXPECT_EQ(ward.crossRoughness.value, 0.5f);
}

TEST(MaterialsViewer, LayersAreEdited) {
    const Material paint = editedBy(R"(
set "Materials/Kind" Principled
expect no-widget "Coat roughness"
expect no-widget "Sheen roughness"
set "Metallic" 0.5
set "Specular" 0.75
set "Specular tint" 1 0.5 0.25
set "Clear coat" 1
set "Sheen" 0.5 0.25 0.125
wait frames 2
set "Coat roughness" 0.125
set "Sheen roughness" 0.625
)");
    EXPECT_EQ(paint.kind, MaterialKind::Principled);
    EXPECT_EQ(paint.metallic.value, 0.5f);
    EXPECT_EQ(paint.specular.value, 0.75f);
    EXPECT_EQ(paint.specularTint.value, Vec3(1.0f, 0.5f, 0.25f));
    EXPECT_EQ(paint.clearcoat.value, 1.0f);
    EXPECT_EQ(paint.clearcoatRoughness.value, 0.125f);
    EXPECT_EQ(paint.sheenColor.value, Vec3(0.5f, 0.25f, 0.125f));
    EXPECT_EQ(paint.sheenRoughness.value, 0.625f);
}

}  // namespace
}  // namespace glint::test
