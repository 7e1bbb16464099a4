// Mitsuba's phong and ward as Glint's.
#include "tests/support/mitsuba_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

using MitsubaHighlights = MitsubaTest;

TEST_F(MitsubaHighlights, DefaultsAreMitsubas) {
    const Material phong = materialOf("<bsdf type='phong'/>");
    EXPECT_EQ(phong.kind, MaterialKind::Phong);
    EXPECT_EQ(phong.color.value, Vec3(0.5f));
    EXPECT_EQ(phong.specularReflectance.value, Vec3(0.2f));
    EXPECT_EQ(phong.exponent.value, 30.0f);
    const Material ward = materialOf("<bsdf type='ward'/>");
    EXPECT_EQ(ward.kind, MaterialKind::Ward);
    EXPECT_EQ(ward.color.value, Vec3(0.5f));
    EXPECT_EQ(ward.specularReflectance.value, Vec3(0.2f));
    EXPECT_EQ(ward.roughness.value, 0.1f);
    EXPECT_FALSE(hasCrossRoughness(ward));
    EXPECT_EQ(ward.wardForm, WardForm::Balanced);
    EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(MitsubaHighlights, ParametersAreRead) {
    const Material phong = materialOf(
        "<bsdf type='phong'><rgb name='diffuseReflectance' value='0.1 0.2 0.3'/><rgb "
        "name='specularReflectance' value='0.3 0.2 0.1'/><float name='exponent' value='250'/></bsdf>");
    EXPECT_EQ(phong.color.value, Vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(phong.specularReflectance.value, Vec3(0.3f, 0.2f, 0.1f));
    EXPECT_EQ(phong.exponent.value, 250.0f);
    EXPECT_THAT(warnings, IsEmpty());
    const Material ward = materialOf(
        "<bsdf type='ward'><string name='variant' value='ward-duer'/><float name='alphaU' "
        "value='0.2'/><float "
        "name='alphaV' value='0.4'/></bsdf>");
    EXPECT_EQ(ward.wardForm, WardForm::Duer);
    EXPECT_EQ(ward.roughness.value, 0.2f);
    EXPECT_EQ(ward.crossRoughness.value, 0.4f);
    EXPECT_THAT(warnings, Contains(HasSubstr("approximated: Ward's highlights gain no light")));
    EXPECT_THAT(errorOf("<shape type='sphere'><bsdf type='ward'><string name='variant' value='worn'/></bsdf>"
                        "</shape>"),
                HasSubstr("variant \"worn\""));
}

/// 0.99 over the largest sum, as in Mitsuba 0.6.
TEST_F(MitsubaHighlights, ReflectancesAreScaledTogether) {
    const std::string bright =
        "<bsdf type='phong'><float name='diffuseReflectance' value='0.9'/><rgb name='specularReflectance' "
        "value='0.6 0.3 0'/>";
    const Material scaled = materialOf(bright + "</bsdf>");
    expectNear(scaled.color.value, Vec3(0.9f * 0.66f), 1e-6f);
    expectNear(scaled.specularReflectance.value, Vec3(0.6f, 0.3f, 0.0f) * 0.66f, 1e-6f);
    const Material kept =
        materialOf(bright + "<boolean name='ensureEnergyConservation' value='false'/></bsdf>");
    EXPECT_EQ(kept.color.value, Vec3(0.9f));
    EXPECT_THAT(warnings, Contains(HasSubstr("approximated: Phong's and Ward's models gain no light")));
    const SceneDescription boards = load(
        "<shape type='sphere'><bsdf type='phong'><texture type='checkerboard' name='diffuseReflectance'>"
        "<float name='color0' value='0.75'/><float name='color1' value='0.1'/></texture><float "
        "name='specularReflectance' value='0.75'/></bsdf></shape>");
    const Material& board = boards.materials.at(0);
    const Texture& texture = boards.textures.at(static_cast<size_t>(board.color.texture));
    expectNear(std::get<Checkerboard>(texture.image.source).even, Vec3(0.75f * 0.66f), 1e-6f);
    expectNear(board.specularReflectance.value, Vec3(0.75f * 0.66f), 1e-6f);
}

}  // namespace
}  // namespace glint::test
