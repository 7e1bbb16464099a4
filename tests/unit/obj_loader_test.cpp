// OBJ and MTL files as they are written in the wild.
#include "engine/io/obj_loader.h"

#include <chrono>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "engine/math/color.h"
#include "engine/scene/mesh_area.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::TempFolder;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

MeshFile load(const TempFolder& folder, const std::string& text) {
    Result<MeshFile> scene = loadObj(folder.write("in.obj", text));
    EXPECT_TRUE(scene) << scene.error().format();
    return scene ? std::move(scene).value() : MeshFile{};
}

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ObjLoader, PlainTriangleHasOnlyPositions) {
    const TempFolder folder;
    const MeshFile scene = load(folder, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    ASSERT_EQ(scene.parts.size(), 1u);
    const MeshData& mesh = *scene.parts[0].mesh;
    EXPECT_THAT(mesh.positions, ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2));
    EXPECT_TRUE(mesh.normals.empty() && mesh.uvs.empty() && mesh.colors.empty());
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST(ObjLoader, OddButValidText) {
    const TempFolder folder;
    const char* forms[] = {
        "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",                         // CRLF
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",                                   // no newline at the end
        "  v\t0 0   0 \n\n \t v 1 0 0\nv 0 1 0  \n   f  1  2  3  \n",           // blanks
        "# c\nv 0 0 0 # here\nv 1 0 0\nv 0 1 0\n#f 9 9 9\nf 1 2 3 # done",      // comments
        "# a path that ends in C:\\dir\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",  // a comment joins nothing
        "v 0 \\\n0 0\nv 1 0 0\nv 0 1 \\\r\n 0\nf 1 \\\n 2 \\\n 3\n",            // continuations
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n",                              // counted from the end
        "\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",                     // byte order mark
        "v 0e0 -0 +0\nv 1. 0 0\nv 0 1E+0 .0\nf 1 2 3\n",                        // number forms
        "v 0 0 1e-50\nv 1 0 0 1\nv 0 1 0 1.0\ns off\ng\nf 1 2 3\n",             // underflow, w, smoothing
    };
    for (const char* text : forms) {
        const MeshFile scene = load(folder, text);
        ASSERT_EQ(scene.parts.size(), 1u) << text;
        EXPECT_THAT(scene.parts[0].mesh->positions, ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)))
            << text;
        EXPECT_THAT(scene.parts[0].mesh->indices, ElementsAre(0, 1, 2)) << text;
    }
}

TEST(ObjLoader, CornersOfAllFormsAreJoinedByAllThreeNumbers) {
    const TempFolder folder;
    const MeshFile scene =
        load(folder, std::string(kSquare) +
                         "vt 0.25 0.75\nvt 1 1 0\nvn 0 0 2\nvn 1 0 0\n"
                         "f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/2/1\nf 1 2/1 3//2\nf 1/-2/-2 2/1/1 4/2/1\n");
    const MeshData& mesh = *scene.parts[0].mesh;
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3, 4, 5, 6, 0, 1, 3));
    ASSERT_EQ(mesh.positions.size(), 7u);
    ASSERT_EQ(mesh.normals.size(), 7u);
    ASSERT_EQ(mesh.uvs.size(), 7u);
    EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 2));
    EXPECT_EQ(mesh.normals[5], Vec3(0, 0, 0));  // none given: the face's
    EXPECT_EQ(mesh.normals[6], Vec3(1, 0, 0));
    EXPECT_EQ(mesh.uvs[0], Vec2(0.25f, 0.75f));
    EXPECT_EQ(mesh.uvs[4], Vec2(0, 0));
}

TEST(ObjLoader, VertexColors) {
    const TempFolder folder;
    const MeshFile scene = load(folder, "v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_THAT(scene.parts[0].mesh->colors, ElementsAre(Vec3(1), Vec3(1, srgbToLinear(0.5f), 0), Vec3(1)));
}

TEST(ObjLoader, PolygonsKeepTheirArea) {
    const TempFolder folder;
    const MeshFile quad = load(folder, std::string(kSquare) + "f 1 2 3 4\n");
    EXPECT_EQ(quad.parts[0].mesh->triangleCount(), 2u);
    EXPECT_DOUBLE_EQ(areaOf(*quad.parts[0].mesh), 1.0);
    const MeshFile concave =
        load(folder,
             "v 0 0 0\nv 0 0 6\nv 0 4 6\nv 0 4 4\nv 0 2 4\nv 0 2 2\nv 0 4 2\nv 0 4 0\nf 1 2 3 4 5 6 7 8\n");
    EXPECT_EQ(concave.parts[0].mesh->triangleCount(), 6u);
    EXPECT_DOUBLE_EQ(areaOf(*concave.parts[0].mesh), 20.0);
}

TEST(ObjLoader, PartsAreRunsOfOneMaterial) {
    const TempFolder folder;
    folder.write(
        "m.mtl",
        "newmtl red\nKd 1 0 0\nnewmtl unused\nKd 0 0 1\nmap_Kd no_such.png\nnewmtl two words\nKd 0 1 0\n");
    const MeshFile scene =
        load(folder, std::string("mtllib m.mtl\n") + kSquare +
                         "g first\nusemtl red\nf 1 2 3\ng second\nf 1 3 4\nusemtl two words\no third\n"
                         "f 1 2 4\nusemtl unused\nusemtl red\nf 2 3 4\n");
    ASSERT_EQ(scene.parts.size(), 3u);
    EXPECT_EQ(scene.parts[0].name, "first");
    EXPECT_EQ(scene.parts[0].mesh->triangleCount(), 2u);
    EXPECT_EQ(scene.parts[1].name, "third");
    EXPECT_EQ(scene.parts[2].material, 0);
    ASSERT_EQ(scene.materials.size(), 2u);  // nothing is loaded that no face uses
    EXPECT_EQ(scene.materials[0].color.value, Vec3(1, 0, 0));
    EXPECT_EQ(scene.materials[1].name, "two words");
    EXPECT_THAT(scene.warnings, IsEmpty());

    const auto joined = joinParts(scene.parts);
    EXPECT_EQ(joined->triangleCount(), 4u);
    EXPECT_DOUBLE_EQ(areaOf(*joined), 2.0);
}

TEST(ObjLoader, JoinedPartsFillWhatSomeLack) {
    const TempFolder folder;
    const MeshFile scene =
        load(folder, std::string(kSquare) + "vn 0 0 1\nf 1 2 3\nusemtl a\nf 1//1 3//1 4//1\n");
    ASSERT_EQ(scene.parts.size(), 2u);
    EXPECT_TRUE(scene.parts[0].mesh->normals.empty());
    const auto joined = joinParts(scene.parts);
    EXPECT_THAT(joined->normals,
                ElementsAre(Vec3(0), Vec3(0), Vec3(0), Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)));
    EXPECT_THAT(joined->indices, ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(ObjLoader, WhatIsMissingIsReportedAndReplaced) {
    const TempFolder folder;
    folder.write("m.mtl", "newmtl wood\nKd 0.1 0.2 0.3\nmap_Kd planks.png\nrefl bumps.png\n");
    const MeshFile scene =
        load(folder, std::string("mtllib m.mtl\nmtllib none.mtl\n") + kSquare +
                         "usemtl wood\nf 1 2 3\nusemtl wod\nf 1 3 4\nl 1 2\nl 2 3\nwhatever 1\n");
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("in.obj: material files are missing: \"none.mtl\"")));
    EXPECT_THAT(scene.warnings, Contains(testing::AllOf(HasSubstr("m.mtl:3: images are missing"),
                                                        HasSubstr("\"planks.png\""))));
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("m.mtl:4: maps of kinds that Glint does not draw")));
    EXPECT_THAT(scene.warnings, Contains(testing::AllOf(HasSubstr("in.obj:9"), HasSubstr("not defined"),
                                                        HasSubstr("'wood'"), HasSubstr("\"wod\""))));
    EXPECT_THAT(scene.warnings,
                Contains(testing::AllOf(HasSubstr("in.obj:11: statements that Glint does not draw"),
                                        HasSubstr("\"l\" (and 1 more)"))));
    EXPECT_THAT(scene.warnings,
                Contains(testing::AllOf(HasSubstr("in.obj:13: "), HasSubstr("\"whatever\""))));
    EXPECT_EQ(scene.warnings.size(), 6u);
    EXPECT_EQ(scene.materials[0].color.value, Vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(scene.materials[1].kind, MaterialKind::Diffuse);
}

TEST(ObjLoader, TexturesAreNamedOnceWithTheirScaleAndNotRead) {
    const TempFolder folder;
    ASSERT_TRUE(savePng(folder.path("a b.png"), {2, 1, {255, 0, 0, 0, 255, 0}}));
    folder.write(
        "m.mtl",
        "newmtl a\nmap_Kd a b.png\nnewmtl b\nmap_Kd .\\a b.png\nnewmtl c\nmap_Kd -s 2 3 1 a b.png\n");
    const MeshFile scene =
        load(folder, std::string("mtllib m.mtl\n") + kSquare +
                         "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl c\nf 1 2 3\nusemtl a\nf 1 2 3\n");
    ASSERT_EQ(scene.materials.size(), 3u);
    EXPECT_EQ(scene.materials[0].color.texture, 0);
    EXPECT_EQ(scene.textures[0].encoding, ColorEncoding::Srgb);
    EXPECT_EQ(pathOf(scene.textures[0].image.source), folder.path("a b.png"));
    EXPECT_FALSE(scene.textures[0].image.isRead());
    EXPECT_EQ(scene.textures.back().scale, Vec2(2, 3));
    EXPECT_THAT(scene.warnings, IsEmpty());
}

/// The material that a few MTL lines make.
Material materialOf(const std::string& lines) {
    const TempFolder folder;
    folder.write("m.mtl", "newmtl it\n" + lines);
    const MeshFile scene = load(folder, std::string("mtllib m.mtl\n") + kSquare + "usemtl it\nf 1 2 3\n");
    return scene.materials.empty() ? Material{} : scene.materials[0];
}

TEST(MtlLoader, MapsToGlintMaterials) {
    const Material diffuse = materialOf("Kd 0.2 0.4 0.6\nKs 0 0 0\nNs 10\nillum 2\n");
    EXPECT_EQ(diffuse.kind, MaterialKind::Diffuse);
    EXPECT_EQ(diffuse.color.value, Vec3(0.2f, 0.4f, 0.6f));
    EXPECT_EQ(materialOf("Ka 1 1 1\n").color.value, Vec3(0.5f));
    EXPECT_EQ(materialOf("Kd 0.5 0.5 0.5\nKs 1 1 1\nillum 1\n").kind, MaterialKind::Diffuse);

    const Material plastic = materialOf("Kd 0.5 0.1 0.1\nKs 0.5 0.5 0.5\nNs 198\nNi 1.4\nillum 2\n");
    EXPECT_EQ(plastic.kind, MaterialKind::Plastic);
    EXPECT_FLOAT_EQ(plastic.ior.value, 1.4f);
    EXPECT_FLOAT_EQ(plastic.roughness.value, 0.1f);

    const Material metal = materialOf("Kd 0 0 0\nKs 0.9 0.6 0.3\nNs 48\nillum 2\n");
    EXPECT_EQ(metal.kind, MaterialKind::Conductor);
    EXPECT_TRUE(metal.metal.empty());
    for (int c = 0; c < 3; ++c) {  // Fresnel reflectance at normal incidence
        const float n = metal.eta.value[c];
        const float k = metal.k.value[c];
        const float r = ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
        EXPECT_NEAR(r, (Vec3(0.9f, 0.6f, 0.3f)[c]), 1e-5f);
    }
    const Material mirror = materialOf("Kd 0 0 0\nKs 0.9 0.9 0.9\nillum 3\n");
    EXPECT_EQ(mirror.kind, MaterialKind::Mirror);
    EXPECT_EQ(mirror.color.value, Vec3(0.9f));

    const Material glass = materialOf("Kd 1 1 1\nNi 1.6\nd 0.1\nillum 7\n");
    EXPECT_EQ(glass.kind, MaterialKind::Dielectric);
    EXPECT_FLOAT_EQ(glass.ior.value, 1.6f);
    EXPECT_FALSE(glass.thin);
    EXPECT_EQ(glass.color.value, Vec3(1.0f));
    EXPECT_TRUE(materialOf("Kd 1 1 1\nTr 0.9\n").thin);
    EXPECT_EQ(materialOf("Kd 1 1 1\nTf 0.5 1 1\nd 0\nNi 1.5\n").color.value, Vec3(0.5f, 1.0f, 1.0f));
    EXPECT_EQ(materialOf("Kd 1 1 1\nd 0.9\n").kind, MaterialKind::Diffuse);

    const Material emitter = materialOf("Kd 0 0 0\nKe 10 8 6\n");
    EXPECT_TRUE(emitter.emissive());
    EXPECT_TRUE(emitter.emitsBothSides);
    EXPECT_EQ(emitter.emission.value, Vec3(10, 8, 6));
}

TEST(ObjLoader, HalfAMillionTrianglesAreTimed) {
    constexpr int kSide = 500;
    std::string text;
    for (int i = 0; i <= kSide; ++i) {
        for (int j = 0; j <= kSide; ++j) {
            text += fmt::format("v {:.6f} {:.6f} {:.6f}\nvn 0 1 0\n", i / 500.0,
                                0.001 * ((i * 7 + j * 13) % 100), j / 500.0);
        }
    }
    for (int i = 0; i < kSide; ++i) {
        for (int j = 1; j <= kSide; ++j) {
            const int a = i * (kSide + 1) + j;
            text += fmt::format("f {0}//{0} {1}//{1} {2}//{2} {3}//{3}\n", a, a + 1, a + kSide + 2,
                                a + kSide + 1);
        }
    }
    const TempFolder folder;
    const std::string path = folder.write("large.obj", text);
    const auto begin = std::chrono::steady_clock::now();
    const Result<MeshFile> scene = loadObj(path);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    ASSERT_TRUE(scene) << scene.error().format();
    EXPECT_EQ(scene->parts[0].mesh->triangleCount(), 500000u);
    EXPECT_EQ(scene->parts[0].mesh->positions.size(), 251001u);
    fmt::print("{:.1f} MB, 500000 triangles: {:.3f} s\n", 1e-6 * static_cast<double>(text.size()),
               seconds.count());
}

}  // namespace
}  // namespace glint
