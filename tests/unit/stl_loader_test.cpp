// STL: both forms, as programs write them, and what is refused.
#include "engine/io/stl_loader.h"

#include <cmath>
#include <cstring>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Facet {
    Vec3 corners[3];
    uint16_t attribute = 0;
};

/// A tetrahedron, wound outwards.
std::vector<Facet> tetrahedron() {
    const Vec3 o(0.0f), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    return {{{o, y, x}}, {{o, x, z}}, {{o, z, y}}, {{x, y, z}}};
}

template <class Number>
void append(Number number, std::string* out) {
    out->append(reinterpret_cast<const char*>(&number), sizeof number);
}

std::string binary(const std::vector<Facet>& facets, std::string header = "exported by a program") {
    header.resize(80, ' ');
    append(static_cast<uint32_t>(facets.size()), &header);
    for (const Facet& facet : facets) {
        header += std::string(12, '\0');  // a normal that says nothing
        for (const Vec3& corner : facet.corners) {
            append(corner.x, &header);
            append(corner.y, &header);
            append(corner.z, &header);
        }
        append(facet.attribute, &header);
    }
    return header;
}

std::string text(const std::vector<Facet>& facets, const std::string& name = "a solid") {
    std::string out = "solid " + name + "\n";
    for (const Facet& facet : facets) {
        out += "  facet normal 0 0 0\n    outer loop\n";
        for (const Vec3& p : facet.corners) {
            out += "      vertex " + std::to_string(p.x) + " " + std::to_string(p.y) + " " +
                   std::to_string(p.z) + "\n";
        }
        out += "    endloop\n  endfacet\n";
    }
    return out + "endsolid " + name + "\n";
}

std::string replaced(std::string in, const std::string& from, const std::string& to) {
    for (size_t at = in.find(from); at != std::string::npos; at = in.find(from, at + to.size())) {
        in.replace(at, from.size(), to);
    }
    return in;
}

void expectTetrahedron(const std::string& bytes) {
    const auto file = parseStl(bytes, "a.stl");
    ASSERT_TRUE(file) << file.error().format();
    ASSERT_EQ(file->parts.size(), 1u);
    const MeshData& mesh = *file->parts[0].mesh;
    EXPECT_EQ(mesh.positions.size(), 4u) << "corners in one place are one vertex";
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3, 0, 3, 1, 2, 1, 3));
    EXPECT_THAT(file->warnings, IsEmpty());
}

TEST(Stl, BothFormsHoldTheSameMesh) {
    const std::vector<Facet> facets = tetrahedron();
    expectTetrahedron(binary(facets));
    expectTetrahedron(text(facets));
    // As programs write them: a header that begins as a text does, bytes behind the end, other line ends and
    // letters, no name, a path that ends in a backslash, everything on one line, minus zero.
    expectTetrahedron(binary(facets, "solid by a program"));
    expectTetrahedron(binary(facets) + "more");
    expectTetrahedron(replaced(text(facets), "\n", "\r\n"));
    expectTetrahedron(replaced(replaced(text(facets), "vertex", "VERTEX"), "facet", "Facet"));
    expectTetrahedron(text(facets, ""));
    expectTetrahedron(text(facets, "C:\\models\\"));
    expectTetrahedron(replaced(text(facets).substr(14), "\n  ", " "));
    expectTetrahedron(replaced(text(facets), "vertex 0.000000", "vertex -0"));
}

TEST(Stl, TheBinaryFormIsKnownUnderOtherNames) {
    const TempFolder folder;
    const auto opens = [&](const char* name, const std::string& bytes) {
        const auto scene = loadScene(folder.write(name, bytes), {.noStudio = true});
        return scene && scene->meshes.at(0).data->triangleCount() > 0;
    };
    std::vector<Facet> many, flat;
    for (int i = 0; i < 200; ++i) {
        const float x = 0.1f * static_cast<float>(i);
        many.push_back({{Vec3(x, 0, 0), Vec3(x, 1, -0.5f), Vec3(0, 2, 7)}});
        flat.push_back({{Vec3(0), Vec3(x, 0, 0), Vec3(0, 0, 1)}});
    }
    for (const char* name : {"a.bin", "a", "a.obj", "a.ply", "a.json"}) {
        EXPECT_TRUE(opens(name, binary(tetrahedron(), std::string(80, '\0')))) << name;
        EXPECT_TRUE(opens(name, binary(many, std::string(80, '\0')))) << name;
        EXPECT_TRUE(opens(name, binary(flat, std::string(80, '\0')))) << name;
    }
    std::mt19937 random(7);
    std::string other = binary(tetrahedron(), std::string(80, '\0'));
    for (int round = 0; round < 1000; ++round) {
        for (size_t i = 84; i < other.size(); ++i) {
            other[i] = static_cast<char>(random());
        }
        EXPECT_FALSE(looksLikeBinaryStl(other)) << round;
        EXPECT_FALSE(looksLikeBinaryStl(other + "more"));
    }
    EXPECT_FALSE(looksLikeBinaryStl(std::string(4096, '\0')));
    EXPECT_FALSE(looksLikeBinaryStl(std::string(4096, '\1'))) << "whole numbers, not floats";
}

TEST(Stl, SolidsAreParts) {
    const auto file =
        parseStl(text(tetrahedron(), "one") + text({}, "none") + text(tetrahedron(), "two"), "a.stl");
    ASSERT_TRUE(file) << file.error().format();
    ASSERT_EQ(file->parts.size(), 2u);
    EXPECT_EQ(file->parts[0].name, "one");
    EXPECT_EQ(file->parts[1].name, "two");
    EXPECT_EQ(file->parts[1].mesh->indices.size(), 12u);
}

TEST(Stl, WhatIsLeftOutIsSaid) {
    std::vector<Facet> colored = tetrahedron();
    colored[1].attribute = 0x8123;
    const auto file = parseStl(binary(colored), "a.stl");
    ASSERT_TRUE(file);
    EXPECT_THAT(file->warnings, ElementsAre(HasSubstr("may be colours, are left out (1)")));
    std::string four = text(tetrahedron());
    four.insert(four.find("    endloop"), "      vertex 0.5 0.5 0\n");  // a facet of four corners
    const size_t last = four.rfind("      vertex");
    const auto odd = parseStl(four.substr(0, last) + four.substr(four.find('\n', last) + 1), "a.stl");
    ASSERT_TRUE(odd) << odd.error().format();
    EXPECT_EQ(odd->parts[0].mesh->indices.size(), 3u * 4u);
    EXPECT_THAT(odd->warnings, ElementsAre("a.stl:29: facets of fewer than 3 corners are left out"));
}

TEST(Stl, OpensAsAModelWithEdgesAndSmoothSurfaces) {
    const TempFolder folder;
    const auto scene = loadScene(folder.write("a.stl", binary(tetrahedron())));
    ASSERT_TRUE(scene) << scene.error().format();
    EXPECT_EQ(scene->meshes[0].data->triangleCount(), 4u);
    EXPECT_TRUE(scene->meshes[0].data->normals.empty()) << "its edges are sharp";
    std::vector<Facet> ring;  // of 40 sides
    const auto at = [](int i, float y) {
        const float angle = static_cast<float>(i % 40) * (2.0f * kPi / 40.0f);
        return Vec3(std::cos(angle), y, std::sin(angle));
    };
    for (int i = 0; i < 40; ++i) {
        ring.push_back({{at(i, 0), at(i, 1), at(i + 1, 0)}});
        ring.push_back({{at(i + 1, 0), at(i, 1), at(i + 1, 1)}});
    }
    const auto smooth = loadScene(folder.write("b.stl", text(ring)));
    ASSERT_TRUE(smooth) << smooth.error().format();
    const MeshData& mesh = *smooth->meshes[0].data;
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    for (size_t i = 0; i < mesh.normals.size(); ++i) {
        EXPECT_GT(
            glm::dot(glm::normalize(mesh.normals[i]), Vec3(mesh.positions[i].x, 0, mesh.positions[i].z)),
            0.999f);
    }
    const auto holder = loadScene(folder.write("c.json", R"({"glint": 1, "environment": {"color": 1},
        "objects": [{"type": "mesh", "mesh": {"file": "a.stl"}}]})"));
    ASSERT_TRUE(holder) << holder.error().format();
    EXPECT_EQ(holder->objects.size(), 1u);
}

TEST(Stl, MalformedFilesAreRefusedAtTheirPlace) {
    const std::string good = text(tetrahedron()), facets = binary(tetrahedron());
    std::string infinite = facets;
    const float notFinite = INFINITY;
    std::memcpy(&infinite[84 + 50 + 12], &notFinite, sizeof notFinite);
    const std::pair<std::string, const char*> files[] = {
        {facets.substr(0, 200), "says 4 facets, and holds 2"},
        {facets.substr(0, 60) + std::string(3, '\0'), "cut off"},
        {binary({}), "has no facets"},
        {"solid a\nendsolid a\n", "has no facets"},
        {infinite, "facet 2 has a coordinate that is no number"},
        {replaced(good, "vertex 1.000000", "vertex 1e30"), ":6:13: this coordinate is too large"},
        {replaced(good, "vertex 1.000000", "vertex one"), ":6:14: "},
        {replaced(good, "vertex 1.000000", "vertex nan"), ":6:14: "},
        {replaced(good, "outer loop", "outer hoop"), ":3:11: \"hoop\" is no word of an STL file"},
        {"", ""}};
    for (const auto& [bytes, message] : files) {
        const auto file = parseStl(bytes, "a.stl");
        ASSERT_FALSE(file) << message;
        EXPECT_THAT(file.error().format(), HasSubstr(message));
    }
}

TEST(Stl, DamagedFilesNeverCrash) {
    std::mt19937 random(5);
    for (const std::string& good : {text(tetrahedron()), binary(tetrahedron())}) {
        for (int round = 0; round < 4000; ++round) {
            std::string bytes = good;
            for (size_t changes = 1 + random() % 4; changes > 0; --changes) {
                bytes[random() % bytes.size()] = static_cast<char>(random());
            }
            const auto file = parseStl(bytes.substr(0, bytes.size() - random() % 20), "a.stl");
            for (const MeshPart& part : file ? file->parts : std::vector<MeshPart>{}) {
                for (const uint32_t index : part.mesh->indices) {
                    ASSERT_LT(index, part.mesh->positions.size());
                }
            }
        }
    }
}

}  // namespace
}  // namespace glint
