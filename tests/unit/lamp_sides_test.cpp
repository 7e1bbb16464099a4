// Lamps of OBJ files shine away from a wall close behind them and out of closed bodies, and on both
// sides otherwise.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::TempFolder;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kCeiling = "v -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\nusemtl wall\nf 1 2 3 4\n";

std::string square(double y) {
    std::string text;
    for (const char* corner : {"-.25 {} -.25", ".25 {} -.25", ".25 {} .25", "-.25 {} .25"}) {
        std::string line = corner;
        text += "v " + line.replace(line.find("{}"), 2, std::to_string(y)) + "\n";
    }
    return text;
}

/// The lamp's side: where the normal of its first triangle points, or nothing where both shine.
struct Lamp {
    bool bothSides = true;
    Vec3 normal;
    std::vector<std::string> notes;
};

Lamp lampOf(const std::string& obj) {
    const TempFolder folder;
    folder.write("m.mtl", "newmtl wall\nKd .5 .5 .5\nnewmtl lamp\nKd 0 0 0\nKe 5 5 5\n");
    const auto scene = loadScene(folder.write("in.obj", "mtllib m.mtl\n" + obj));
    EXPECT_TRUE(scene) << scene.error().format();
    if (!scene) { return {}; }
    for (const Object& object : scene->objects) {
        const Material& material = scene->materials[static_cast<size_t>(object.material)];
        if (!material.emissive()) { continue; }
        const MeshData& mesh = *scene->meshes[static_cast<size_t>(object.mesh)].data;
        const Vec3& a = mesh.positions[mesh.indices[0]];
        const Vec3 normal =
            glm::cross(mesh.positions[mesh.indices[1]] - a, mesh.positions[mesh.indices[2]] - a);
        return {material.emitsBothSides, glm::normalize(normal), scene->notes};
    }
    return {};
}

TEST(LampSides, AwayFromAWallCloseBehind) {
    for (const char* face : {"usemtl lamp\nf 5 6 7 8\n", "usemtl lamp\nf 8 7 6 5\n"}) {
        const Lamp lamp = lampOf(kCeiling + square(1.99) + face);
        EXPECT_FALSE(lamp.bothSides);
        EXPECT_EQ(lamp.normal, Vec3(0, -1, 0));
        EXPECT_THAT(lamp.notes, testing::ElementsAre(HasSubstr("shine on their outer side alone: lamp")));
    }
}

TEST(LampSides, AQuarterOfTheirSizeBelowAWall) {
    for (const double y : {1.95, 1.94, 1.9}) {
        EXPECT_FALSE(lampOf(kCeiling + square(y) + "usemtl lamp\nf 5 6 7 8\n").bothSides) << y;
    }
    EXPECT_TRUE(lampOf(kCeiling + square(1.8) + "usemtl lamp\nf 5 6 7 8\n").bothSides);
}

TEST(LampSides, LampsOfOneMaterialAreDecidedOneByOne) {
    const TempFolder folder;
    folder.write("m.mtl", "newmtl wall\nKd .5 .5 .5\nnewmtl lamp\nKe 5 5 5\n");
    const auto scene = loadScene(folder.write(
        "in.obj", "mtllib m.mtl\n" + kCeiling + square(1.99) + "usemtl lamp\nf 5 6 7 8\n" + "usemtl wall\n" +
                      square(-5.0) + "f 9 10 11\nusemtl lamp\n" + square(1.0) + "f 13 14 15 16\n"));
    ASSERT_TRUE(scene) << scene.error().format();
    std::vector<std::pair<std::string, bool>> lamps;
    for (const Object& object : scene->objects) {
        const Material& material = scene->materials[static_cast<size_t>(object.material)];
        if (material.emissive()) { lamps.emplace_back(material.name, material.emitsBothSides); }
    }
    EXPECT_THAT(lamps,
                testing::ElementsAre(testing::Pair("lamp (outer side)", false), testing::Pair("lamp", true)));
}

TEST(LampSides, BothWhereNothingOrNotAllIsBehind) {
    const Lamp low = lampOf(kCeiling + square(1.5) + "usemtl lamp\nf 5 6 7 8\n");
    EXPECT_TRUE(low.bothSides);
    EXPECT_THAT(low.notes, IsEmpty());
    EXPECT_TRUE(lampOf(kCeiling + square(1.99) +
                       "v 3 1.99 0\nv 4 1.99 0\nv 4 1.99 1\nusemtl lamp\nf 5 6 7 8\nf 9 10 11\n")
                    .bothSides);  // a part of it stands free
    EXPECT_TRUE(lampOf(kCeiling + square(1.99) +
                       "v -1 1.98 -1\nv 1 1.98 -1\nv 1 1.98 1\nv -1 1.98 1\nf 9 10 11 12\n"
                       "usemtl lamp\nf 5 6 7 8\n")
                    .bothSides);  // between two walls
}

TEST(LampSides, OutOfClosedBodies) {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl lamp\n";
    const Lamp outwards = lampOf(corners + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    EXPECT_FALSE(outwards.bothSides);
    EXPECT_EQ(outwards.normal, Vec3(0, 0, -1));
    const Lamp inwards = lampOf(corners + "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
    EXPECT_FALSE(inwards.bothSides);
    EXPECT_EQ(inwards.normal, Vec3(0, 0, -1));
    EXPECT_TRUE(lampOf(corners + "f 1 3 2\nf 1 2 4\nf 1 4 3\n").bothSides);  // open
    EXPECT_TRUE(lampOf(corners + "f 1 2 3\nf 1 3 2\n").bothSides);           // a sheet with two skins
}

}  // namespace
}  // namespace glint
