// pbrt's sheets that light passes, and what absorbs within its glass.
#include "tests/support/pbrt_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

using PbrtMedia = PbrtTest;

TEST_F(PbrtMedia, SheetsLetLightThrough) {
    const Material leaf = materialOf(
        "Material \"diffusetransmission\" \"rgb reflectance\" [0.2 0.2 0.4] \"rgb transmittance\" [0.3 0 "
        "0.6] \"float scale\" 0.5");
    EXPECT_EQ(leaf.kind, MaterialKind::Translucent);
    EXPECT_EQ(leaf.color.value, Vec3(0.1f, 0.1f, 0.2f));
    EXPECT_EQ(leaf.transmission.value, Vec3(0.15f, 0, 0.3f));
    EXPECT_EQ(materialOf("Material \"diffusetransmission\"").transmission.value, Vec3(0.25f));
    EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(PbrtMedia, GlassAbsorbsAsItsMedium) {
    const std::string ruby = R"(MakeNamedMedium "ruby" "string type" "homogeneous" "rgb sigma_a" [0.5 2 1]
"rgb sigma_s" [0 0 0] "float scale" 2 MediumInterface "ruby" "" )";
    expectNear(absorptionOf(materialOf(ruby + "Material \"dielectric\"")), Vec3(1, 4, 2), 1e-4f);
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_TRUE(isZero(absorptionOf(materialOf(ruby + "Material \"diffuse\""))));
    EXPECT_THAT(warnings, Contains(HasSubstr("media are left out but within glass")));
    const SceneDescription scene =
        load(ruby + R"(Material "dielectric" AttributeBegin MediumInterface "" "" Shape "sphere"
AttributeEnd Shape "sphere")");
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_TRUE(isZero(absorptionOf(scene.materials[0])));
    EXPECT_FALSE(isZero(absorptionOf(scene.materials[1])));
}

TEST_F(PbrtMedia, OtherMediaAreSaid) {
    materialOf(
        "MakeNamedMedium \"fog\" \"string type\" \"uniformgrid\" MediumInterface \"fog\" \"fog\" Material "
        "\"dielectric\"");
    EXPECT_THAT(warnings, Contains(HasSubstr("media that are not alike all over")));
    EXPECT_THAT(warnings, Contains(HasSubstr("media around shapes")));
    materialOf(
        "MakeNamedMedium \"milk\" \"string type\" \"homogeneous\" MediumInterface \"milk\" \"\" Material "
        "\"dielectric\"");
    EXPECT_THAT(warnings, Contains(HasSubstr("absorb, but scatter nothing")));
    EXPECT_THAT(errorOf("MediumInterface \"none\" \"\" Shape \"sphere\""),
                HasSubstr("there is no medium \"none\""));
}

}  // namespace
}  // namespace glint::test
