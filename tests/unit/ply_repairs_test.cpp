// PLY files as MeshLab, Blender, CloudCompare and others write them.
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "engine/io/ply_loader.h"
#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kList = "property list uchar int vertex_indices\n";
const std::string kHead = "ply\nformat ascii 1.0\nelement vertex 4\n" + kXyz;
const std::string kCorners = "-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n";

MeshFile parse(const std::string& text) {
    auto file = parsePly(text, "in.ply");
    EXPECT_TRUE(file) << file.error().format() << "\n" << text;
    return file ? std::move(*file) : MeshFile{};
}

Vec3 areaOf(const MeshFile& file) {
    Vec3 area(0.0f);
    for (const MeshPart& part : file.parts) {
        const MeshData& mesh = *part.mesh;
        for (size_t i = 0; i < mesh.indices.size(); i += 3) {
            const Vec3& a = mesh.positions[mesh.indices[i]];
            area += 0.5f * glm::cross(mesh.positions[mesh.indices[i + 1]] - a,
                                      mesh.positions[mesh.indices[i + 2]] - a);
        }
    }
    return area;
}

TEST(PlyRepairs, GiveTheSquareAndOneWarning) {
    const std::string head = kHead + "element face 1\n" + kList + "end_header\n";
    std::string returns = head + kCorners + "4 0 1 2 3\n";
    std::ranges::replace(returns, '\n', '\r');
    std::string wide("\xff\xfe", 2);
    for (const char c : head + kCorners + "4 0 1 2 3\n") {
        wide += {c, '\0'};
    }
    const std::pair<std::string, const char*> cases[] = {
        {kHead + "element face 2\n" + kList + "end_header\n" + kCorners + "4 0 1 2 3\n2 0 1\n",
         "in.ply:15: faces of fewer than 3 corners are left out"},
        {kHead + "element face 3\n" + kList + "end_header\n" + kCorners + "0\n4 0 1 2 3\n1 2\n",
         "(and 1 more)"},
        {"ply\nformat ascii 1.0\nCreated by C:\\some\\exporter\\\nelement vertex 4\n" + kXyz +
             "element face 1\n" + kList + "end_header\n" + kCorners + "4 0 1 2 3\n",
         "in.ply:3: header lines that are no statement of the format are left out: \"Created\""},
        {"ply\nformat ascii 1.1\n" + head.substr(21) + kCorners + "4 0 1 2 3\n", "in.ply:2: the version"},
        {head + "-1 -1 0\n1 -1 0\n1 1 0\n-1 1\n0\n4 0 1 2 3\n",
         "in.ply:13: elements are written over several lines"},
        {head + "-1\n-1\n0\n1\n-1\n0\n1\n1\n0\n-1\n1\n0\n4\n0\n1\n2\n3\n",
         "in.ply:10: elements are written over"},
        {head + kCorners + "4 0 1\n2 3\n", "in.ply:14: elements are written over"},
        {head + "-1 -1 0 5\n1 -1 0 5\n1 1 0 5\n-1 1 0 5\n4 0 1 2 3\n", "in.ply:10: more numbers on a line"},
        {head + kCorners + "4 0 1 2 3 255 0 0\n", "in.ply:14: more numbers on a line"},
        {head + kCorners + "4.0 0.0 1 2 3\n", "in.ply:14: a whole number is written with a point"},
        {returns, "lines that end in a carriage return alone"},
        {wide, "the file is UTF-16"},
    };
    for (const auto& [text, warning] : cases) {
        const MeshFile file = parse(text);
        EXPECT_EQ(areaOf(file), Vec3(0, 0, 4)) << text;
        EXPECT_THAT(file.warnings, ElementsAre(HasSubstr(warning))) << text;
    }
}

TEST(PlyRepairs, WhatTheFormatAllowsIsSilent) {
    const std::string head = kHead + "element face 1\n" + kList + "end_header\n";
    for (const std::string& text :
         {head + "-1 -1 0 1 -1 0 1 1 0 -1 1 0 4 0 1 2 3\n",  // all on one line
          head + "-1 -1 0 1 -1 0\n1 1 0 -1 1 0\n4 0 1 2 3\n",
          "ply\nformat ascii 1.0\nelement vertices 4\nproperty float X\nproperty float Y\nproperty float Z\n"
          "element faces 1\nproperty list float float vertex_index\nend_header\n" +
              kCorners + "4 0 1 2 3\n"}) {
        const MeshFile file = parse(text);
        EXPECT_EQ(areaOf(file), Vec3(0, 0, 4)) << text;
        EXPECT_THAT(file.warnings, IsEmpty()) << text;
    }
}

TEST(PlyRepairs, ALineTooShortInALineFileIsAnError) {
    const auto file =
        parsePly(kHead + "element face 1\n" + kList + "end_header\n-1 -1 0\n1 -1\n1 1 0\n-1 1 0\n4 0 1 2 3\n",
                 "in.ply");
    ASSERT_FALSE(file);
    EXPECT_THAT(file.error().format(), HasSubstr("in.ply:11:5: expected z, but the line ends"));
}

TEST(PlyRepairs, AttributesThatAreNoNumbersCountAsZero) {
    const MeshFile file =
        parse("ply\nformat ascii 1.0\nelement vertex 3\n" + kXyz +
              "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n" + kList +
              "end_header\n0 0 0 nan nan nan\n1 0 0 0 0 1\n0 1 0 0 inf 1\n3 0 1 2\n");
    EXPECT_THAT(file.parts[0].mesh->normals, ElementsAre(Vec3(0), Vec3(0, 0, 1), Vec3(0, 0, 1)));
    EXPECT_THAT(file.warnings, ElementsAre(HasSubstr("no finite numbers count as 0 (and 3 more)")));
}

TEST(PlyRepairs, Tristrips) {
    const std::string head =
        kHead + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + kCorners;
    for (const char* strips :
         {"4 0 1 3 2\n", "7 0 1 3 -1 1 2 3\n", "8 0 1 3 -1 -1 3 1 2\n", "7 0 1 3 3 3 1 2\n"}) {
        const MeshFile file = parse(head + strips);
        EXPECT_EQ(file.parts.at(0).mesh->triangleCount(), 2u) << strips;
        EXPECT_EQ(areaOf(file), Vec3(0, 0, 4)) << strips;
    }
    std::string binary = head.substr(0, head.size() - kCorners.size());
    binary.replace(binary.find("ascii"), 5, "binary_little_endian");
    for (const float x : {-1.0f, -1.0f, 0.0f, 1.0f, -1.0f, 0.0f, 1.0f, 1.0f, 0.0f, -1.0f, 1.0f, 0.0f}) {
        binary.append(reinterpret_cast<const char*>(&x), 4);
    }
    for (const int32_t i : {4, 0, 1, 3, 2}) {
        binary.append(reinterpret_cast<const char*>(&i), 4);
    }
    EXPECT_EQ(areaOf(parse(binary)), Vec3(0, 0, 4));
}

TEST(PlyRepairs, BinaryBodiesBeginBehindAnyLineEnd) {
    const std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" + kXyz +
                             "element face 1\n" + kList + "end_header\n";
    // The body begins with a line feed, as part of a number.
    std::string body("\n\0\0\0", 4);
    for (const float x : {0.0f, 0.0f, 2.0f, 0.0f, 0.0f, 0.0f, 2.0f, 0.0f}) {
        body.append(reinterpret_cast<const char*>(&x), 4);
    }
    body += std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
    std::string crlf, returns = head;
    for (const char c : head) {
        crlf += c == '\n' ? "\r\n" : std::string(1, c);
    }
    std::ranges::replace(returns, '\n', '\r');
    for (const std::string& text : {head + body, crlf + body, returns + body}) {
        EXPECT_EQ(areaOf(parse(text)), Vec3(0, 0, 2)) << text.substr(0, 5);
    }
    EXPECT_THAT(parse(crlf + body).warnings, IsEmpty());
}

TEST(PlyRepairs, PointCloudsAreRefusedByThatName) {
    for (const std::string& text : {kHead + "end_header\n" + kCorners,
                                    kHead + "element face 0\n" + kList + "end_header\n" + kCorners}) {
        const auto file = parsePly(text, "in.ply");
        ASSERT_FALSE(file);
        EXPECT_THAT(file.error().format(), HasSubstr("the file has no faces (4 vertices): a point cloud"));
    }
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
