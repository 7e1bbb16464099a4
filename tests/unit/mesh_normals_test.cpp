// Normals decide which side of a triangle is its front, and files without normals get smooth ones where they
// mean them.
#include "engine/io/mesh_normals.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/importer.h"
#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

MeshFile read(const std::string& text, const char* name = "in.obj") {
    auto file = readMeshFile(text, name);
    EXPECT_TRUE(file) << file.error().format();
    return file ? std::move(*file) : MeshFile{};
}

Vec3 faceNormal(const MeshData& mesh, size_t triangle) {
    const uint32_t* corners = &mesh.indices[3 * triangle];
    const Vec3& a = mesh.positions[corners[0]];
    return glm::normalize(glm::cross(mesh.positions[corners[1]] - a, mesh.positions[corners[2]] - a));
}

/// Of a corner of the triangle: the normal that is used at it.
Vec3 normalAt(const MeshData& mesh, size_t triangle, size_t corner) {
    const Vec3 n = mesh.normals.empty() ? Vec3(0.0f) : mesh.normals[mesh.indices[3 * triangle + corner]];
    return isZero(n) ? faceNormal(mesh, triangle) : glm::normalize(n);
}

TEST(Winding, NormalsDecideInAllFormats) {
    const TempFolder folder;
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nvn 0 0 1\n";
    folder.write("a.obj", obj + "f 1//1 2//1 3//1\n");
    folder.write(
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0 0 0 -1\n1 0 0 0 0 -1\n0 1 0 0 0 -1\n3 0 1 "
        "2\n");
    const std::string scene =
        R"({"glint": 1, "objects": [{"type": "mesh", "material": {"type": "diffuse", "emission": 1}, "mesh": )";
    for (const std::string& mesh :
         {std::string(R"({"file": "a.obj"})"), std::string(R"({"file": "a.ply"})"),
          std::string(R"({"positions": [[0,0,0],[1,0,0],[0,1,0]], "normals": [[0,0,-1],[0,0,-1],[0,0,-1]],
                          "triangles": [[0,1,2]]})")}) {
        const auto loaded = loadScene(folder.write("a.json", scene + mesh + "}]}"));
        ASSERT_TRUE(loaded) << loaded.error().format();
        EXPECT_EQ(faceNormal(*loaded->meshes[0].data, 0), Vec3(0, 0, -1)) << mesh;
        EXPECT_THAT(loaded->warnings, ElementsAre(HasSubstr("wound against their normals"))) << mesh;
    }
    const MeshFile agreeing = read(obj + "f 1//2 2//2 3//2\n");
    EXPECT_EQ(faceNormal(*agreeing.parts[0].mesh, 0), Vec3(0, 0, 1));
    EXPECT_THAT(agreeing.warnings, IsEmpty());
    // One corner that looks away does not turn the triangle over.
    EXPECT_THAT(read(obj + "f 1//2 2//2 3//1\n").warnings, IsEmpty());
}

/// A ridge along y whose two faces turn by twice `slope`.
std::string ridge(double height, const std::string& before, const std::string& between = "") {
    return before +
           fmt::format(
               "v -1 -1 0\nv 0 -1 {0}\nv 1 -1 0\nv -1 1 0\nv 0 1 {0}\nv 1 1 0\nf 1 2 5 4\n{1}f 2 3 6 5\n",
               height, between);
}

bool isSmooth(const MeshFile& file) {
    for (size_t t = 0; t < 2; ++t) {
        const MeshData& mesh = *file.parts.front().mesh;
        for (size_t c = 0; c < 3; ++c) {
            if (mesh.positions[mesh.indices[3 * t + c]].x == 0.0f &&
                glm::length(normalAt(mesh, t, c) - Vec3(0, 0, 1)) < 1e-5f) {
                return true;
            }
        }
    }
    return false;
}

TEST(SmoothNormals, ByGroupsWhateverTheAngle) {
    const MeshFile smooth = read(ridge(0.9, "s 1\n"));
    EXPECT_TRUE(isSmooth(smooth));
    EXPECT_THAT(
        smooth.notes,
        ElementsAre(HasSubstr("4 triangles without normals get smooth ones, by the file's smoothing")));
    EXPECT_TRUE(isSmooth(read(ridge(0.9, "s 3\n", "usemtl other\n"))));  // across parts
    EXPECT_FALSE(isSmooth(read(ridge(0.1, "s off\n"))));
    EXPECT_FALSE(isSmooth(read(ridge(0.1, "s 0\n"))));
    EXPECT_FALSE(isSmooth(read(ridge(0.1, "s 1\n", "s 2\n"))));
    EXPECT_FALSE(isSmooth(read(ridge(0.1, "s 1\n", "s off\n"))));
}

TEST(SmoothNormals, ByAngleWithoutGroups) {
    EXPECT_TRUE(isSmooth(read(ridge(0.3, ""))));   // turns by 33 degrees
    EXPECT_FALSE(isSmooth(read(ridge(0.5, ""))));  // by 53
    const MeshFile flat = read(ridge(0.0, ""));
    EXPECT_TRUE(flat.parts[0].mesh->normals.empty());
    EXPECT_THAT(flat.notes, IsEmpty());
}

TEST(SmoothNormals, EqualPositionsAreOne) {
    // As files without shared vertices have it.
    EXPECT_TRUE(
        isSmooth(read("v -1 -1 0\nv 0 -1 .3\nv 0 1 .3\nv -1 1 0\nv 0 -1 .3\nv 1 -1 0\nv 1 1 0\nv 0 1 .3\n"
                      "f 1 2 3 4\nf 5 6 7 8\n")));
    EXPECT_TRUE(isSmooth(
        read("ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
             "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
             "-1 -1 0\n0 -1 .3\n1 -1 0\n-1 1 0\n0 1 .3\n1 1 0\n4 0 1 4 3\n4 1 2 5 4\n",
             "in.ply")));
}

/// A cylinder without caps of `sides` sides, with a cap on top.
std::string cylinder(int sides) {
    std::string text;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * 3.14159265358979 * i / sides;
        text += fmt::format("v {0} {1} 0\nv {0} {1} 1\n", std::cos(angle), std::sin(angle));
    }
    std::string cap = "f";
    for (int i = 0; i < sides; ++i) {
        const int a = 2 * i + 1, b = 2 * ((i + 1) % sides) + 1;
        text += fmt::format("f {} {} {} {}\n", a, b, b + 1, a + 1);
        cap += fmt::format(" {}", a + 1);
    }
    return text + cap + "\n";
}

TEST(SmoothNormals, FansEndAtCreases) {
    const MeshFile file = read(cylinder(16));
    const MeshData& mesh = *file.parts[0].mesh;
    EXPECT_EQ(mesh.positions.size(), 48u);  // the upper ring twice
    for (size_t t = 0; t < mesh.triangleCount(); ++t) {
        const Vec3 face = faceNormal(mesh, t);
        for (size_t c = 0; c < 3; ++c) {
            const Vec3& p = mesh.positions[mesh.indices[3 * t + c]];
            const Vec3 expected = face.z > 0.5f ? Vec3(0, 0, 1) : Vec3(p.x, p.y, 0);
            EXPECT_LT(glm::length(normalAt(mesh, t, c) - expected), 0.01f);
        }
    }
    EXPECT_TRUE(read(cylinder(6)).parts[0].mesh->normals.empty());
}

TEST(SmoothNormals, NormalsOfTheFileStay) {
    const MeshFile file = read(
        "v -1 -1 0\nv 0 -1 .3\nv 1 -1 0\nv -1 1 0\nv 0 1 .3\nv 1 1 0\nvn 0 1 1\nf 1//1 2//1 5//1 4//1\nf 2 3 "
        "6 5\n");
    const MeshData& mesh = *file.parts[0].mesh;
    EXPECT_EQ(normalAt(mesh, 0, 0), glm::normalize(Vec3(0, 1, 1)));
    EXPECT_FALSE(isSmooth(file));
}

}  // namespace
}  // namespace glint
