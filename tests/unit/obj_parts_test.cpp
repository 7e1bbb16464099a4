// OBJ files of very many parts: runs of faces that change their material again and again, and materials that
// nothing defines.
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/obj_loader.h"
#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n";

/// So many runs of a triangle, of materials a and b in turn; those of a have texture coordinates, those of b
/// no smoothing.
std::string runsInTurn(size_t runs) {
    std::string text = kSquare;
    for (size_t i = 0; i < runs; ++i) {
        text += i % 2 == 0 ? "usemtl a\ns 1\nf 1/1 2/2 3/3\n" : "usemtl b\ns off\nf 1 3 4\n";
    }
    return text;
}

TEST(ObjParts, RunsStayPartsUpToALimit) {
    const auto file = parseObj(runsInTurn(kMostSeparateParts), "a.obj");
    ASSERT_TRUE(file);
    EXPECT_EQ(file->parts.size(), kMostSeparateParts);
    EXPECT_THAT(file->notes, IsEmpty());
}

TEST(ObjParts, MoreRunsAreJoinedByTheirMaterials) {
    const auto file = parseObj(runsInTurn(kMostSeparateParts + 2), "a.obj");
    ASSERT_TRUE(file);
    ASSERT_EQ(file->parts.size(), 2u);
    EXPECT_THAT(file->notes, ElementsAre(HasSubstr("10002 runs of faces are joined to 2 objects")));
    EXPECT_EQ(file->parts[0].materialName, "a");
    EXPECT_EQ(file->parts[1].materialName, "b");
    const MeshData& a = *file->parts[0].mesh;
    EXPECT_EQ(a.triangleCount(), kMostSeparateParts / 2 + 1);
    EXPECT_EQ(a.positions.size(), a.uvs.size());
    EXPECT_EQ(a.positions[a.indices.back()], Vec3(1, 1, 0));
    EXPECT_EQ(a.uvs[a.indices.back()], Vec2(1, 1));
    const MeshData& b = *file->parts[1].mesh;
    EXPECT_EQ(b.triangleCount(), kMostSeparateParts / 2 + 1);
    EXPECT_EQ(b.positions[b.indices.back()], Vec3(0, 1, 0));
    EXPECT_THAT(b.uvs, IsEmpty());
    for (const SmoothingRun& run : file->parts[1].smoothing) {
        EXPECT_EQ(run.group, Smoothing::Off);
    }
    EXPECT_EQ(file->parts[1].smoothing.back().firstTriangle, kMostSeparateParts / 2);
}

TEST(ObjParts, OfVeryManyMaterialsThatNoLibraryDefinesAreOne) {
    std::string text = kSquare;
    for (size_t i = 0; i <= kMostSeparateParts; ++i) {
        text += fmt::format("usemtl m{}\nf 1 2 3\n", i);
    }
    const auto file = parseObj(text + "v 2 0 0 1 0 0\nusemtl red\nf 5 5 1\nf 2 3 5\n", "a.obj");
    ASSERT_TRUE(file);
    EXPECT_THAT(file->notes, ElementsAre(HasSubstr("10002 runs of faces are joined to 2 objects")));
    ASSERT_EQ(file->parts.size(), 2u);
    EXPECT_EQ(file->parts[0].mesh->triangleCount(), kMostSeparateParts + 1);
    EXPECT_THAT(file->parts[0].mesh->colors, IsEmpty());
    EXPECT_FALSE(file->parts[1].mesh->colors.empty());
}

/// An OBJ file that names a.mtl, with so many runs of a triangle, of a material each.
std::string ofAMaterialEach(size_t runs) {
    std::string text = std::string("mtllib a.mtl\n") + kSquare;
    for (size_t i = 0; i < runs; ++i) {
        text += fmt::format("usemtl m{}\nf 1 2 3\n", i);
    }
    return text;
}

SceneDescription opened(const std::string& path) {
    auto scene = loadScene(path, {.noStudio = true});
    EXPECT_TRUE(scene) << scene.error().format();
    return scene ? std::move(*scene) : SceneDescription();
}

/// The first is another one but for its capital.
TEST(ObjParts, OfAMaterialEachStayApart) {
    const test::TempFolder folder;
    std::string library = "newmtl M0\n";
    for (size_t i = 1; i <= kMostSeparateParts; ++i) {
        library += fmt::format("newmtl m{}\n", i);
    }
    folder.write("a.mtl", library);
    const SceneDescription scene = opened(folder.write("a.obj", ofAMaterialEach(kMostSeparateParts + 1)));
    EXPECT_EQ(scene.objects.size(), kMostSeparateParts + 1);
    EXPECT_EQ(scene.meshes.back().name, fmt::format("m{}", kMostSeparateParts));
}

TEST(ObjParts, OfVeryManyMaterialsThatTheLibraryLacksAreOne) {
    const test::TempFolder folder;
    folder.write("a.mtl", "newmtl m7\nKd 1 0 0\n");
    const std::string text = ofAMaterialEach(kMostSeparateParts + 1);
    const SceneDescription scene = opened(folder.write("a.obj", text));
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.meshes[0].data->triangleCount(), kMostSeparateParts);
    EXPECT_EQ(scene.materials[static_cast<size_t>(scene.objects[1].material)].name, "m7");
    EXPECT_THAT(scene.notes, testing::Contains(HasSubstr("10001 runs of faces are joined to 2 objects")));
    // Scenes of ours name parts by number, and read a file without its materials.
    const auto alone = parseObj(text, folder.path("a.obj"));
    ASSERT_TRUE(alone);
    EXPECT_EQ(alone->parts.size(), 2u);
}

/// A thousand materials that are not defined can be told apart; the others are one.
TEST(ObjParts, OfManyMaterialsWithoutALibraryStayApart) {
    const test::TempFolder folder;
    const SceneDescription scene = opened(folder.write("a.obj", ofAMaterialEach(2000)));
    EXPECT_EQ(scene.objects.size(), 2000u);
    EXPECT_EQ(scene.materials.size(), 1001u);
    EXPECT_EQ(scene.materials[999].name, "m999");
    EXPECT_EQ(scene.objects.back().material, 1000);
    EXPECT_EQ(scene.objects[1000].material, 1000);
    EXPECT_THAT(scene.warnings, testing::Contains(HasSubstr("\"m0\" (and 1999 more)")));
}

}  // namespace
}  // namespace glint
