// pbrt's shapes: where their triangles and surfaces are.
#include <cmath>
#include <set>

#include "engine/io/pbrt_grid.h"
#include "engine/scene/mesh_area.h"
#include "tests/support/pbrt_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class PbrtShapesTest : public PbrtTest {
  protected:
    static Vec3 faceNormal(const MeshData& mesh, size_t triangle = 0) {
        const auto at = [&](size_t k) { return mesh.positions[mesh.indices[3 * triangle + k]]; };
        return glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
    }
};

TEST_F(PbrtShapesTest, TriangleMeshes) {
    MeshData mesh = meshOf(R"(Translate 0 0 1 Shape "trianglemesh" "point3 P" [0 0 0  2 0 0  2 2 0  0 2 0]
"integer indices" [0 1 2 0 2 3] "point2 uv" [0 0 1 0 1 1 0 1] "normal N" [0 0 1 0 0 1 0 0 1 0 0 1])");
    EXPECT_EQ(mesh.triangleCount(), 2u);
    EXPECT_EQ(mesh.positions.at(2), Vec3(2, 2, 1));
    EXPECT_EQ(mesh.uvs.at(1), Vec2(1, 0));
    EXPECT_EQ(mesh.normals.at(0), Vec3(0, 0, 1));
    EXPECT_EQ(faceNormal(mesh), Vec3(0, 0, 1));
    EXPECT_THAT(warnings, IsEmpty());
    // Without normals all is flat, and the front is where the corners run counter-clockwise.
    mesh = meshOf("Shape \"trianglemesh\" \"point P\" [0 0 0 1 0 0 0 1 0]");
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_EQ(faceNormal(mesh), Vec3(0, 0, 1));
    mesh = meshOf("ReverseOrientation Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0]");
    EXPECT_EQ(faceNormal(mesh), Vec3(0, 0, -1));
    // Normals decide which side is the front.
    mesh =
        meshOf("Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"normal N\" [0 0 -1 0 0 -1 0 0 -1]");
    EXPECT_EQ(faceNormal(mesh), Vec3(0, 0, -1));
    // Under a picture, each triangle has pbrt's usual coordinates.
    mesh = meshOf(R"(Texture "t" "spectrum" "checkerboard" Material "diffuse" "texture reflectance" "t"
Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 0 1 0])");
    EXPECT_EQ(mesh.uvs, (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}}));
    EXPECT_THAT(
        errorOf("Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 3]"),
        HasSubstr("bad.pbrt:3:53: the index 3 is none of those of the 3 points"));
}

TEST_F(PbrtShapesTest, PlyMeshes) {
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    folder.write("plain.ply", header + faces + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    folder.write("packed.ply.gz", gzipped(header + faces + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"));
    folder.write("smooth.ply", header + "property float nx\nproperty float ny\nproperty float nz\n" + faces +
                                   "0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n4 0 1 2 3\n");
    for (const char* name : {"plain.ply", "packed.ply.gz"}) {
        const MeshData mesh = meshOf("Shape \"plymesh\" \"string filename\" \"" + std::string(name) + "\"");
        EXPECT_EQ(mesh.triangleCount(), 2u) << name;
        EXPECT_TRUE(mesh.normals.empty());
    }
    const SceneDescription scene = load(R"(Shape "plymesh" "string filename" "smooth.ply"
Shape "plymesh" "string filename" "smooth.ply" ReverseOrientation Shape "plymesh" "string filename" "smooth.ply")");
    ASSERT_EQ(scene.objects.size(), 3u);
    EXPECT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(pathOf(scene.meshes[0].source), "smooth.ply");
    EXPECT_EQ(scene.meshes[1].data->normals.at(0), Vec3(0, 0, -1));
    EXPECT_THAT(errorOf("Shape \"plymesh\" \"string filename\" \"none.ply\""),
                HasSubstr("bad.pbrt:3:1: the file"));
    EXPECT_THAT(
        load("Shape \"sphere\" Shape \"plymesh\" \"string filename\" \"none.ply\"", {.allowMissing = true})
            .warnings,
        Contains(HasSubstr("cannot be read")));
    folder.write("broken.ply", header + faces + "0 0 0\n");
    EXPECT_THAT(errorOf("Shape \"plymesh\" \"string filename\" \"broken.ply\""),
                HasSubstr("broken.ply:3:16"));
}

/// Several are read at once; all is said in the file's order, and the first error is the first file's.
TEST_F(PbrtShapesTest, MeshFilesKeepTheirOrder) {
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n";
    std::string world;
    for (int i = 0; i < 20; ++i) {
        const std::string name = std::to_string(i) + ".ply";
        folder.write(name, head + std::to_string(i + 2) + " 1 0\n3 0 1 2\n2 0 3\n");
        world += "Shape \"plymesh\" \"string filename\" \"" + name + "\"\n";
    }
    LoadCounts counts;
    const SceneDescription scene = load(world + world, {.counts = &counts});
    EXPECT_EQ(counts.meshFiles, 20u);
    ASSERT_EQ(scene.objects.size(), 40u);
    ASSERT_GE(scene.warnings.size(), 20u) << "a face of two corners each";
    for (size_t i = 0; i < 20; ++i) {
        const Mesh& mesh = scene.meshes.at(static_cast<size_t>(scene.objects[20 + i].mesh));
        EXPECT_EQ(mesh.name, std::to_string(i) + " " + std::to_string(i));
        EXPECT_EQ(mesh.data->positions.at(3).x, static_cast<float>(i + 2));
        EXPECT_THAT(scene.warnings[i], HasSubstr("/" + std::to_string(i) + ".ply:"));
    }
    folder.write("7.ply", "ply\n");
    folder.write("3.ply", head + "oops");
    EXPECT_THAT(errorOf(world + "Shape \"nothing\""), HasSubstr("3.ply:"));
    EXPECT_THAT(errorOf("Shape \"nothing\" " + world), HasSubstr("nothing"));
    // The area of a lamp by its power is needed at once.
    EXPECT_THAT(errorOf("AreaLightSource \"diffuse\" \"float power\" 5 " + world), HasSubstr("3.ply:"));
}

TEST_F(PbrtShapesTest, BilinearMeshesAreSplit) {
    const Object rectangle = onlyObject("Shape \"bilinearmesh\" \"point3 P\" [0 0 0  2 0 0  0 1 0  2 1 0]");
    EXPECT_EQ(rectangle.shape, ShapeKind::Rectangle);
    expectNear(rectangle.objectToWorld.point(Vec3(-1, -1, 0)), Vec3(0, 0, 0), 1e-6f);
    expectNear(rectangle.objectToWorld.point(Vec3(1, -1, 0)), Vec3(2, 0, 0), 1e-6f);
    expectNear(rectangle.objectToWorld.point(Vec3(-1, 1, 0)), Vec3(0, 1, 0), 1e-6f);
    EXPECT_GT(rectangle.objectToWorld.determinant(), 0.0f);
    // A picture keeps its place when its rectangle's front is the other side.
    MeshData mesh =
        meshOf(R"(Texture "t" "spectrum" "checkerboard" Material "diffuse" "texture reflectance" "t"
ReverseOrientation Shape "bilinearmesh" "point3 P" [0 0 0  2 0 0  0 1 0  2 1 0])");
    EXPECT_EQ(faceNormal(mesh), Vec3(0, 0, -1));
    EXPECT_EQ(mesh.uvs.at(1), Vec2(1, 0));
    mesh = meshOf("Shape \"bilinearmesh\" \"point3 P\" [0 0 0  2 0 0  0 1 0  3 1 0]");
    EXPECT_EQ(mesh.triangleCount(), 2u);
    EXPECT_NEAR(areaOf(mesh), 2.5, 1e-6);
    EXPECT_EQ(faceNormal(mesh), Vec3(0, 0, 1));
    EXPECT_EQ(mesh.uvs.at(3), Vec2(1, 1));
    mesh = meshOf("Shape \"bilinearmesh\" \"point3 P\" [0 0 0  1 0 0  0 1 0  1 1 1]");
    EXPECT_EQ(mesh.triangleCount(), 128u);
    for (const Vec3& p : mesh.positions) {
        EXPECT_NEAR(p.z, p.x * p.y, 1e-6f);
    }
}

TEST_F(PbrtShapesTest, SpheresAreWholeOrMeshes) {
    const Object sphere = onlyObject("Translate 1 2 3 Shape \"sphere\" \"float radius\" 2");
    EXPECT_EQ(sphere.shape, ShapeKind::Sphere);
    EXPECT_EQ(sphere.objectToWorld.translation, Vec3(1, 2, 3));
    // u = 0.5 + atan2(x, z) / 2 pi of Glint is pbrt's from +x to +y; its north is +z.
    expectNear(sphere.objectToWorld.vector(Vec3(0, 1, 0)), Vec3(0, 0, 2), 1e-6f);
    expectNear(sphere.objectToWorld.vector(Vec3(0, 0, -1)), Vec3(2, 0, 0), 1e-6f);
    expectNear(sphere.objectToWorld.vector(Vec3(-1, 0, 0)), Vec3(0, 2, 0), 1e-6f);
    MeshData part = meshOf("Shape \"sphere\" \"float radius\" 2 \"float zmin\" 0 \"float phimax\" 90");
    for (const Vec3& p : part.positions) {
        EXPECT_NEAR(glm::length(p), 2.0f, 1e-5f);
        EXPECT_GE(minComponent(p), -1e-5f);
    }
    EXPECT_NEAR(areaOf(part), 2.0 * 3.14159265, 0.01);
    EXPECT_GT(glm::dot(faceNormal(part, 600), part.positions[part.indices[1800]]), 1.0f);
    // Inside out matters for glass and light.
    EXPECT_EQ(onlyObject("ReverseOrientation Shape \"sphere\"").shape, ShapeKind::Sphere);
    part = meshOf("ReverseOrientation Material \"dielectric\" Shape \"sphere\"");
    EXPECT_LT(glm::dot(faceNormal(part, 3000), part.positions[part.indices[9000]]), -0.5f);
    EXPECT_NEAR(areaOf(part), 4.0 * 3.14159265, 0.03);
}

TEST_F(PbrtShapesTest, DisksAndCylinders) {
    const Object disk = onlyObject("Shape \"disk\" \"float radius\" 2 \"float height\" 3");
    EXPECT_EQ(disk.shape, ShapeKind::Disc);
    expectNear(disk.objectToWorld.point(Vec3(1, 0, 0)), Vec3(2, 0, 3), 1e-6f);
    expectNear(onlyObject("ReverseOrientation Shape \"disk\"").objectToWorld.vector(Vec3(0, 0, 1)),
               Vec3(0, 0, -1), 1e-6f);
    const MeshData ring =
        meshOf("Shape \"disk\" \"float radius\" 2 \"float innerradius\" 1 \"float phimax\" 180");
    EXPECT_NEAR(areaOf(ring), 1.5 * 3.14159265, 0.01);
    expectNear(faceNormal(ring), Vec3(0, 0, 1), 1e-5f);
    const Object cylinder =
        onlyObject("Shape \"cylinder\" \"float radius\" 2 \"float zmin\" 1 \"float zmax\" 4");
    EXPECT_EQ(cylinder.shape, ShapeKind::Revolved);
    EXPECT_EQ(cylinder.profile, (std::vector<Vec2>{{2, 4}, {2, 1}}));
    expectNear(cylinder.objectToWorld.vector(Vec3(0, 1, 0)), Vec3(0, 0, 1), 1e-6f);
    // u = angle / 2 pi of Glint's turned profiles begins at +x and runs to -z.
    expectNear(cylinder.objectToWorld.vector(Vec3(0, 0, -1)), Vec3(0, 1, 0), 1e-6f);
    const MeshData half = meshOf("Shape \"cylinder\" \"float phimax\" 180");
    EXPECT_NEAR(areaOf(half), 2.0 * 3.14159265, 0.01);
    EXPECT_GT(glm::dot(faceNormal(half), half.positions[half.indices[0]]), 0.9f);
    for (const char* old : {"cone", "paraboloid"}) {
        EXPECT_GT(areaOf(meshOf("Shape \"" + std::string(old) + "\"")), 3.0) << old;
    }
    EXPECT_NEAR(areaOf(meshOf("Shape \"hyperboloid\" \"point3 p1\" [1 0 0] \"point3 p2\" [1 0 1]")),
                2.0 * 3.14159265, 0.01);
}

/// An octahedron's limit surface; where all vertices have four neighbours their places are known.
TEST_F(PbrtShapesTest, LoopSubdivisionReachesItsLimit) {
    const std::string octahedron = R"("point3 P" [1 0 0 -1 0 0 0 1 0 0 -1 0 0 0 1 0 0 -1]
"integer indices" [0 2 4 2 1 4 1 3 4 3 0 4 2 0 5 1 2 5 3 1 5 0 3 5])";
    const MeshData coarse = meshOf("Shape \"loopsubdiv\" \"integer levels\" 0 " + octahedron);
    EXPECT_EQ(coarse.triangleCount(), 8u);
    // Each neighbour weighs 1 / (4 + 3 / (8 * 3/32)) = 1/8, and they sum to 0: half is left.
    expectNear(coarse.positions.at(0), Vec3(0.5f, 0, 0), 1e-6f);
    const MeshData fine = meshOf("Shape \"loopsubdiv\" \"integer levels\" 3 " + octahedron);
    EXPECT_EQ(fine.triangleCount(), 512u);
    expectNear(fine.positions.at(0), Vec3(0.5f, 0, 0), 1e-5f);
    EXPECT_GT(glm::dot(faceNormal(fine), fine.positions[0]), 0.3f);
    EXPECT_EQ(fine.normals.size(), fine.positions.size());
    // The edge of a square keeps its straight sides, and its corners are drawn in.
    const MeshData square =
        meshOf(R"(Shape "loopsubdiv" "integer levels" 1 "point3 P" [0 0 0 4 0 0 4 4 0 0 4 0]
"integer indices" [0 1 2 0 2 3])");
    EXPECT_EQ(square.triangleCount(), 8u);
    for (const Vec3& p : square.positions) {
        EXPECT_EQ(p.z, 0.0f);
        EXPECT_TRUE(p.x >= 0.0f && p.x <= 4.0f);
    }
}

TEST_F(PbrtShapesTest, CurvesAreTubes) {
    const MeshData tube = meshOf(
        R"(Shape "curve" "point3 P" [0 0 0 1 0 0 2 0 0 3 0 0] "float width" 0.2 "string type" "cylinder")");
    EXPECT_EQ(tube.triangleCount(), 8u);
    const float radius = 0.1f * kPi / (4.0f * std::sin(kPi / 4.0f));
    for (const Vec3& p : tube.positions) {
        EXPECT_NEAR(glm::length(Vec2(p.y, p.z)), radius, 1e-5f);
    }
    for (size_t i = 0; i < tube.triangleCount(); ++i) {
        const Vec3 middle = tube.positions[tube.indices[3 * i]];
        EXPECT_GT(glm::dot(faceNormal(tube, i), Vec3(0, middle.y, middle.z)), 0.0f);
    }
    // Curves that follow each other are one mesh, but for another material.
    const SceneDescription scene = load(R"(Shape "curve" "point3 P" [0 0 0 1 0 0 2 0 0 3 0 0]
Shape "curve" "point3 P" [0 1 0 1 1 0 2 1 0 3 1 0] Material "diffuse" "rgb reflectance" [1 0 0]
Shape "curve" "integer degree" 2 "string basis" "bspline" "point3 P" [0 0 0 1 0 0 2 1 0 3 1 0])");
    EXPECT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.meshes.at(0).data->triangleCount(), 16u);
    // Quadratic splines begin between their points.
    EXPECT_NEAR(scene.meshes.at(1).data->positions.at(0).x, 0.5f, 0.6f);
    const MeshData cubic = meshOf(
        R"(Shape "curve" "string basis" "bspline" "float width" 0.001 "point3 P" [0 0 0 6 0 0 12 0 0 18 0 0])");
    expectNear(cubic.positions.at(0), Vec3(6, 0, 0), 1e-2f);
    expectNear(cubic.positions.back(), Vec3(12, 0, 0), 1e-2f);
    EXPECT_THAT(errorOf("Shape \"curve\" \"point3 P\" [0 0 0 1 0 0]"),
                HasSubstr("the curve has 2 points; expected 4"));
}

TEST_F(PbrtShapesTest, FlattenedShapesAreLeftOut) {
    const SceneDescription scene = load("Shape \"sphere\" Scale 1 0 1 Shape \"sphere\" Shape \"cylinder\"");
    EXPECT_EQ(scene.objects.size(), 1u);
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("flattened")));
    EXPECT_THAT(errorOf("Shape \"klein bottle\""),
                HasSubstr("bad.pbrt:3:1: Glint has no shape \"klein bottle\""));
}

TEST_F(PbrtShapesTest, AlphaCutsOut) {
    const SceneDescription scene = load(R"(Shape "sphere" "float alpha" 0.25 Shape "sphere"
Texture "t" "float" "checkerboard" Shape "sphere" "texture alpha" "t")");
    ASSERT_EQ(scene.materials.size(), 3u);
    EXPECT_FLOAT_EQ(scene.materials[0].opacity.value, 0.25f);
    EXPECT_FLOAT_EQ(scene.materials[1].opacity.value, 1.0f);
    EXPECT_EQ(scene.materials[2].opacity.texture, 0);
}

}  // namespace
}  // namespace glint::test
