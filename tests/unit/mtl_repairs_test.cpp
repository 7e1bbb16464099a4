// What is odd in MTL files, but leaves no doubt of what is meant, is repaired with one warning for each kind;
// --strict refuses it.
#include <filesystem>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "engine/io/scene_loader.h"
#include "tests/support/obj_square.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::kCorners;
using test::kUvs;
using test::loadSquare;
using test::materialOf;
using test::TempFolder;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(MtlRepairs, OddLinesGiveTheirColour) {
    const Vec3 red(0.8f, 0.1f, 0.1f);
    const std::string good = "newmtl it\nKd 0.8 0.1 0.1\n";
    std::string returns = good;
    std::ranges::replace(returns, '\n', '\r');
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"\xef\xbb\xbf" + good, ""},
        {"newmtl it\n# C:\\models\\\nKd 0.8 0.1 0.1\n", ""},
        {"newmtl it\r\nKd 0.8 \\\r\n 0.1 0.1\r\n", ""},
        {"newmtl it\nkd 0.8 0.1 0.1\n", "m.mtl:2: keywords in other case: \"kd\""},
        {"NEWMTL it\nKD 0.8 0.1 0.1\n", "keywords in other case"},
        {"newmtl\nKd 0 0 1\n" + good, ":1: newmtl without a name"},
        {good + "Ka spectral a.rfl\n", ""},
        {good + "Ks spectral a.rfl 1\n", ":3: colours that are no numbers are left out"},
        {good + "Ns much\n", ":3: values that are no number are left out"},
        {"Ns 5\n" + good, ":1: what stands before the first newmtl is left out"},
        {"newmtl it\nKd 0.8 0.1\n", ":2: colours of two numbers: blue is taken as green"},
        {"newmtl it\nKd 0.8 0.1 0.1 1\n", ":2: more on a line than it can have is left out"},
        {good + "Ks 0 0 nan\n", ":3: a number that is not finite counts as 0"},
        {good + good, ":3: materials are defined twice; the first counts: \"it\""},
        {good + "wibble 1\nwobble 2\n",
         ":3: lines that are no statement of MTL files are left out: \"wibble\" (and 1 more)"},
        {returns, "lines that end in a carriage return alone"},
    };
    const TempFolder folder;
    for (const auto& [text, warning] : cases) {
        SCOPED_TRACE(text);
        std::vector<std::string> warnings;
        const Material material = materialOf(folder, text, &warnings);
        EXPECT_EQ(material.kind, MaterialKind::Diffuse);
        EXPECT_EQ(material.color.value, red);
        if (warning.empty()) {
            EXPECT_THAT(warnings, IsEmpty());
        } else {
            EXPECT_THAT(warnings, testing::ElementsAre(HasSubstr(warning)));
        }
    }
    std::vector<std::string> warnings;
    EXPECT_EQ(materialOf(folder, "newmtl it\nKd 0.5\n", &warnings).color.value, Vec3(0.5f));
}

TEST(MtlRepairs, LibrariesAndMaterialsAreFoundByLikeNames) {
    const TempFolder folder;
    const std::string red = "newmtl Red\nKd 1 0 0\n";
    folder.write("my mats.mtl", red);
    folder.write("Other.MTL", red);
    for (const char* use :
         {"mtllib my\\ mats.mtl\nusemtl Red\n", "mtllib my mats.mtl\nusemtl Red\n",
          "mtllib \"my mats.mtl\"\nusemtl Red\n", "mtllib my%20mats.mtl\nusemtl Red\n",
          "mtllib other.mtl\nusemtl red\n", "mtllib C:\\work\\Other.MTL\nusemtl Red\n",
          "mtllib /home/somebody/Other.MTL\nusemtl Red\n", "mtllib none.mtl Other.MTL\nusemtl Red\n"}) {
        std::vector<std::string> warnings;
        EXPECT_EQ(materialOf(folder, "", &warnings, use).color.value, Vec3(1, 0, 0)) << use;
    }
}

TEST(MtlRepairs, ImagesAreFoundByLikeNamesAndKeepTheirScale) {
    const TempFolder folder;
    ASSERT_TRUE(savePng(folder.path("Wood 1.png"), {2, 1, {255, 0, 0, 0, 255, 0}}));
    for (const char* name :
         {"Wood 1.png", "C:\\work\\Wood 1.png", "/elsewhere/Wood 1.png", "wood 1.PNG", "\"Wood 1.png\"",
          "textures\\Wood 1.png", "Wood%201.png", "-s 1 Wood 1.png", "-s 1 1 -o 0 Wood 1.png",
          "Wood 1.png -s 1 1 1", "-bm 0.5 -mm 0 1 -clamp on -imfchan r -blendu off -t 0 0 Wood 1.png",
          "Wood 1.png # oak", "Wood 1.png  # oak", "Wood 1.png\t# oak", "-clamp Wood 1.png",
          "-imfchan Wood 1.png", "-CLAMP ON -S 1 1 1 Wood 1.png", "-foo 3 Wood 1.png"}) {
        folder.write("m.mtl", std::string("newmtl it\nKd 0.5 0.5 0.5\nmap_Kd ") + name + "\n");
        const auto scene = loadSquare(
            folder.write("in.obj", "mtllib m.mtl\nusemtl it\n" + kCorners + kUvs + "f 1/1 2/2 3/3 4/4\n"));
        ASSERT_TRUE(scene && scene->textures.size() == 1u) << name;
        EXPECT_TRUE(scene->textures[0].image.isRead()) << name;
        EXPECT_EQ(scene->materials[0].color.texture, 0) << name;
        EXPECT_EQ(scene->textures[0].scale, Vec2(1.0f)) << name;
    }
}

TEST(MtlRepairs, ImagesAreFoundBesideTheModelToo) {
    const TempFolder folder;
    for (const char* image : {"a.png", "tex/b.png", "lib/c.png"}) {
        std::filesystem::create_directories(std::filesystem::path(folder.path(image)).parent_path());
        ASSERT_TRUE(savePng(folder.path(image), {2, 1, {255, 0, 0, 0, 255, 0}}));
    }
    for (const char* name : {"a.png", "tex/b.png", "c.png", "B.PNG"}) {
        folder.write("lib/m.mtl", std::string("newmtl it\nmap_Kd ") + name + "\n");
        const auto scene = loadSquare(folder.write(
            "in.obj", "mtllib lib/m.mtl\nusemtl it\n" + kCorners + kUvs + "f 1/1 2/2 3/3 4/4\n"));
        ASSERT_TRUE(scene) << name;
        EXPECT_EQ(scene->textures.size(), std::string_view(name) == "B.PNG" ? 0u : 1u) << name;
    }
}

TEST(MtlRepairs, MissingImagesAreNamedWithTheirLine) {
    const TempFolder folder;
    std::vector<std::string> warnings;
    materialOf(folder, "newmtl it\nKd 1 1 1\nmap_Kd none.png\n", &warnings);
    EXPECT_THAT(warnings, testing::ElementsAre(HasSubstr("m.mtl:3: images are missing")));
    materialOf(folder, "newmtl it\nKd 1 1 1\nKs 0 0 0\nbump none.png\n", &warnings);
    EXPECT_THAT(warnings, testing::ElementsAre(HasSubstr("m.mtl:4: images are missing")));
}

/// A name with what looks like an option is a name; an option without its value takes none.
TEST(MtlRepairs, OptionsAreToldFromNames) {
    const TempFolder folder;
    ASSERT_TRUE(savePng(folder.path("a -s 2.png"), {2, 1, {255, 0, 0, 0, 255, 0}}));
    ASSERT_TRUE(savePng(folder.path("t.png"), {2, 1, {255, 0, 0, 0, 255, 0}}));
    const std::tuple<const char*, WrapMode, const char*> cases[] = {
        {"a -s 2.png", WrapMode::Repeat, ""},
        {"-clamp on t.png", WrapMode::Clamp, ""},
        {"-clamp off t.png", WrapMode::Repeat, ""},
        {"-clamp t.png", WrapMode::Clamp, "options of maps without a value are left out: \"-clamp\""},
        {"t.png -clamp on", WrapMode::Clamp, ""},
        {"-what 1 2 t.png", WrapMode::Repeat, "options of maps that Glint does not know are left out"},
    };
    for (const auto& [map, wrap, warning] : cases) {
        SCOPED_TRACE(map);
        folder.write("m.mtl", std::string("newmtl it\nmap_Kd ") + map + "\n");
        const auto scene = loadSquare(
            folder.write("in.obj", "mtllib m.mtl\nusemtl it\n" + kCorners + kUvs + "f 1/1 2/2 3/3 4/4\n"));
        ASSERT_TRUE(scene && scene->textures.size() == 1u);
        EXPECT_EQ(scene->textures[0].wrapU, wrap);
        if (*warning == '\0') {
            EXPECT_THAT(scene->warnings, IsEmpty());
        } else {
            EXPECT_THAT(scene->warnings, testing::ElementsAre(HasSubstr(warning)));
        }
    }
}

TEST(MtlRepairs, KindsOfWarningsAreCountedOverAllFiles) {
    const TempFolder folder;
    std::string use;
    for (int i = 0; i < 60; ++i) {
        const std::string name = std::to_string(i);
        folder.write(name + ".mtl", "newmtl m" + name + "\nKd 1 0\nwhat\n");
        use += "mtllib " + name + ".mtl\n";
    }
    std::vector<std::string> warnings;
    materialOf(folder, "", &warnings, use + "usemtl m0\n");
    EXPECT_THAT(warnings, testing::ElementsAre(HasSubstr("(and 59 more)"), HasSubstr("(and 59 more)")));
}

TEST(MtlRepairs, ImagesThatCannotBeReadShowTheColour) {
    const TempFolder folder;
    ASSERT_TRUE(savePng(folder.path("good.png"), {64, 64, std::vector<uint8_t>(3 * 64 * 64, 99)}));
    const std::string png = TempFolder::read(folder.path("good.png"));
    const std::pair<const char*, std::string> files[] = {
        {"empty.png", ""}, {"t.dds", "DDS |and more"}, {"cut.png", png.substr(0, png.size() / 2)}};
    for (const auto& [name, bytes] : files) {
        folder.write(name, bytes);
        std::vector<std::string> warnings;
        const Material material =
            materialOf(folder, std::string("newmtl it\nKd 0.8 0.1 0.1\nmap_Kd ") + name + "\n", &warnings);
        EXPECT_EQ(material.color.value, Vec3(0.8f, 0.1f, 0.1f));
        EXPECT_EQ(material.color.texture, -1);
        EXPECT_THAT(warnings,
                    testing::ElementsAre(testing::AllOf(HasSubstr(name), HasSubstr("cannot be read"))));
        const Material black =
            materialOf(folder, std::string("newmtl it\nKd 0 0 0\nmap_Kd ") + name + "\n", &warnings);
        EXPECT_EQ(black.color.value, Vec3(0.5f));
        // The same in a JSON scene that places the file.
        const auto json = loadScene(folder.write(
            "a.json", R"({"glint": 1, "objects": [{"type": "mesh", "mesh": {"file": "in.obj"}}]})"));
        EXPECT_TRUE(json) << json.error().format();
    }
}

}  // namespace
}  // namespace glint
