// PLY files as MeshLab, Blender, CloudCompare and others write them.
#include <array>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/ply_loader.h"
#include "engine/io/scene_loader.h"
#include "tests/support/ply_texts.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

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

TEST(PlyRepairs, HeadersInOtherCase) {
    const std::string text = kHead + "element face 1\n" + kList + "end_header\n" + kCorners + "4 0 1 2 3\n";
    std::string all = text.substr(0, text.find("end_header") + 10);
    std::ranges::transform(all, all.begin(), [](char c) { return c >= 'a' && c <= 'z' ? c - 32 : c; });
    for (const std::string& other :
         {withWord(text, "ply\n", "PLY\n"), withWord(text, "format ascii", "Format ASCII"),
          withWord(text, "element", "Element"), withWord(text, "float", "Float"),
          withWord(text, "list uchar int", "LIST UCHAR INT"), withWord(text, "end_header", "End_Header"),
          all + text.substr(all.size())}) {
        const MeshFile file = parse(other);
        EXPECT_EQ(areaOf(file), Vec3(0, 0, 4)) << other;
        EXPECT_THAT(file.warnings, ElementsAre(HasSubstr("words of the header in other case"))) << other;
    }
    const TempFolder folder;
    EXPECT_TRUE(loadScene(folder.write("a.txt", withWord(text, "ply\n", "PLY\n"))));
    EXPECT_FALSE(loadScene(folder.write("a.ply", withWord(text, "ply\n", "PLY\n")), {.strict = true}));
}

/// A square of 5 by 5 squares of two triangles, its numbers so many on a line.
std::string wrappedSquare(int perLine, const std::string& more = "") {
    std::string numbers;
    for (int i = 0; i < 36; ++i) {
        numbers += std::to_string(i % 6) + " " + std::to_string(i / 6) + " 0 ";
    }
    for (int i = 0; i < 25; ++i) {
        const int a = i % 5 + 6 * (i / 5);
        for (const auto& [p, q, r] : {std::array{a, a + 1, a + 7}, std::array{a, a + 7, a + 6}}) {
            numbers += "3 " + std::to_string(p) + " " + std::to_string(q) + " " + std::to_string(r) + " ";
        }
    }
    int count = 0;
    for (char& c : numbers) {
        if (c == ' ' && ++count % perLine == 0) { c = '\n'; }
    }
    return withWord(kHead, "vertex 4", "vertex 36") + "element face 50\n" + kList + "end_header\n" + numbers +
           more;
}

TEST(PlyRepairs, NumbersArePartedByAnyBlanks) {
    for (int perLine = 1; perLine < 20; ++perLine) {
        const MeshFile file = parse(wrappedSquare(perLine));
        EXPECT_EQ(areaOf(file), Vec3(0, 0, 25)) << perLine;
        EXPECT_EQ(file.warnings.size(), perLine % 12 == 0 ? 0u : 1u) << perLine;  // whole ones are silent
    }
    // What is no whole number of elements is an error, as is a line too short.
    EXPECT_FALSE(parsePly(wrappedSquare(7, "1"), "in.ply"));
    EXPECT_FALSE(parsePly(wrappedSquare(4, "0\n0\n"), "in.ply"));
}

TEST(PlyRepairs, FacesMayComeBeforeVertices) {
    const std::string faces = "element face 1\n" + kList, vertices = "element vertex 4\n" + kXyz;
    const std::string other = "element camera 1\nproperty list int int x\n";
    const std::string ascii = "ply\nformat ascii 1.0\n";
    for (const std::string& text :
         {ascii + faces + vertices + "end_header\n4 0 1 2 3\n" + kCorners,
          ascii + other + faces + other + vertices + "end_header\n2 5 5\n4 0 1 2 3\n0\n" + kCorners,
          ascii + faces + vertices + other + "end_header\n4 0 1 2 3 -1 -1 0 1 -1 0 1 1 0 -1 1 0 0\n"}) {
        const MeshFile file = parse(text);
        EXPECT_EQ(areaOf(file), Vec3(0, 0, 4)) << text;
        EXPECT_THAT(file.warnings, IsEmpty()) << text;
    }
    std::string binary = "ply\nformat binary_little_endian 1.0\n" + faces + vertices + "end_header\n" +
                         std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 9.f, 9.f, 9.f}) {
        binary.append(reinterpret_cast<const char*>(&x), 4);
    }
    EXPECT_EQ(areaOf(parse(binary)), Vec3(0, 0, 0.5f));
}

TEST(PlyRepairs, VerticesWithoutAPlaceThatNoFaceUses) {
    const std::string head =
        withWord(kHead, "vertex 4", "vertex 5") + "element face 1\n" + kList + "end_header\n";
    for (const char* place : {"nan nan nan", "inf 0 0", "0 -1.#IND 0", "0 0 1e30"}) {
        const MeshFile file = parse(head + kCorners + place + "\n4 0 1 2 3\n");
        EXPECT_EQ(areaOf(file), Vec3(0, 0, 4)) << place;
        EXPECT_EQ(file.parts.at(0).mesh->positions.back().z, 0.0f) << place;
        EXPECT_THAT(file.warnings, ElementsAre(HasSubstr("in.ply:14: vertices without a place"))) << place;
        const auto used = parsePly(head + kCorners + place + "\n3 0 1 4\n", "in.ply");
        ASSERT_FALSE(used) << place;
        EXPECT_THAT(used.error().format(), HasSubstr("in.ply:14:")) << place;
    }
    const auto second = parsePly(head + "nan 0 0\n1 0 0\n1 1 0\nnan 0 0\n0 1 0\n3 1 2 3\n", "in.ply");
    ASSERT_FALSE(second);
    EXPECT_THAT(second.error().format(), HasSubstr("in.ply:15:7: vertex 3 has no place"));
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
              "end_header\n0 0 0 nan -nan(ind) 1.#QNAN\n1 0 0 0 0 1\n0 1 0 -1.#IND00 1.#INF 1\n3 0 1 2\n");
    EXPECT_THAT(file.parts[0].mesh->normals, ElementsAre(Vec3(0), Vec3(0, 0, 1), Vec3(0, 0, 1)));
    EXPECT_THAT(file.warnings, ElementsAre(HasSubstr("no finite numbers count as 0 (and 4 more)")));
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

TEST(PlyRepairs, ElementsThatAreNoFacesAreNamed) {
    for (const char* name : {"trifan", "triangles", "polygons"}) {
        const auto file = parsePly(
            kHead + "element " + name + " 1\n" + kList + "end_header\n" + kCorners + "4 0 1 2 3\n", "in.ply");
        ASSERT_FALSE(file);
        EXPECT_THAT(file.error().format(),
                    HasSubstr(std::string("no faces (4 vertices); it has 1 \"") + name + "\"; expected"));
    }
    const auto lines =
        parsePly(kHead + "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n" +
                     kCorners + "0 1\n",
                 "in.ply");
    ASSERT_FALSE(lines);
    EXPECT_THAT(lines.error().format(), HasSubstr("it has 1 \"edge\"; expected"));
    const auto other =
        parsePly(kHead + "element face 1\nproperty int a\nproperty list uchar int b\nend_header\n" +
                     kCorners + "0 1 1\n",
                 "in.ply");
    ASSERT_FALSE(other);
    EXPECT_THAT(other.error().format(), HasSubstr("in the element face, but found a, b"));
}

}  // namespace
}  // namespace glint
