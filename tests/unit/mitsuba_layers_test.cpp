// Mitsuba's principled model and its coats as Glint's principled materials.
#include "tests/support/mitsuba_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

using MitsubaLayers = MitsubaTest;

/// Burley's inputs as Mitsuba names them.
TEST_F(MitsubaLayers, PrincipledIsPrincipled) {
    const Material paint = materialOf(
        "<bsdf type='principled'><rgb name='base_color' value='0.8 0.2 0.1'/><float name='metallic' "
        "value='0.7'/>"
        "<float name='roughness' value='0.5'/><float name='specular' value='0.5'/><float name='clearcoat' "
        "value='1'/><float name='clearcoat_gloss' value='1'/><float name='sheen' value='0.5'/></bsdf>");
    EXPECT_EQ(paint.color.value, Vec3(0.8f, 0.2f, 0.1f));
    EXPECT_EQ(paint.metallic.value, 0.7f);
    EXPECT_EQ(paint.roughness.value, 0.25f);
    EXPECT_NEAR(paint.ior.value, 1.5f, 1e-5f) << "4 % head on";
    EXPECT_EQ(paint.clearcoat.value, 0.25f);
    EXPECT_NEAR(paint.clearcoatRoughness.value, 0.001f, 1e-7f);
    expectNear(paint.sheenColor.value, Vec3(0.05f), 1e-6f);
    EXPECT_EQ(paint.specularTint.value, Vec3(1.0f));
    const SceneDescription scene = load(
        "<shape type='sphere'><bsdf type='principled'><texture type='checkerboard' name='metallic'><float "
        "name='color0' value='0.7'/><float name='color1' value='0.1'/></texture><texture type='checkerboard' "
        "name='roughness'><float name='color0' value='0.5'/><float name='color1' value='1'/></texture>"
        "</bsdf></shape>");
    const Material& worn = scene.materials.at(0);
    const auto board = [&](const NumberInput& input) {
        return std::get<Checkerboard>(scene.textures.at(static_cast<size_t>(input.texture)).image.source);
    };
    EXPECT_EQ(board(worn.metallic).even, Vec3(0.7f));
    EXPECT_EQ(board(worn.roughness).even, Vec3(0.25f)) << "alpha is the square";
    EXPECT_EQ(board(worn.roughness).odd, Vec3(1.0f));
}

/// Bodies are tinted by the root of the colour, sheets by all of it, and reflect as much as they let pass.
TEST_F(MitsubaLayers, LightPassesInPart) {
    const std::string share =
        "<float name='spec_trans' value='0.25'/><float name='roughness' value='0.5'/></bsdf>";
    const Material body = materialOf("<bsdf type='principled'>" + share);
    EXPECT_EQ(body.kind, MaterialKind::Principled);
    EXPECT_EQ(body.specularTransmission.value, 0.25f);
    EXPECT_EQ(body.specular.value, 1.0f);
    EXPECT_TRUE(body.rootTint);
    EXPECT_FALSE(body.thin);
    const Material sheet = materialOf("<bsdf type='principledthin'>" + share);
    EXPECT_EQ(sheet.kind, MaterialKind::Principled);
    EXPECT_EQ(sheet.specularTransmission.value, 0.25f);
    EXPECT_EQ(sheet.specular.value, 0.25f);
    EXPECT_FALSE(sheet.rootTint);
    EXPECT_TRUE(sheet.thin);
    const SceneDescription scene = load(
        "<shape type='sphere'><bsdf type='principled'><texture type='checkerboard' name='spec_trans'><float "
        "name='color0' value='0.75'/><float name='color1' value='0'/></texture></bsdf></shape>");
    const int texture = scene.materials.at(0).specularTransmission.texture;
    ASSERT_GE(texture, 0);
    EXPECT_EQ(std::get<Checkerboard>(scene.textures[static_cast<size_t>(texture)].image.source).even,
              Vec3(0.75f));
}

TEST_F(MitsubaLayers, CoatsLieOverMetal) {
    const std::string gold =
        "<bsdf type='roughconductor'><string name='material' value='Au'/><float name='alpha' "
        "value='0.3'/></bsdf></bsdf>";
    const Material coated = materialOf(
        "<bsdf type='coating'><float name='intIOR' value='1.7'/><float name='extIOR' value='1'/><float "
        "name='thickness' value='2'/><rgb name='sigmaA' value='0.1 0.2 0.5'/>" +
        gold);
    EXPECT_EQ(coated.kind, MaterialKind::Coated);
    EXPECT_FLOAT_EQ(coated.ior.value, 1.7f);
    EXPECT_FLOAT_EQ(coated.clearcoatRoughness.value, 0.0f);
    EXPECT_FLOAT_EQ(coated.roughness.value, 0.3f);
    EXPECT_EQ(coated.distribution, FacetDistribution::Beckmann);
    EXPECT_GT(coated.k.value.x, 1.3f * coated.k.value.z) << "gold";
    expectNear(coated.coatAbsorption.value, Vec3(0.2f, 0.4f, 1.0f), 1e-6f);
    EXPECT_THAT(warnings, testing::IsEmpty());
    const Material rough = materialOf("<bsdf type='roughcoating'><float name='alpha' value='0.2'/>" + gold);
    EXPECT_FLOAT_EQ(rough.clearcoatRoughness.value, 0.2f);
    EXPECT_THAT(warnings, Contains(HasSubstr("approximated: rough coats over metal")));
    const Material mirror = materialOf("<bsdf type='coating'><bsdf type='conductor'/></bsdf>");
    EXPECT_EQ(mirror.kind, MaterialKind::Coated);
    EXPECT_EQ(mirror.k.value, Vec3(1e4f));
    materialOf("<bsdf type='coating'><bsdf type='coating'>" + gold + "</bsdf>");
    EXPECT_THAT(warnings, Contains(HasSubstr("approximated: coats over glass")));
}

}  // namespace
}  // namespace glint::test
