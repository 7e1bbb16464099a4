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

TEST_F(MitsubaLayers, CoatsLieOverMetal) {
    const Material coated = materialOf(
        "<bsdf type='roughcoating'><float name='int_ior' value='1.5'/><float name='ext_ior' "
        "value='1'/><string "
        "name='distribution' value='ggx'/><float name='alpha' value='0.2'/><bsdf "
        "type='roughconductor'><string "
        "name='material' value='Au'/><float name='alpha' value='0.3'/></bsdf></bsdf>");
    EXPECT_EQ(coated.kind, MaterialKind::Principled);
    EXPECT_EQ(coated.metallic.value, 1.0f);
    EXPECT_FLOAT_EQ(coated.clearcoat.value, 1.0f);
    EXPECT_FLOAT_EQ(coated.clearcoatRoughness.value, 0.2f);
    EXPECT_FLOAT_EQ(coated.roughness.value, 0.3f);
    EXPECT_GT(coated.color.value.x, 1.5f * coated.color.value.z) << "gold";
    EXPECT_THAT(warnings, Contains(HasSubstr("approximated: coats over metal")));
}

}  // namespace
}  // namespace glint::test
