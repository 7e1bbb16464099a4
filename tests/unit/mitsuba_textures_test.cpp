// Mitsuba's textures as Glint's.
#include <gmock/gmock.h>

#include "engine/io/image_io.h"
#include "tests/support/mitsuba_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// A picture of 2 x 2 pixels: black, red / green, blue.
class MitsubaTexturesTest : public MitsubaTest {
  protected:
    void SetUp() override {
        ASSERT_TRUE(
            savePng(folder.path("four.png"), Image8{2, 2, {0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255}}));
    }
    static std::string bitmap(const std::string& content, const std::string& name = "reflectance") {
        return "<texture type='bitmap' name='" + name + "'><string name='filename' value='four.png'/>" +
               content + "</texture>";
    }
    /// On a rectangle, whose texture coordinates are Mitsuba's.
    SceneDescription textured(const std::string& texture) {
        return load("<shape type='rectangle'><bsdf type='twosided'><bsdf type='diffuse'>" + texture +
                    "</bsdf></bsdf></shape>");
    }
};

TEST_F(MitsubaTexturesTest, ArePlacedAsTheirTransformSays) {
    const Texture plain = textured(bitmap("")).textures.at(0);
    EXPECT_TRUE(plain.flipV);
    EXPECT_EQ(plain.scale, Vec2(1.0f));
    EXPECT_EQ(plain.encoding, ColorEncoding::Srgb);
    const Texture placed =
        textured(bitmap("<transform name='to_uv'><scale x='2' y='3'/><rotate z='1' angle='90'/>"
                        "<translate x='5'/></transform><boolean name='raw' value='true'/>"
                        "<string name='wrap_mode' value='mirror'/><string "
                        "name='filter_type' value='nearest'/>"))
            .textures.at(0);
    EXPECT_NEAR(placed.scale.x, 2.0f, 1e-6f);
    EXPECT_NEAR(placed.scale.y, 3.0f, 1e-6f);
    EXPECT_NEAR(placed.rotationDeg, 90.0f, 1e-4f);
    EXPECT_EQ(placed.offset, Vec2(5, 0));
    EXPECT_EQ(placed.wrapU, WrapMode::Mirror);
    EXPECT_EQ(placed.filter, TexelFilter::Nearest);
    EXPECT_EQ(placed.encoding, ColorEncoding::Linear);
    const Texture old =
        textured(bitmap("<float name='uscale' value='4'/><float name='voffset' value='1'/>")).textures.at(0);
    EXPECT_EQ(old.scale, Vec2(4, 1));
    EXPECT_EQ(old.offset, Vec2(0, 1));
}

TEST_F(MitsubaTexturesTest, ObjFilesCountVFromTheBottom) {
    folder.write("square.obj", kSquareObj);
    const auto texture = [this](const std::string& content) {
        return load("<shape type='obj'><string name='filename' value='square.obj'/><bsdf type='diffuse'>" +
                    bitmap(content) + "</bsdf></shape>")
            .textures.at(0);
    };
    EXPECT_FALSE(texture("").flipV);
    const Texture moved = texture("<transform name='to_uv'><scale y='2'/><translate y='0.25'/></transform>");
    EXPECT_TRUE(moved.flipV);  // row = 2 (1 - v) + 0.25
    EXPECT_EQ(moved.scale, Vec2(1, -2));
    EXPECT_EQ(moved.offset, Vec2(0, 2.25f));
}

TEST_F(MitsubaTexturesTest, NumbersAreTheLuminanceOfLinearValues) {
    const SceneDescription scene = load("<shape type='sphere'><bsdf type='mask'>" + bitmap("", "opacity") +
                                        "<bsdf type='diffuse'/></bsdf></shape>");
    const Material& material = scene.materials.at(0);
    ASSERT_GE(material.opacity.texture, 0);
    const SceneImage& image = scene.textures[static_cast<size_t>(material.opacity.texture)].image;
    ASSERT_TRUE(image.floats);
    EXPECT_NEAR(image.floats->rgb[3], 0.2126f, 1e-3f);
    EXPECT_NEAR(image.floats->rgb[6], 0.7152f, 1e-3f);
}

TEST_F(MitsubaTexturesTest, CheckerboardsAndUnknownOnes) {
    const SceneDescription scene = textured(
        "<texture type='checkerboard' name='reflectance'><rgb name='color0' value='1 0 0'/></texture>");
    const auto& board = std::get<Checkerboard>(scene.textures.at(0).image.source);
    EXPECT_EQ(board.even, Vec3(1, 0, 0));
    EXPECT_EQ(board.odd, Vec3(0.2f));
    EXPECT_EQ(scene.textures[0].filter, TexelFilter::Nearest);
    EXPECT_THAT(textured("<texture type='wavy' name='reflectance'/>").warnings,
                Contains(HasSubstr("approximated: textures of a kind")));
}

}  // namespace
}  // namespace glint::test
