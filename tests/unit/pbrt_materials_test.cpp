// pbrt's materials, textures and colours as Glint's.
#include <cmath>

#include "engine/io/image_io.h"
#include "engine/io/pbrt_color.h"
#include "engine/math/color.h"
#include "engine/scene/metals.h"
#include "tests/support/pbrt_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class PbrtMaterialsTest : public PbrtTest {
  protected:
    Vec3 reflectance(const std::string& value) {
        return materialOf("Material \"diffuse\" " + value).color.value;
    }
    /// The texture that `definition` calls "t", on a diffuse surface.
    Texture textureOf(const std::string& definition) {
        const Material material =
            materialOf(definition + " Material \"diffuse\" \"texture reflectance\" \"t\"");
        EXPECT_GE(material.color.texture, 0);
        return material.color.texture < 0 ? Texture() : textures[static_cast<size_t>(material.color.texture)];
    }
    void writeImage(const char* name) {
        ASSERT_TRUE(savePng(folder.path(name), {2, 1, {255, 255, 255, 0, 0, 0}}));
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
    EXPECT_NEAR(metal.roughness.value, 0.2f, 1e-6f);
    EXPECT_THAT(warnings, Contains(HasSubstr("roughness along u and v is one")));
    // At right angles, a metal of eta 1 reflects k^2 / (4 + k^2).
    metal = materialOf("Material \"conductor\" \"rgb reflectance\" [0.5 0.2 0.8]");
    const Vec3 k2 = metal.k.value * metal.k.value;
    expectNear(k2 / (Vec3(4.0f) + k2), Vec3(0.5f, 0.2f, 0.8f), 1e-5f);
    EXPECT_EQ(metal.eta.value, Vec3(1.0f));
    metal = materialOf(
        R"(Material "coatedconductor" "spectrum conductor.eta" "metal-Al-eta" "spectrum conductor.k" "metal-Al-k"
"float conductor.roughness" 0.04 "float interface.roughness" 0.1)");
    EXPECT_EQ(metal.metal, "aluminium");
    EXPECT_NEAR(metal.roughness.value, 0.2f, 1e-6f);
    EXPECT_THAT(warnings, Contains(HasSubstr("coats over metals")));
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
    for (const char* kind : {"diffusetransmission", "measured", "hair", "subsurface", "plastic", "uber"}) {
        materialOf("Material \"" + std::string(kind) + "\"");
        EXPECT_THAT(warnings, Contains(HasSubstr("approximated: "))) << kind;
    }
    EXPECT_EQ(
        materialOf(
            "Material \"diffusetransmission\" \"rgb reflectance\" [0.2 0.2 0.2] \"rgb transmittance\" [0.3 0 "
            "0.9]")
            .color.value,
        Vec3(0.5f, 0.2f, 1.0f));
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
    EXPECT_EQ(materialOf("Material \"glass\" \"float index\" 1.7").ior.value, 1.7f);
    EXPECT_THAT(errorOf("Material \"velvet\" Shape \"sphere\""), HasSubstr("no material \"velvet\""));
}

TEST_F(PbrtMaterialsTest, ImagesArePlacedAndScaled) {
    writeImage("a.png");
    Texture texture = textureOf(
        R"(Texture "t" "spectrum" "imagemap" "string filename" "a.png" "float uscale" 2 "float vscale" 3
"float udelta" 0.25 "float vdelta" 0.5 "string wrap" "clamp" "float scale" 0.5)");
    EXPECT_EQ(pathOf(texture.image.source), "a.png");
    EXPECT_EQ(texture.scale, Vec2(2, 3));
    EXPECT_EQ(texture.offset, Vec2(0.25f, 0.5f));
    EXPECT_EQ(texture.wrapU, WrapMode::Clamp);
    EXPECT_EQ(texture.encoding, ColorEncoding::Srgb);
    EXPECT_FLOAT_EQ(texture.gain, 0.5f);
    EXPECT_FALSE(texture.flipV);
    EXPECT_EQ(texture.name, "t");
    texture = textureOf(
        R"(Texture "t" "spectrum" "imagemap" "string filename" "a.png" "bool invert" true "string encoding" "linear"
"string wrap" "black")");
    EXPECT_EQ(texture.base, 1.0f);
    EXPECT_EQ(texture.gain, -1.0f);
    EXPECT_EQ(texture.encoding, ColorEncoding::Linear);
    EXPECT_THAT(warnings, Contains(HasSubstr("clamped beyond their edges")));
    texture = textureOf(
        R"(Texture "t" "spectrum" "imagemap" "string filename" "a.png" "string encoding" "gamma 2" "float scale" 4)");
    EXPECT_EQ(texture.exponent, 2.0f);
    EXPECT_NEAR(texture.gain, 2.0f, 1e-6f);
    textureOf(R"(Texture "t" "spectrum" "imagemap" "string filename" "a.png" "string mapping" "spherical")");
    EXPECT_THAT(warnings, Contains(HasSubstr("placed by their meshes' u and v")));
    materialOf(
        R"(Texture "t" "spectrum" "imagemap" "string filename" "none.png" Material "diffuse" "texture reflectance" "t")");
    EXPECT_THAT(warnings, Contains(HasSubstr("images cannot be read")));
}

TEST_F(PbrtMaterialsTest, TexturesAreComputed) {
    writeImage("a.png");
    const std::string image = R"(Texture "i" "spectrum" "imagemap" "string filename" "a.png" )";
    EXPECT_EQ(
        materialOf(
            R"(Texture "t" "spectrum" "constant" "rgb value" [0.1 0.2 0.3] Material "diffuse" "texture reflectance" "t")")
            .color.value,
        Vec3(0.1f, 0.2f, 0.3f));
    EXPECT_FLOAT_EQ(
        textureOf(image + R"(Texture "t" "spectrum" "scale" "texture tex" "i" "float scale" 0.25)").gain,
        0.25f);
    const auto texelsOf = [this](const std::string& definition) {
        const Texture texture = textureOf(definition);
        return texture.image.floats ? texture.image.floats->rgb : std::vector<float>();
    };
    EXPECT_EQ(
        texelsOf(
            image +
            R"(Texture "t" "spectrum" "mix" "rgb tex1" [0 0.5 0] "texture tex2" "i" "float amount" 0.5)"),
        (std::vector<float>{0.5f, 0.75f, 0.5f, 0, 0.25f, 0}));
    EXPECT_EQ(texelsOf(image + R"(Texture "c" "spectrum" "constant" "rgb value" [0.5 1 0.25]
Texture "t" "spectrum" "scale" "texture tex1" "i" "texture tex2" "c")"),
              (std::vector<float>{0.5f, 1, 0.25f, 0, 0, 0}));
    const Texture board =
        textureOf(R"(Texture "t" "spectrum" "checkerboard" "rgb tex1" [0.1 0.2 0.3] "rgb tex2" [1 1 0]
"float uscale" 8 "float vscale" 4)");
    const auto* squares = std::get_if<Checkerboard>(&board.image.source);
    ASSERT_NE(squares, nullptr);
    EXPECT_EQ(squares->even, Vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(squares->odd, Vec3(1, 1, 0));
    EXPECT_EQ(board.scale, Vec2(4, 2));
    for (const char* kind : {"fbm", "marble", "wrinkled", "windy", "dots", "bilerp", "ptex"}) {
        materialOf("Texture \"t\" \"spectrum\" \"" + std::string(kind) +
                   "\" Material \"diffuse\" \"texture reflectance\" \"t\"");
        EXPECT_THAT(warnings, Contains(HasSubstr("approximated: "))) << kind;
    }
    EXPECT_THAT(errorOf("Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"sphere\""),
                HasSubstr("there is no texture \"t\""));
    EXPECT_THAT(
        errorOf(
            R"(Texture "t" "spectrum" "scale" "texture tex" "t" Material "diffuse" "texture reflectance" "t" Shape "sphere")"),
        HasSubstr("in a circle"));
}

/// Numbers are the mean of a picture's linear channels, or its alpha.
TEST_F(PbrtMaterialsTest, NumbersComeFromImages) {
    ASSERT_TRUE(savePng(folder.path("grey.png"), {1, 1, {188, 188, 188}}));
    // A TGA of two pixels, blue, green, red and alpha each.
    folder.write("cut.tga", std::string("\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\x20\x28", 18) +
                                std::string("\x9\x9\x9\xff\x9\x9\x9\0", 8));
    Material material = materialOf(R"(Texture "t" "float" "imagemap" "string filename" "grey.png"
Material "dielectric" "texture roughness" "t")");
    ASSERT_GE(material.roughness.texture, 0);
    const Texture rough = textures[static_cast<size_t>(material.roughness.texture)];
    ASSERT_TRUE(rough.image.floats);
    EXPECT_NEAR(rough.image.floats->rgb[0], 0.5029f, 1e-3f);
    EXPECT_EQ(rough.exponent, 0.5f);
    const SceneDescription scene = load(R"(Texture "t" "float" "imagemap" "string filename" "cut.tga"
Shape "sphere" "texture alpha" "t")");
    ASSERT_EQ(scene.materials.at(0).opacity.texture, 0);
    EXPECT_EQ(scene.textures[0].channel, TextureChannel::Alpha);
}

TEST_F(PbrtMaterialsTest, Reliefs) {
    writeImage("a.png");
    const Material bumps =
        materialOf(R"(Texture "h" "float" "imagemap" "string filename" "a.png" "string encoding" "linear"
"float scale" 0.02 Material "diffuse" "texture displacement" "h")");
    ASSERT_GE(bumps.bump.texture, 0);
    EXPECT_FLOAT_EQ(textures[static_cast<size_t>(bumps.bump.texture)].gain, 0.02f);
    EXPECT_EQ(bumps.bumpHeight, 1.0f);
    const Material normals = materialOf("Material \"diffuse\" \"string normalmap\" \"a.png\"");
    ASSERT_GE(normals.normalMap.texture, 0);
    EXPECT_EQ(textures[static_cast<size_t>(normals.normalMap.texture)].encoding, ColorEncoding::Linear);
    EXPECT_THAT(warnings, Contains(HasSubstr("shading ends as Glint has it")));
}

}  // namespace
}  // namespace glint::test
