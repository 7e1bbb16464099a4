// What is odd in OBJ files, but leaves no doubt of what is meant, is repaired with one warning for each kind;
// --strict refuses it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scene_loader.h"
#include "tests/support/obj_square.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::kCorners;
using test::kUvs;
using test::loadSquare;
using test::TempFolder;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct Repaired {
    std::string text;
    std::string warning;  ///< part of the one that is given
};

void expectRepaired(const std::vector<Repaired>& cases) {
    const TempFolder folder;
    for (const Repaired& odd : cases) {
        SCOPED_TRACE(odd.text);
        const std::string path = folder.write("in.obj", odd.text);
        const auto scene = loadSquare(path);
        if (!scene) { continue; }
        EXPECT_THAT(scene->warnings, testing::ElementsAre(HasSubstr(odd.warning)));
        const auto strict = loadScene(path, {.strict = true});
        ASSERT_FALSE(strict);
        EXPECT_THAT(strict.error().format(), HasSubstr(odd.warning));
        EXPECT_THAT(strict.error().format(), HasSubstr("--strict"));
    }
}

TEST(ObjRepairs, Faces) {
    const std::string face = "f 1 2 3 4\n";
    expectRepaired({
        {kCorners + kUvs + "f 1/ 2/ 3/ 4/\n",
         "in.obj:9: no index behind a slash: as if the slash were missing (and 3 more)"},
        {kCorners + kUvs + "f 1/1/ 2/2/ 3/3/ 4/4/\n", ":9: no index behind a slash"},
        {kCorners + "f 1// 2// 3// 4//\n", ":5: no index behind a slash"},
        {kCorners + "f 1//1 2//2 3//3 4//4\n",
         ":5: normals that faces name are not there: \"1\" (and 3 more)"},
        {kCorners + "f 1/7 2/7 3/7 4/-1\n", ":5: texture coordinates that faces name are not there"},
        {kCorners + kUvs + "f 1/0 2/0 3/0 4/0\n", "texture coordinates that faces name are not there"},
        {kCorners + face + "f 1 2\nf\nf 3\n", ":6: faces of fewer than 3 corners are left out (and 2 more)"},
        {kCorners + "f 1.0 2.0 3.00 4\n", ":5: a whole number is written with a point"},
        {kCorners + "f 1 2 \\ \n3 4\n", ":5: blanks behind the backslash"},
        {kCorners + "f 1 2 \\\t \r\n3 4\n", ":5: blanks behind the backslash"},
        {kCorners + "F 1 2 3 4\n", ":5: a keyword in capitals"},
    });
}

TEST(ObjRepairs, Corners) {
    const std::string square = kCorners + kUvs + "vn 0 0 1\n";
    const std::string face = "f 1 2 3 4\n";
    for (const char* corners :
         {"f 1/1/1/ 2/2/1/ 3/3/1/ 4/4/1/", "f 1/1/1/1 2/2/1/1 3/3/1 4/4/1", "f 1/1/1//9 2/2/1 3/3/1 4/4/1"}) {
        expectRepaired({{square + corners + "\n", ":10: what stands behind a corner's third slash"}});
    }
    for (const char* corners : {"f 1. 2. 3. 4.", "f 1e0 2e0 3.0e0 4", "f +1 +2 +3 +4", "f -4.0 -3 -2 -1",
                                "f 1/1.0/1 2/2/+1 3/3/1 4/4/1e0"}) {
        expectRepaired({{square + corners + "\n", ":10: a whole number is written with a point or a sign"}});
    }
    for (const char* corners : {"f 1/nan/1 2/2/1 3/3/1 4/4/1", "f 1/-/1 2/-/1 3/-/1 4/-/1",
                                "f 1/x 2/x 3/x 4/x", "f 1//none 2//1 3//1 4//1"}) {
        expectRepaired({{square + corners + "\n", ":10: texture coordinates and normals of corners"}});
    }
    for (const char* odd : {"f 1 2 x 4", "f a b c", "f 1/1 2/2y 3/3", "f 1 2 1.5 3"}) {
        expectRepaired(
            {{square + face + odd + "\n", ":11: faces with corners that are no numbers are left out"}});
    }
    expectRepaired({
        {kCorners + "f 1 2 3 4 abc\n", ":5: more on a line than it can have"},
        {kCorners + face + "f 99 98\n", ":6: faces of fewer than 3 corners are left out"},
        {kCorners + face + "f 0\n", ":6: faces of fewer than 3 corners are left out"},
    });
    const TempFolder folder;
    for (const std::string& text :
         {kCorners + "f 1 2 3 4#abc\n", "v 5 5 5#abc\n" + kCorners + "f -4 -3 -2 -1\n",
          kCorners + "f 1 2 3 4\\", kCorners + face + "\x1a", kCorners + face + std::string("\0\0\r\n\0", 5),
          "\xef\xbb\xbf\xef\xbb\xbf" + kCorners + face}) {
        const auto scene = loadSquare(folder.write("in.obj", text));
        ASSERT_TRUE(scene) << text;
        EXPECT_THAT(scene->warnings, IsEmpty()) << text;
    }
}

TEST(ObjRepairs, VerticesThatNoFaceUsesNeedNoPosition) {
    const std::string kind = "vertices without a finite position, which no face uses, are left out";
    const std::string face = "f 1 2 3 4\n";
    expectRepaired({
        {kCorners + "v 0 0 -1.#IND\n" + face, ":5: " + kind},
        {kCorners + "v 0 0 1e30\nv nan nan nan\n" + face, ":5: " + kind + " (and 1 more)"},
        {kCorners + "v 0 0\n" + face, ":5: " + kind},
        {"v inf 0 0\n" + kCorners + "f 2 3 4 5\n", ":1: " + kind},
    });
}

TEST(ObjRepairs, Attributes) {
    const std::string face = "f 1/1/1 2/2/1 3/3/1 4/4/1\n";
    expectRepaired({
        {kCorners + kUvs + "vn 0 0 1 0\n" + face, ":9: more on a line than it can have is left out"},
        {kCorners + kUvs + "vn 0 0\n" + face, ":9: normals without a direction count as missing"},
        {kCorners + kUvs + "vn 0 0 0\n" + face, ":9: normals without a direction count as missing"},
        {kCorners + "vt 0 nan\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n" + face,
         ":5: a number that is not finite counts as 0"},
        {kCorners + "vt\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n" + face,
         ":5: texture coordinates without numbers"},
        {kCorners + "vt 0 0 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n" + face, ":5: more on a line"},
        {"v -1 -1 0 7 8\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n", ":1: the numbers behind x y z"},
        {"v -1 -1 0 1 0 0 1\nv 1 -1 0 1 0 0 1\nv 1 1 0 1 0 0 1\nv -1 1 0 1 0 0 1\nf 1 2 3 4\n",
         ":1: vertex colours have an alpha"},
        {"V -1 -1 0\nV 1 -1 0\nV 1 1 0\nV -1 1 0\nf 1 2 3 4\n", ":1: a keyword in capitals"},
    });
}

TEST(ObjRepairs, Lines) {
    std::string returns = kCorners + "f 1 2 3 4\n";
    std::ranges::replace(returns, '\n', '\r');
    std::string wide("\xff\xfe", 2), wideBackwards("\xfe\xff", 2), wideWithoutMark;
    for (const char c : kCorners + "f 1 2 3 4\n") {
        wide += {c, '\0'};
        wideBackwards += {'\0', c};
        wideWithoutMark += {c, '\0'};
    }
    expectRepaired({
        {returns, "lines that end in a carriage return alone"},
        {wide, "the file is UTF-16"},
        {wideBackwards, "the file is UTF-16"},
        {wideWithoutMark, "the file is UTF-16"},
        {wide + "\n", "the file is UTF-16"},
        {"Created by C:\\programs\\\n" + kCorners + "f 1 2 3 4\n", ":1: lines that are no statement"},
        {"; a comment of another kind\n// and another\n" + kCorners + "f 1 2 3 4\n", "(and 1 more)"},
        {kCorners + "f 1 2 3 4\n*** end ***\n", ":6: lines that are no statement"},
        {"mtllib\n" + kCorners + "f 1 2 3 4\n", ":1: mtllib without a file name"},
    });
}

TEST(ObjRepairs, FacesMayComeBeforeTheirVertices) {
    const TempFolder folder;
    for (const std::string& text :
         {"f 1 2 3 4\n" + kCorners, "f 1/1 2/2 3/3 4/4\n" + kCorners + kUvs,
          std::string("v -1 -1 0\nv 1 -1 0\nf 1 2 -1\nf 1 2 3 4\nv 1 1 0\nv -1 1 0\n")}) {
        const auto scene = loadSquare(folder.write("in.obj", text));
        ASSERT_TRUE(scene) << text;
        EXPECT_THAT(scene->warnings, IsEmpty());
    }
    const auto missing = loadScene(folder.write("in.obj", "f 1 2 5\n" + kCorners));
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().format(), HasSubstr(":1:7: there is no vertex 5; 4 are defined"));
}

TEST(ObjRepairs, WarningsAreBounded) {
    const TempFolder folder;
    std::string obj = "mtllib m.mtl\n" + kCorners, mtl;
    for (int i = 0; i < 2000; ++i) {
        const std::string n = std::to_string(i);
        obj += "odd" + n + " 1\nusemtl m" + n + "\nf 1 2 3 4\nf 1 2\n";
        mtl += "newmtl a" + n + "\nmap_Kd no" + n + ".png\nmap_refl x\nwhat" + n + "\n";
    }
    folder.write("m.mtl", mtl);
    const auto scene = loadScene(folder.write("in.obj", obj));
    ASSERT_TRUE(scene) << scene.error().format();
    EXPECT_THAT(scene->warnings, SizeIs(testing::Le(6u)));
    EXPECT_THAT(scene->warnings, Contains(HasSubstr("(and 1999 more)")));
}

}  // namespace
}  // namespace glint
