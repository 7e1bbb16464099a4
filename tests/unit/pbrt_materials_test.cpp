// pbrt's materials and colours as Glint's.
#include <cmath>

#include "engine/io/pbrt_color.h"
#include "engine/math/color.h"
#include "engine/scene/metals.h"
#include "tests/support/pbrt_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class PbrtMaterialsTest : public PbrtTest {
  protected:
    Vec3 reflectance(const std::string& value) {
        return materialOf("Material \"diffuse\" " + value).color.value;
    }
};

TEST_F(PbrtMaterialsTest, ColoursAreLinear) {
    EXPECT_EQ(reflectance(""), Vec3(0.5f));
    EXPECT_EQ(reflectance("\"rgb reflectance\" [0.1 0.2 0.3]"), Vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(reflectance("\"rgb reflectance\" [2 0.2 0]"), Vec3(1, 0.2f, 0));
    EXPECT_THAT(warnings, Contains(HasSubstr("reflectances beyond 0 to 1")));
    expectNear(reflectance("\"spectrum reflectance\" [350 0.3 800 0.3]"), Vec3(0.3f), 1e-3f);
    folder.write("flat.spd", "# nm, share\n350 0.3\n800 0.3\n");
    expectNear(reflectance("\"spectrum reflectance\" \"flat.spd\""), Vec3(0.3f), 1e-3f);
    EXPECT_EQ(materialOf("").color.value, Vec3(0.5f));
}

/// Of other spaces, white is white, and primaries lie outside Rec.709 or within.
TEST_F(PbrtMaterialsTest, ColourSpacesHaveTheirPrimaries) {
    for (const PbrtColorSpace space :
         {PbrtColorSpace::Srgb, PbrtColorSpace::Rec2020, PbrtColorSpace::Aces2065, PbrtColorSpace::DciP3}) {
        expectNear(rgbOfSpace(space, Vec3(1.0f), SpectrumRole::Reflectance), Vec3(1.0f), 1e-3f);
        EXPECT_NEAR(luminance(rgbOfSpace(space, Vec3(1.0f), SpectrumRole::Emission)), 1.0f, 1e-3f);
    }
    // ITU-R BT.2087, annex 2: the inverse of its matrix M2.
    expectNear(rgbOfSpace(PbrtColorSpace::Rec2020, Vec3(1, 0, 0), SpectrumRole::Emission),
               Vec3(1.6605f, -0.1246f, -0.0182f), 2e-3f);
    // The white of ACES is redder than D65.
    const Vec3 white = rgbOfSpace(PbrtColorSpace::Aces2065, Vec3(1.0f), SpectrumRole::Emission);
    EXPECT_GT(white.x, white.z + 0.1f);
    const SceneDescription scene = load(
        "AttributeBegin ColorSpace \"rec2020\" Material \"diffuse\" \"rgb reflectance\" [0.3 0.5 0.4] Shape "
        "\"sphere\" AttributeEnd Material \"diffuse\" \"rgb reflectance\" [0.3 0.5 0.4] Shape \"sphere\"");
    expectNear(scene.materials.at(0).color.value,
               rgbOfSpace(PbrtColorSpace::Rec2020, Vec3(0.3f, 0.5f, 0.4f), SpectrumRole::Reflectance), 1e-6f);
    EXPECT_EQ(scene.materials.at(1).color.value, Vec3(0.3f, 0.5f, 0.4f));
    EXPECT_THAT(errorOf("ColorSpace \"xyz\""), HasSubstr("is no colour space"));
}

TEST_F(PbrtMaterialsTest, Conductors) {
    Material metal = materialOf("Material \"conductor\"");
    EXPECT_EQ(metal.kind, MaterialKind::Conductor);
    EXPECT_EQ(metal.metal, "copper");
    EXPECT_EQ(metal.roughness.value, 0.0f);
    metal = materialOf(
        R"(Material "conductor" "spectrum eta" "metal-Au-eta" "spectrum k" "metal-Au-k" "float roughness" 0.09)");
    EXPECT_EQ(metal.metal, "gold");
    EXPECT_NEAR(metal.roughness.value, 0.3f, 1e-6f);
    EXPECT_THAT(warnings, IsEmpty());
    metal = materialOf(
        R"(Material "conductor" "spectrum eta" "metal-Ag-eta" "rgb k" [3 4 5] "bool remaproughness" false
"float uroughness" 0.1 "float vroughness" 0.4)");
    EXPECT_TRUE(metal.metal.empty());
    EXPECT_EQ(metal.eta.value, findMetal("silver")->eta);
    EXPECT_EQ(metal.k.value, Vec3(3, 4, 5));
    EXPECT_NEAR(metal.roughness.value, 0.1f, 1e-6f);
    EXPECT_NEAR(metal.crossRoughness.value, 0.4f, 1e-6f);
    EXPECT_THAT(warnings, IsEmpty());
    // At right angles, a metal of eta 1 reflects k^2 / (4 + k^2).
    metal = materialOf("Material \"conductor\" \"rgb reflectance\" [0.5 0.2 0.8]");
    const Vec3 k2 = metal.k.value * metal.k.value;
    expectNear(k2 / (Vec3(4.0f) + k2), Vec3(0.5f, 0.2f, 0.8f), 1e-5f);
    EXPECT_EQ(metal.eta.value, Vec3(1.0f));
    metal = materialOf(
        R"(Material "coatedconductor" "spectrum conductor.eta" "metal-Al-eta" "spectrum conductor.k" "metal-Al-k"
"float conductor.roughness" 0.04 "float interface.roughness" 0.1)");
    EXPECT_EQ(metal.eta.value, findMetal("aluminium")->eta / 1.5f) << "against the coat";
    EXPECT_EQ(metal.k.value, findMetal("aluminium")->k / 1.5f);
    EXPECT_TRUE(metal.metal.empty());
    EXPECT_NEAR(metal.roughness.value, 0.2f, 1e-6f);
    EXPECT_THAT(warnings, Contains(HasSubstr("coats over metal")));
}

TEST_F(PbrtMaterialsTest, Dielectrics) {
    Material glass = materialOf("Material \"dielectric\"");
    EXPECT_EQ(glass.kind, MaterialKind::Dielectric);
    EXPECT_FLOAT_EQ(glass.ior.value, 1.5f);
    EXPECT_EQ(glass.color.value, Vec3(1.0f));
    EXPECT_FALSE(glass.thin);
    glass = materialOf("Material \"dielectric\" \"float eta\" 1.33 \"float roughness\" 0.25");
    EXPECT_FLOAT_EQ(glass.ior.value, 1.33f);
    EXPECT_FLOAT_EQ(glass.roughness.value, 0.5f);
    EXPECT_EQ(materialOf("Material \"dielectric\" \"spectrum eta\" \"glass-BK7\"").glass, "BK7");
    for (const auto& [pbrts, schotts] : {std::pair("F5", "SF5"), {"F10", "SF10"}, {"F11", "SF11"}}) {
        EXPECT_EQ(
            materialOf(std::string("Material \"dielectric\" \"spectrum eta\" \"glass-") + pbrts + "\"").glass,
            schotts);
    }
    EXPECT_NEAR(materialOf("Material \"dielectric\" \"spectrum eta\" \"glass-BAF10\"").ior.value, 1.67f,
                1e-3f);
    EXPECT_TRUE(materialOf("Material \"thindielectric\"").thin);
    EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(PbrtMaterialsTest, CoatsAreOfPlastic) {
    const Material plastic = materialOf(
        "Material \"coateddiffuse\" \"rgb reflectance\" [0.1 0.2 0.3] \"float roughness\" 0.01 \"float eta\" "
        "1.6");
    EXPECT_EQ(plastic.kind, MaterialKind::Plastic);
    EXPECT_EQ(plastic.color.value, Vec3(0.1f, 0.2f, 0.3f));
    EXPECT_NEAR(plastic.roughness.value, 0.1f, 1e-6f);
    EXPECT_FLOAT_EQ(plastic.ior.value, 1.6f);
    EXPECT_THAT(warnings, IsEmpty());
    materialOf("Material \"coateddiffuse\" \"rgb albedo\" [0.5 0.5 0.5]");
    EXPECT_THAT(warnings, Contains(HasSubstr("nothing scatters within coats")));
    materialOf("Material \"coateddiffuse\" \"float thickness\" 0.5");
    EXPECT_THAT(warnings, Contains(HasSubstr("coats of plastic absorb nothing")));
    EXPECT_NEAR(materialOf("Material \"coateddiffuse\" \"spectrum eta\" \"glass-BK7\"").ior.value, 1.5168f,
                2e-3f);
    EXPECT_THAT(warnings, Contains(HasSubstr("coats do not disperse")));
}

/// eta and k are divided by the coat's index, and a unit of thickness is one optical depth.
TEST_F(PbrtMaterialsTest, CoatsOverMetal) {
    Material coated = materialOf("Material \"coatedconductor\"");
    EXPECT_EQ(coated.kind, MaterialKind::Coated);
    EXPECT_EQ(coated.ior.value, 1.5f);
    EXPECT_EQ(coated.eta.value, findMetal("copper")->eta / 1.5f);
    EXPECT_EQ(coated.roughness.value, 0.0f);
    EXPECT_EQ(coated.clearcoatRoughness.value, 0.0f);
    EXPECT_EQ(coated.coatAbsorption.value, Vec3(0.01f));
    EXPECT_EQ(coated.color.value, Vec3(1.0f));
    EXPECT_THAT(warnings, ElementsAre(HasSubstr("go back and forth under coats over metal")));
    coated = materialOf(R"(Material "coatedconductor" "float interface.eta" 2 "float thickness" 0.3
"rgb conductor.eta" [0.2 0.4 0.6] "rgb conductor.k" [3 2 1] "float interface.roughness" 0.04
"float conductor.uroughness" 0.09 "float conductor.vroughness" 0.25 "float g" 0.5)");
    EXPECT_EQ(coated.ior.value, 2.0f);
    expectNear(coated.eta.value, Vec3(0.1f, 0.2f, 0.3f), 1e-6f);
    expectNear(coated.k.value, Vec3(1.5f, 1.0f, 0.5f), 1e-6f);
    EXPECT_NEAR(coated.clearcoatRoughness.value, 0.2f, 1e-6f);
    EXPECT_NEAR(coated.roughness.value, 0.3f, 1e-6f);
    EXPECT_NEAR(coated.crossRoughness.value, 0.5f, 1e-6f);
    EXPECT_EQ(coated.coatAbsorption.value, Vec3(0.3f));
    EXPECT_THAT(warnings, Contains(HasSubstr("rough coats over metal")));
    coated =
        materialOf(R"(Material "coatedconductor" "bool remaproughness" false "rgb reflectance" [0.9 0.6 0.3]
"float interface.uroughness" 0.1 "float interface.vroughness" 0.2 "float conductor.roughness" 0.3
"rgb albedo" [0.5 0.25 0] "float thickness" 0.4 "spectrum interface.eta" "glass-BK7")");
    EXPECT_NEAR(coated.ior.value, 1.5168f, 2e-3f);
    expectNear(coated.eta.value * coated.ior.value, Vec3(1.0f), 1e-6f);
    const Vec3 k = coated.k.value * coated.ior.value;
    expectNear(k * k / (Vec3(4.0f) + k * k), Vec3(0.9f, 0.6f, 0.3f), 1e-5f);
    EXPECT_FLOAT_EQ(coated.clearcoatRoughness.value, 0.1f);
    EXPECT_FLOAT_EQ(coated.roughness.value, 0.3f);
    expectNear(coated.coatAbsorption.value, Vec3(0.2f, 0.3f, 0.4f), 1e-6f);
    for (const char* said : {"nothing scatters within coats", "coats do not disperse", "rough as along u"}) {
        EXPECT_THAT(warnings, Contains(HasSubstr(said)));
    }
}

/// What a metal of eta 1 that reflects r in air reflects within a coat of index 1.5.
TEST_F(PbrtMaterialsTest, PicturesUnderCoatsReflectAsMetalsThere) {
    const Material coated =
        materialOf(R"(Texture "t" "spectrum" "checkerboard" "rgb tex1" [0.5 0 1] "rgb tex2" [0 1 0.5]
Material "coatedconductor" "texture reflectance" "t")");
    ASSERT_GE(coated.color.texture, 0);
    const auto& pixels = textures[static_cast<size_t>(coated.color.texture)].image.floats;
    ASSERT_TRUE(pixels);
    const auto within = [](float r) {
        const float k2 = 4.0f * r / (1.0f - r);  // (eta - n)^2 + k^2 over (eta + n)^2 + k^2
        return r < 1.0f ? (0.25f + k2) / (6.25f + k2) : 1.0f;
    };
    const bool isFirst = pixels->rgb[1] < 0.1f;
    const Vec3 bare = isFirst ? Vec3(0.5f, 0.0f, 1.0f) : Vec3(0.0f, 1.0f, 0.5f);
    expectNear(Vec3(pixels->rgb[0], pixels->rgb[1], pixels->rgb[2]),
               Vec3(within(bare.x), within(bare.y), within(bare.z)), 1e-4f);
    EXPECT_THAT(warnings, Contains(HasSubstr("alike at all angles")));
}

TEST_F(PbrtMaterialsTest, NamedMaterialsAndMixtures) {
    const std::string two = R"(MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [1 0 0]
MakeNamedMaterial "blue" "string type" "diffuse" "rgb reflectance" [0 0 1]
MakeNamedMaterial "air" "string type" "interface" )";
    Material material = materialOf(two + "NamedMaterial \"blue\"");
    EXPECT_EQ(material.color.value, Vec3(0, 0, 1));
    EXPECT_EQ(material.name, "blue");
    EXPECT_EQ(materialOf(two + R"(Material "mix" "string materials" ["red" "blue"] "float amount" 0.25)")
                  .color.value,
              Vec3(0.75f, 0, 0.25f));
    material = materialOf(two + R"(Material "mix" "string materials" ["red" "air"] "float amount" 0.25)");
    EXPECT_EQ(material.color.value, Vec3(1, 0, 0));
    EXPECT_FLOAT_EQ(material.opacity.value, 0.75f);
    EXPECT_THAT(warnings, IsEmpty());
    material = materialOf(two + R"(Texture "t" "float" "checkerboard"
Material "mix" "string materials" ["red" "blue"] "texture amount" "t")");
    ASSERT_GE(material.color.texture, 0);
    const auto& pixels = textures[static_cast<size_t>(material.color.texture)].image.floats;
    ASSERT_TRUE(pixels);
    EXPECT_EQ(Vec3(pixels->rgb[0], pixels->rgb[1], pixels->rgb[2]) +
                  Vec3(pixels->rgb[3], pixels->rgb[4], pixels->rgb[5]),
              Vec3(1, 0, 1));
    material = materialOf(two + R"(MakeNamedMaterial "metal" "string type" "conductor"
Material "mix" "string materials" ["red" "metal"] "float amount" 0.6)");
    EXPECT_EQ(material.kind, MaterialKind::Conductor);
    EXPECT_THAT(warnings, Contains(HasSubstr("of mixed materials the one that weighs more")));
    EXPECT_TRUE(
        load("Material \"interface\" Shape \"sphere\" Material \"\" Shape \"sphere\"").objects.empty());
    EXPECT_THAT(errorOf("NamedMaterial \"green\" Shape \"sphere\""),
                HasSubstr("bad.pbrt:3:1: there is no material \"green\""));
    EXPECT_THAT(
        errorOf(
            R"(MakeNamedMaterial "a" "string type" "mix" "string materials" ["a" "a"] NamedMaterial "a" Shape "sphere")"),
        HasSubstr("in a circle"));
}

TEST_F(PbrtMaterialsTest, FurtherModelsAreApproximatedAndSaid) {
    for (const char* kind : {"measured", "hair", "subsurface", "plastic", "uber"}) {
        materialOf("Material \"" + std::string(kind) + "\"");
        EXPECT_THAT(warnings, Contains(HasSubstr("approximated: "))) << kind;
    }
    const Vec3 hair = materialOf("Material \"hair\" \"float eumelanin\" 1.3").color.value;
    EXPECT_TRUE(hair.x > hair.y && hair.y > hair.z && hair.z > 0.0f);
    EXPECT_EQ(materialOf("Material \"hair\" \"rgb color\" [0.1 0.2 0.3]").color.value,
              Vec3(0.1f, 0.2f, 0.3f));
    const Material skin = materialOf("Material \"subsurface\" \"rgb reflectance\" [0.9 0.5 0.3]");
    EXPECT_EQ(skin.kind, MaterialKind::Plastic);
    EXPECT_EQ(skin.color.value, Vec3(0.9f, 0.5f, 0.3f));
    EXPECT_FLOAT_EQ(skin.ior.value, 1.33f);
    EXPECT_EQ(materialOf("Material \"matte\" \"rgb Kd\" [0.1 0.2 0.3]").color.value, Vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(materialOf("Material \"mirror\"").kind, MaterialKind::Mirror);
    const Material disney = materialOf(
        "Material \"disney\" \"float metallic\" 0.5 \"float roughness\" 0.5 \"float clearcoat\" 1");
    EXPECT_EQ(disney.kind, MaterialKind::Principled);
    EXPECT_EQ(disney.metallic.value, 0.5f);
    EXPECT_FLOAT_EQ(disney.roughness.value, 0.25f);
    EXPECT_EQ(disney.clearcoat.value, 0.25f);
    EXPECT_EQ(materialOf("Material \"glass\" \"float index\" 1.7").ior.value, 1.7f);
    EXPECT_THAT(errorOf("Material \"velvet\" Shape \"sphere\""), HasSubstr("no material \"velvet\""));
}

}  // namespace
}  // namespace glint::test
