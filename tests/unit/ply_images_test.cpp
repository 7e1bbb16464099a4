// Colours and images of PLY files: of vertices, faces and corners, and what stands above what.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"
#include "tests/support/ply_texts.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using namespace test;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(PlyColors, OfFacesAndCorners) {
    const std::string face = kHead + "element face 2\n",
                      rgb = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    const std::string color = "property list uchar float color\n";
    for (const std::string& text :
         {face + kList + rgb + "end_header\n" + kCorners + "3 0 1 2 255 0 0\n3 0 2 3 0 255 0\n",
          face + rgb + kList + "end_header\n" + kCorners + "255 0 0 3 0 1 2\n0 255 0 3 0 2 3\n",
          face + withWord(rgb, "uchar", "float") + kList + "end_header\n" + kCorners +
              "1 0 0 3 0 1 2\n0 1 0 3 0 2 3\n",
          face + color + kList + "end_header\n" + kCorners + "3 1 0 0 3 0 1 2\n4 0 1 0 1 3 0 2 3\n",
          face + kList + color + "end_header\n" + kCorners +
              "3 0 1 2 9 1 0 0 1 0 0 1 0 0\n3 0 2 3 12 0 1 0 1 0 1 0 1 0 1 0 1\n"}) {
        const MeshFile file = parse(text);
        EXPECT_EQ(areaOf(file), Vec3(0, 0, 4)) << text;
        EXPECT_THAT(file.warnings, IsEmpty()) << text;
        const MeshData& mesh = *file.parts.at(0).mesh;
        ASSERT_EQ(mesh.colors.size(), mesh.positions.size()) << text;
        for (size_t i = 0; i < 6; ++i) {
            EXPECT_EQ(mesh.colors[mesh.indices[i]], i < 3 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)) << text << i;
        }
    }
    const MeshFile odd =
        parse(face + kList + color + "end_header\n" + kCorners + "3 0 1 2 2 1 1\n3 0 2 3 0\n");
    EXPECT_THAT(odd.warnings, ElementsAre(HasSubstr("other colours than corners")));
    const MeshFile both =
        parse("ply\nformat ascii 1.0\nelement vertex 3\n" + kXyz + rgb + "element face 1\n" + kList + rgb +
              "end_header\n0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n3 0 1 2 0 0 9\n");
    EXPECT_EQ(both.parts.at(0).mesh->colors.at(0), Vec3(1, 0, 0));
    EXPECT_THAT(both.warnings, ElementsAre(HasSubstr("colours of faces are left out")));
}

/// A red triangle with an image that `comment` names.
std::string redTriangle(const std::string& comment, const std::string& uvs = "uv") {
    const std::string uv = uvs.empty() ? "" : "property float u\nproperty float v\n",
                      none = uvs.empty() ? "" : " 0 0";
    return "ply\nformat ascii 1.0\ncomment " + comment + "\nelement vertex 3\n" + kXyz +
           "property uchar red\nproperty uchar green\nproperty uchar blue\n" + uv + "element face 1\n" +
           kList + "end_header\n0 0 0 255 0 0" + none + "\n1 0 0 255 0 0" + none + "\n0 1 0 255 0 0" + none +
           "\n3 0 1 2\n";
}

TEST(PlyColors, StayWhereTheImageIsMissingOrBroken) {
    const TempFolder folder;
    ASSERT_TRUE(savePng(folder.path("a.png"), {1, 1, {255, 0, 0}}));
    const std::string whole = TempFolder::read(folder.path("a.png"));
    folder.write("cut.png", whole.substr(0, whole.size() - 20));
    folder.write("text.png", "no picture");
    for (const char* image : {"gone.png", "cut.png", "text.png"}) {
        const auto scene = loadScene(folder.write("a.ply", redTriangle(std::string("TextureFile ") + image)),
                                     {.noStudio = true});
        ASSERT_TRUE(scene) << scene.error().format();
        EXPECT_EQ(scene->materials.at(0).color.value, Vec3(1)) << image;
        EXPECT_THAT(scene->meshes.at(0).data->colors, testing::Each(Vec3(1, 0, 0))) << image;
        EXPECT_THAT(scene->warnings, ElementsAre(HasSubstr(image)));
    }
    const auto shown = loadScene(folder.write("a.ply", redTriangle("TextureFile a.png")), {.noStudio = true});
    ASSERT_TRUE(shown) << shown.error().format();
    EXPECT_THAT(shown->meshes.at(0).data->colors, IsEmpty());
    EXPECT_THAT(shown->warnings, IsEmpty());
    EXPECT_THAT(shown->notes, Contains(HasSubstr("vertex colours are left out where an image stands")));
}

/// As in PLY; what `convert` writes looks the same.
TEST(ObjColors, AreLeftOutUnderAnImageThatIsRead) {
    const TempFolder folder;
    ASSERT_TRUE(savePng(folder.path("a.png"), {1, 1, {0, 255, 0}}));
    const std::string obj =
        "mtllib m.mtl\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nvt 0 0\nusemtl it\nf 1/1 2/1 3/1\n";
    for (const char* image : {"a.png", "gone.png"}) {
        folder.write("m.mtl", std::string("newmtl it\nmap_Kd ") + image + "\n");
        const auto scene = loadScene(folder.write("a.obj", obj), {.noStudio = true});
        ASSERT_TRUE(scene) << scene.error().format();
        EXPECT_EQ(scene->meshes.at(0).data->colors.empty(), std::string_view(image) == "a.png") << image;
        ASSERT_TRUE(saveSceneJson(*scene, folder.path("a.json")));
        const auto again = loadScene(folder.path("a.json"));
        ASSERT_TRUE(again) << again.error().format();
        EXPECT_EQ(again->meshes.at(0).data->colors.size(), scene->meshes[0].data->colors.size()) << image;
    }
}

TEST(PlyTextures, NamedInOtherWordsOrWithoutCoordinates) {
    const TempFolder folder;
    ASSERT_TRUE(savePng(folder.path("a.png"), {1, 1, {0, 255, 0}}));
    for (const char* comment : {"texturefile: a.png", "TEXTUREFILE a.png", "texture a.png", "Texture: a.png",
                                "texture_file a.png"}) {
        const auto scene = loadScene(folder.write("a.ply", redTriangle(comment)), {.noStudio = true});
        ASSERT_TRUE(scene) << scene.error().format();
        EXPECT_EQ(scene->materials.at(0).color.texture, 0) << comment;
    }
    EXPECT_THAT(parse(redTriangle("texture a.png")).warnings,
                ElementsAre(HasSubstr("in other words than TextureFile")));
    EXPECT_THAT(parse(redTriangle("texture coordinates are those of a.b")).warnings, IsEmpty());
    const MeshFile bare = parse(redTriangle("TextureFile a.png", ""));
    EXPECT_THAT(bare.warnings,
                ElementsAre(HasSubstr("an image without texture coordinates is left out: \"a.png\"")));
    EXPECT_EQ(bare.parts.at(0).mesh->colors.at(0), Vec3(1, 0, 0));
}

TEST(PlyTextures, CornersHaveTheirOwnCoordinates) {
    const std::string head =
        kHead + "element face 2\n" + kList + "property list uchar float texcoord\nend_header\n" + kCorners;
    const MeshFile joined = parse(head + "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0 0 1 1 0 1\n");
    EXPECT_THAT(joined.parts.at(0).mesh->uvs, ElementsAre(Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)));
    const MeshFile parted = parse(head + "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0.5 0 1 1 0 1\n");
    EXPECT_EQ(parted.parts.at(0).mesh->positions.size(), 5u);
    EXPECT_EQ(areaOf(parted), Vec3(0, 0, 4));
    const MeshFile some = parse(head + "3 0 1 2 0\n3 0 2 3 6 0.5 0 1 1 0 1\n");
    EXPECT_EQ(areaOf(some), Vec3(0, 0, 4));
    const MeshFile wrong = parse(head + "3 0 1 2 4 0 0 1 0\n3 0 2 3 6 0 0 1 1 0 1\n");
    EXPECT_THAT(wrong.warnings, ElementsAre(HasSubstr("other texture coordinates than corners")));
}

TEST(PlyTextures, ImagesNamedInCommentsAreUsed) {
    const TempFolder folder;
    ASSERT_TRUE(savePng(folder.path("a.png"), {1, 1, {255, 0, 0}}));
    ASSERT_TRUE(savePng(folder.path("b c.png"), {1, 1, {0, 255, 0}}));
    const std::string images = "comment TextureFile a.png\ncomment TextureFile B c.png\n";
    const std::string vertexUvs = "property float texture_u\nproperty float texture_v\n";
    const auto one = loadScene(folder.write(
        "one.ply", "ply\nformat ascii 1.0\ncomment TextureFile C:\\x\\a.png\nelement vertex 3\n" + kXyz +
                       vertexUvs + "element face 1\n" + kList +
                       "end_header\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n"));
    ASSERT_TRUE(one) << one.error().format();
    EXPECT_EQ(one->materials.at(0).color.texture, 0);
    EXPECT_TRUE(one->textures.at(0).image.isRead());

    const auto two = loadScene(
        folder.write("two.ply",
                     "ply\nformat ascii 1.0\n" + images + "element vertex 4\n" + kXyz + "element face 2\n" +
                         kList + "property list uchar float texcoord\nproperty int texnumber\nend_header\n" +
                         kCorners + "3 0 1 2 6 0 0 1 0 1 1 0\n3 0 2 3 6 0 0 1 1 0 1 1\n"),
        {.noStudio = true});
    ASSERT_TRUE(two) << two.error().format();
    ASSERT_EQ(two->objects.size(), 2u);
    EXPECT_EQ(two->textures.at(static_cast<size_t>(two->materials.at(0).color.texture)).name, "a.png");
    EXPECT_EQ(two->textures.at(static_cast<size_t>(two->materials.at(1).color.texture)).name, "B c.png");

    const auto json = loadScene(folder.write(
        "a.json", R"({"glint": 1, "objects": [{"type": "mesh", "mesh": {"file": "two.ply"}}]})"));
    ASSERT_TRUE(json) << json.error().format();
    EXPECT_EQ(json->objects.size(), 2u);
    const auto missing = loadScene(
        folder.write("one.ply", "ply\nformat ascii 1.0\ncomment TextureFile none.png\nelement vertex 3\n" +
                                    kXyz + vertexUvs + "element face 1\n" + kList +
                                    "end_header\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n"));
    ASSERT_TRUE(missing);
    EXPECT_THAT(missing->warnings,
                ElementsAre(HasSubstr("images are missing; a grey takes their place: \"none.png\"")));
}

}  // namespace
}  // namespace glint
