// What is glass is decided from d, Tr, Tf, Ni and illum together, by what exporters write for opaque
// materials; PBR keys count where they say something.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/obj_loader.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::TempFolder;
using testing::HasSubstr;
using testing::IsEmpty;

/// The first material of an MTL file that begins with these lines, and what is said of it.
MeshFile loadWith(const std::string& lines) {
    const TempFolder folder;
    folder.write("m.mtl", "newmtl it\n" + lines);
    const auto file =
        loadObj(folder.write("in.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl it\nf 1 2 3\n"));
    EXPECT_TRUE(file) << file.error().format();
    return file ? *file : MeshFile{};
}

Material materialOf(const std::string& lines) { return loadWith(lines).materials.at(0); }

TEST(MtlGlass, OpaqueMaterialsStayOpaque) {
    for (const char* lines : {
             "illum 4\nKd 0.8 0.1 0.1\nKa 0 0 0\nTf 1 1 1\nNi 1\n",         // Maya, of all materials
             "illum 4\nKd 0.8 0.1 0.1\nTf 1.00 1.00 1.00\nNi 1.50\n",       // Maya, with refraction set
             "illum 4\nKd 0.8 0.1 0.1\nTf 1\n",                             //
             "illum 9\nKd 0.8 0.1 0.1\nTf 1 1 1\nNi 1\n",                   //
             "illum 7\nKd 0.8 0.1 0.1\nTf 1 1 1\nNi 1\n",                   //
             "illum 4\nKd 0.8 0.1 0.1\nd 1\nNi 1.45\n",                     // Blender
             "illum 4\nKd 0.8 0.1 0.1\nd 1\nTf 0 0 0\n",                    //
             "illum 6\nKd 0.8 0.1 0.1\nTr 0\nd 1\nNi 1\n",                  //
             "Kd 0.8 0.1 0.1\nTr 1\n",                                      // Tr as opacity
             "Kd 0.8 0.1 0.1\nTr 0\n",                                      //
             "Kd 0.8 0.1 0.1\nd 1\nTr 1\n",                                 //
             "Kd 0.8 0.1 0.1\nd 0\nTr 0\n",                                 // contradiction
             "Kd 0.8 0.1 0.1\nTr 0.9\nnewmtl b\nTr 1\nnewmtl c\nTr 1.0\n",  // Tr is opacity in this file
             "Kd 0.8 0.1 0.1\nTf 1 1 1\nNi 1.5\nillum 2\n",                 // 3ds Max
             "Kd 0.8 0.1 0.1\nTf 0 0 0\nillum 2\n",                         //
             "Kd 0.8 0.1 0.1\nd 0.2\nmap_d leaf.png\n",                     // cut out, not glass
             "Kd 0.8 0.1 0.1\nd -1\n",                                      // says nothing
             "illum 4\nKd 0.8 0.1 0.1\nTf xyz 0.9505 1 1.089\nNi 1\n",      // white
         }) {
        const Material material = materialOf(lines);
        EXPECT_EQ(material.kind, MaterialKind::Diffuse) << lines;
        EXPECT_EQ(material.color.value, Vec3(0.8f, 0.1f, 0.1f)) << lines;
    }
}

TEST(MtlGlass, GlassIsGlassAndTheNoteSaysWhy) {
    const std::pair<const char*, const char*> cases[] = {
        {"Kd 1 1 1\nNi 1.6\nd 0.1\nillum 7\n", "it (d 0.1)"},
        {"Kd 1 1 1\nd 0\n", "it (d 0)"},
        {"Kd 1 1 1\nd -halo 0.3\n", "it (d 0.3)"},
        {"Kd 1 1 1\nTr 0.9\n", "it (Tr 0.9)"},
        {"Kd 1 1 1\nTr 0.1\nnewmtl b\nTr 1\n", "it (Tr 0.1)"},
        {"Kd 0.01 0.01 0.01\nKs 0.95 0.95 0.95\nNi 1.5\nd 1\nTr 0\nTf 1 1 1\nillum 7\n",
         "it (illum 7 with Ni 1.5)"},
        {"Kd 1 1 1\nillum 4\nTf 0 0 0\nNi 1\n", "it (illum 4, Tf 0 0 0)"},
        {"Kd 1 1 1\nillum 4\nNi 1.5\n", "it (illum 4)"},
        {"Kd 1 1 1\nillum 9\n", "it (illum 9)"},
        {"Kd 1 1 1\nillum 4\nTf 0.2 0.9 0.2\nNi 1.5\n", "it (illum 4, Tf 0.2 0.9 0.2)"},
    };
    for (const auto& [lines, why] : cases) {
        const MeshFile file = loadWith(lines);
        EXPECT_EQ(file.materials.at(0).kind, MaterialKind::Dielectric) << lines;
        EXPECT_THAT(file.notes,
                    testing::ElementsAre(testing::AllOf(HasSubstr("read as glass"), HasSubstr(why))))
            << lines;
    }
    EXPECT_EQ(materialOf("illum 4\nTf 0.2 0.9 0.2\nNi 1.5\n").color.value, Vec3(0.2f, 0.9f, 0.2f));
    EXPECT_EQ(materialOf("illum 4\nTf 0 0 0\n").color.value, Vec3(1.0f));
}

TEST(MtlGlass, WhatLetsSomeLightPassKeepsItsColour) {
    const std::pair<const char*, float> cases[] = {
        {"Ks .5 .5 .5\nNi 1.45\nd 0.9\nillum 6\n", 0.9f},  // Blender, of metal
        {"Ks .5 .5 .5\nNi 1.45\nd 0.3\nillum 9\n", 0.3f},  // Blender, of all else
        {"d 0.5\nillum 2\n", 0.5f},
        {"d 0.4\nillum 9\n", 0.4f},
        {"d 0.2\n", 0.2f},
        {"Tr 0.6\n", 0.4f},
        {"illum 4\nTf 0.5 0.5 0.5\nNi 1\n", 0.5f},
    };
    for (const auto& [lines, opacity] : cases) {
        const Material material = materialOf(std::string("Kd 0.8 0.1 0.1\n") + lines);
        EXPECT_NE(material.kind, MaterialKind::Dielectric) << lines;
        EXPECT_EQ(material.color.value, Vec3(0.8f, 0.1f, 0.1f)) << lines;
        EXPECT_FLOAT_EQ(material.opacity.value, opacity) << lines;
    }
    const Material metal = materialOf("Kd 0.8 0.1 0.1\nPm 1\nPr 0.3\nNi 1.45\nd 0.2\nillum 6\n");
    EXPECT_EQ(metal.kind, MaterialKind::Conductor);
    EXPECT_FLOAT_EQ(metal.opacity.value, 0.2f);
}

TEST(MtlGlass, WhatCouldHaveBeenGlassIsNoted) {
    EXPECT_THAT(loadWith("illum 4\nTf 1 1 1\nNi 1\n").notes,
                testing::ElementsAre(
                    testing::AllOf(HasSubstr("read as opaque"), HasSubstr("it (illum 4, Tf 1 1 1)"))));
    EXPECT_THAT(loadWith("Tr 1\n").notes, testing::ElementsAre(HasSubstr("it (Tr 1 alone)")));
    EXPECT_THAT(loadWith("Kd 1 1 1\nillum 2\nd 1\n").notes, IsEmpty());
    EXPECT_THAT(loadWith("Kd 1 1 1\nd 0.9\n").warnings, IsEmpty());
    EXPECT_EQ(materialOf("Kd 1 1 1\nd 0.9\n").opacity.value, 0.9f) << "there for as many rays";
}

TEST(MtlPbr, LayersArePrincipled) {
    const Material coated = materialOf("Kd 0.8 0.1 0.1\nPr 0.5\nPm 1\nPc 0.75\nPcr 0.5\nPs 0.25\nNi 1.4\n");
    EXPECT_EQ(coated.kind, MaterialKind::Principled);
    EXPECT_EQ(coated.color.value, Vec3(0.8f, 0.1f, 0.1f));
    EXPECT_EQ(coated.metallic.value, 1.0f);
    EXPECT_EQ(coated.roughness.value, 0.25f);
    EXPECT_EQ(coated.clearcoat.value, 0.75f);
    EXPECT_EQ(coated.clearcoatRoughness.value, 0.25f);
    EXPECT_EQ(coated.sheenColor.value, Vec3(0.25f));
    EXPECT_FLOAT_EQ(coated.ior.value, 1.4f);
    const Material half = materialOf("Kd 0.8 0.1 0.1\nPr 0.5\nPm 0.5\n");
    EXPECT_EQ(half.kind, MaterialKind::Principled);
    EXPECT_EQ(half.metallic.value, 0.5f);
}

TEST(MtlPbr, MetalAndPlasticByPmAndPr) {
    const Material metal = materialOf("Kd 0.8 0.1 0.1\nPr 0.2\nPm 1.0\n");
    EXPECT_EQ(metal.kind, MaterialKind::Conductor);
    EXPECT_FLOAT_EQ(metal.roughness.value, 0.04f);
    for (int c = 0; c < 3; ++c) {
        const float n = metal.eta.value[c], k = metal.k.value[c];
        EXPECT_NEAR(((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k), (Vec3(0.8f, 0.1f, 0.1f)[c]),
                    1e-5f);
    }
    const Material plastic = materialOf("Kd 0.8 0.1 0.1\nKs 0 0 0\nPr 0.5\nPm 0\nNi 1.4\n");
    EXPECT_EQ(plastic.kind, MaterialKind::Plastic);
    EXPECT_FLOAT_EQ(plastic.roughness.value, 0.25f);
    EXPECT_FLOAT_EQ(plastic.ior.value, 1.4f);
    // Keys that are all 0 are what exporters write that do not know the material.
    EXPECT_EQ(materialOf("Kd 0.8 0.1 0.1\nPr 0\nPm 0\nPs 0\nPc 0\nPcr 0\naniso 0\nanisor 0\n").kind,
              MaterialKind::Diffuse);
    EXPECT_EQ(materialOf("Kd 1 1 1\nd 0.1\nPr 0.3\nPm 0\n").kind, MaterialKind::Dielectric);
    // Ke is a factor on an image; where that is missing, the whole model would glow.
    EXPECT_FALSE(materialOf("Kd 1 1 1\nKe 1 1 1\nmap_Ke missing.png\n").emissive());
    EXPECT_THAT(loadWith("Kd 1 1 1\nPr 0.3\naniso 1\nmap_Pr r.png\nnorm n.png\n").warnings,
                testing::UnorderedElementsAre(
                    HasSubstr("images are missing; the material's own colour takes their place: \"r.png\" "
                              "(and 1 more)")));
}

}  // namespace
}  // namespace glint
