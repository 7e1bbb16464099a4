// pbrt's textures as Glint's: images, what is computed of them, numbers, bumps and normal maps.
#include <numeric>

#include "engine/io/image_io.h"
#include "tests/support/pbrt_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

class PbrtTexturesTest : public PbrtTest {
  protected:
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

TEST_F(PbrtTexturesTest, ImagesArePlacedAndScaled) {
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

TEST_F(PbrtTexturesTest, TexturesAreComputed) {
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
    for (const char* kind : {"fbm", "marble", "wrinkled", "windy", "dots", "ptex"}) {
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

/// Linear between the corners; u and v from 0 to 1 run from the middles of texels to those of the next.
TEST_F(PbrtTexturesTest, FourCornersAreAPicture) {
    const Texture corners = textureOf(R"(Texture "t" "spectrum" "bilerp" "rgb v00" [1 0 0] "rgb v01" [0 1 0]
"rgb v10" [0 0 1] "rgb v11" [1 1 1] "float uscale" 2 "float vdelta" 0.5)");
    ASSERT_TRUE(corners.image.floats);
    EXPECT_EQ(corners.image.floats->rgb, (std::vector<float>{0, 1, 0, 1, 1, 1, 1, 0, 0, 0, 0, 1}));
    EXPECT_EQ(corners.scale, Vec2(1.0f, 0.5f));
    EXPECT_EQ(corners.offset, Vec2(0.25f, 0.5f));
    EXPECT_EQ(corners.wrapU, WrapMode::Clamp);
    EXPECT_EQ(corners.filter, TexelFilter::Bilinear);
    EXPECT_THAT(warnings, testing::IsEmpty());
}

/// Half of the cells have a disc of radius 0.35: 0.1924 of all; of 256 cells, within four deviations of
/// 0.5 sqrt(256).
TEST_F(PbrtTexturesTest, DotsAreAPicture) {
    const Texture dots = textureOf(
        R"(Texture "t" "spectrum" "dots" "rgb inside" [1 1 1] "rgb outside" [0 0 0] "float uscale" 8)");
    ASSERT_TRUE(dots.image.floats);
    const std::vector<float>& rgb = dots.image.floats->rgb;
    const double share = std::accumulate(rgb.begin(), rgb.end(), 0.0) / static_cast<double>(rgb.size());
    EXPECT_NEAR(share, 0.1924, 0.1924 * 4.0 * 8.0 / 128.0);
    EXPECT_EQ(dots.scale, Vec2(0.5f, 1.0f / 16.0f));
}

/// By the means of noise: wrinkles of two octaves are 0.2 + 0.2 / 2.
TEST_F(PbrtTexturesTest, NoiseIsItsMean) {
    const auto alphaOf = [this](const std::string& definition) {
        return materialOf(
                   "Texture \"t\" \"float\" " + definition +
                   " Material \"dielectric\" \"bool remaproughness\" false \"texture roughness\" \"t\"")
            .roughness.value;
    };
    EXPECT_FLOAT_EQ(alphaOf(R"("wrinkled" "integer octaves" 2 "float roughness" 0.5)"), 0.3f);
    EXPECT_FLOAT_EQ(alphaOf(R"("fbm" "integer octaves" 2)"), 0.0f);
    EXPECT_THAT(warnings, Contains(HasSubstr("noise in space are their mean")));
}

/// Numbers are the mean of a picture's linear channels, or its alpha.
TEST_F(PbrtTexturesTest, NumbersComeFromImages) {
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
    writeImage("mask.png");  // of 0 and 1, which need no decoding
    material = materialOf(R"(Texture "t" "float" "imagemap" "string filename" "mask.png"
Material "dielectric" "texture roughness" "t")");
    EXPECT_EQ(pathOf(textures.at(static_cast<size_t>(material.roughness.texture)).image.source), "mask.png");
    const SceneDescription scene = load(R"(Texture "t" "float" "imagemap" "string filename" "cut.tga"
Shape "sphere" "texture alpha" "t")");
    ASSERT_EQ(scene.materials.at(0).opacity.texture, 0);
    EXPECT_EQ(scene.textures[0].channel, TextureChannel::Alpha);
}

TEST_F(PbrtTexturesTest, Reliefs) {
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
