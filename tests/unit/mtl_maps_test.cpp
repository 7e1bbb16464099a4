// Maps of MTL files mean what exporters write them for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "tests/support/obj_square.h"

namespace glint {
namespace {

using test::loadSquare;
using test::materialOf;
using test::TempFolder;
using testing::HasSubstr;
using testing::IsEmpty;

/// One red pixel with an alpha of 0.
constexpr char kClearPng[] =
    // clang-format off
        "\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\000\001"
        "\000\000\000\001\010\006\000\000\000\037\025\304\211\000\000\000\015\111\104\101"
        "\124\170\234\143\370\317\300\300\000\000\004\001\001\000\107\006\312\336\000\000"
        "\000\000\111\105\116\104\256\102\140\202";
// clang-format on

TEST(MtlMaps, EmissionAndTransparency) {
    const TempFolder folder;
    folder.write("clear.png", std::string_view(kClearPng, sizeof kClearPng - 1));
    std::vector<std::string> said;
    for (const char* alphaMap : {"", "map_d clear.png\n", "map_d -imfchan m clear.png\nd 0.2\n"}) {
        const Material cut =
            materialOf(folder, std::string("newmtl it\nmap_Kd clear.png\n") + alphaMap, &said);
        EXPECT_TRUE(cut.alphaCutsOut) << alphaMap;
        EXPECT_EQ(cut.opacity, NumberInput{1.0f}) << "the image's own alpha is enough " << alphaMap;
    }
    EXPECT_THAT(said, IsEmpty());
    ASSERT_TRUE(savePng(folder.path("spots.png"), {1, 1, {255, 0, 0}}));
    for (const auto& [ke, strength] :
         {std::pair("Ke 2 2 2\n", 2.0f), std::pair("Ke 0 0 0\n", 1.0f), std::pair("", 1.0f)}) {
        std::vector<std::string> warnings;
        const Material material =
            materialOf(folder, std::string("newmtl it\nKd 0 0 0\nmap_Ke spots.png\n") + ke, &warnings);
        EXPECT_EQ(material.emission.texture, 0);
        EXPECT_EQ(material.emissionStrength, strength);
        EXPECT_THAT(warnings, IsEmpty());
    }
    std::vector<std::string> warnings;
    EXPECT_EQ(materialOf(folder, "newmtl it\nKe 2 1 0\nmap_Ke spots.png\n", &warnings).emissionStrength,
              2.0f);
    EXPECT_THAT(warnings,
                testing::ElementsAre(HasSubstr("m.mtl:3: emission maps lose the colour of Ke: \"it\"")));
}

TEST(MtlMaps, OfMetalnessMakePrincipledMaterials) {
    const TempFolder folder;
    ASSERT_TRUE(savePng(folder.path("m.png"), {1, 1, {0, 0, 0}}));
    for (const char* metal :
         {"map_Pm m.png\n", "Pm 1\nmap_Pm m.png\n", "map_pm -imfchan b m.png\nPr 0.5\n"}) {
        std::vector<std::string> warnings;
        const Material it = materialOf(folder, std::string("newmtl it\nKd 0.8 0.1 0.1\n") + metal, &warnings);
        EXPECT_EQ(it.kind, MaterialKind::Principled) << metal;
        EXPECT_EQ(it.metallic.texture, 0) << metal;
        EXPECT_EQ(it.color.value, Vec3(0.8f, 0.1f, 0.1f)) << metal;
    }
    std::vector<std::string> warnings;
    const Material it =
        materialOf(folder, "newmtl it\nKd 0.8 0.1 0.1\nPm 0.25\nmap_Pm none.png\n", &warnings);
    EXPECT_EQ(it.metallic.texture, -1);
    EXPECT_EQ(it.metallic.value, 0.25f);
    EXPECT_THAT(warnings, testing::ElementsAre(HasSubstr("m.mtl:4: images are missing")));
}

TEST(MtlMaps, OfBumpsNormalsOpacityAndRoughness) {
    const TempFolder folder;
    for (const char* name : {"h.png", "n.png", "o.png", "r.png"}) {
        ASSERT_TRUE(savePng(folder.path(name), {1, 1, {128, 128, 255}}));
    }
    for (const char* bump :
         {"map_Bump -bm 2 h.png\n", "bump h.png -bm 2\n", "map_bump -bm 2 -imfchan l h.png\n"}) {
        folder.write("m.mtl", std::string("newmtl it\nKd 0.5 0.5 0.5\nPr 0.5\nnorm -bm 0.5 n.png\n") + bump +
                                  "map_d -o 0.25 -clamp on -imfchan g o.png\nmap_Pr -mm 0.1 0.8 r.png\n");
        // Two metres a width of the image, by the texture coordinates and -s.
        const auto scene = loadSquare(folder.write(
            "in.obj",
            "mtllib m.mtl\nusemtl it\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
            "f 1/1 2/2 3/3 4/4\n"));
        ASSERT_TRUE(scene) << bump;
        EXPECT_THAT(scene->warnings, IsEmpty()) << bump;
        const Material& it = scene->materials[0];
        const auto texture = [&](int index) -> const Texture& {
            return scene->textures.at(static_cast<size_t>(index));
        };
        EXPECT_EQ(texture(it.bump.texture).name, "h.png");
        EXPECT_EQ(texture(it.bump.texture).channel, TextureChannel::Luminance);
        EXPECT_NEAR(it.bumpHeight, 2.0f * 0.02f * 2.0f, 1e-6f) << bump;
        EXPECT_EQ(texture(it.normalMap.texture).name, "n.png");
        EXPECT_FLOAT_EQ(it.normalStrength, 0.5f);
        EXPECT_EQ(it.kind, MaterialKind::Plastic);
        const Texture& cut = texture(it.opacity.texture);
        EXPECT_EQ(cut.name, "o.png");
        EXPECT_EQ(cut.offset, Vec2(0.25f, 0.0f));
        EXPECT_EQ(cut.wrapU, WrapMode::Clamp);
        EXPECT_EQ(cut.channel, TextureChannel::Green);
        const Texture& rough = texture(it.roughness.texture);
        EXPECT_EQ(rough.name, "r.png");
        EXPECT_FLOAT_EQ(rough.base, 0.1f);
        EXPECT_FLOAT_EQ(rough.gain, 0.8f);
        EXPECT_FLOAT_EQ(rough.exponent, 2.0f) << "GGX alpha is the square";
    }
    std::vector<std::string> warnings;
    EXPECT_EQ(materialOf(folder, "newmtl it\nKd 1 1 1\nd 0.8\n", &warnings).opacity.value, 0.8f);
    EXPECT_EQ(materialOf(folder, "newmtl it\nKd 1 1 1\nd 1\n", &warnings).opacity.value, 1.0f);
    EXPECT_THAT(warnings, IsEmpty());
    materialOf(folder, "newmtl it\nKd 1 1 1\nmap_Bump none.png\nmap_Ks h.png\nmap_Kd -t 1 1 1 h.png\n",
               &warnings);
    EXPECT_THAT(warnings,
                testing::UnorderedElementsAre(HasSubstr("images are missing"), HasSubstr("does not draw"),
                                              HasSubstr("does not know")));
}

}  // namespace
}  // namespace glint
