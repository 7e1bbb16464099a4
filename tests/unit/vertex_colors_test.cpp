// Vertex colours of OBJ and PLY mean the same, in all ranges that programs write, and are the albedo.
#include "engine/io/vertex_colors.h"

#include <gtest/gtest.h>

#include "engine/io/scene_loader.h"
#include "engine/math/color.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::TempFolder;

TEST(VertexColors, MeanTheSameInBothFormatsAndRanges) {
    const TempFolder folder;
    const auto colorOf = [&](const char* name, const std::string& text) {
        const auto scene = loadScene(folder.write(name, text), {.noStudio = true});
        EXPECT_TRUE(scene && scene->materials.size() == 1u) << text;
        return scene ? scene->materials[0].color.value * scene->meshes[0].data->colors.at(0) : Vec3(-1.0f);
    };
    const auto obj = [](const std::string& color) {
        std::string text;
        for (const char* corner : {"-1 -1 0 ", "1 -1 0 ", "1 1 0 ", "-1 1 0 "}) {
            text += "v " + (corner + color) + "\n";
        }
        return text + "f 1 2 3 4\n";
    };
    const auto ply = [](const std::string& type, const std::string& color) {
        std::string text =
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
        for (const char* name : {"red", "green", "blue"}) {
            text += "property " + type + " " + name + "\n";
        }
        text += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
        for (const char* corner : {"-1 -1 0 ", "1 -1 0 ", "1 1 0 ", "-1 1 0 "}) {
            text += corner + color + "\n";
        }
        return text + "4 0 1 2 3\n";
    };
    // ZBrush's, over two lines, in front of the faces and behind them.
    const std::string paint = "#MRGB ffFF3300ffff3300\n#MRGB 00ff3300ffff3300\n", plain = obj("");
    const size_t faces = plain.find("f ");
    const Vec3 expected(1.0f, srgbToLinear(0.2f), 0.0f);
    for (const Vec3& color :
         {colorOf("a.obj", obj("1 0.2 0")), colorOf("a.obj", obj("255 51 0")),
          colorOf("a.obj", obj("1 0.2 0 1")),
          colorOf("a.obj", plain.substr(0, faces) + paint + plain.substr(faces)),
          colorOf("a.obj", plain.substr(faces) + plain.substr(0, faces) + paint),
          colorOf("a.ply", ply("uchar", "255 51 0")), colorOf("a.ply", ply("int", "255 51 0")),
          colorOf("a.ply", ply("ushort", "65535 13107 0")), colorOf("a.ply", ply("float", "1 0.2 0")),
          colorOf("a.ply", ply("float", "255 51 0")), colorOf("a.ply", ply("uchar", "255.0 51.0 0"))}) {
        EXPECT_NEAR(glm::length(color - expected), 0.0f, 1e-5f) << color.x << " " << color.y;
    }
}

TEST(VertexColors, AFewAboveOneAreOverbright) {
    const auto decoded = [](const std::vector<Vec3>& colors) {
        MeshFile file;
        file.parts.emplace_back().mesh = std::make_shared<MeshData>();
        file.parts[0].mesh->colors = colors;
        decodeVertexColors("in.ply", &file);
        return file.parts[0].mesh->colors;
    };
    const float half = srgbToLinear(0.5f);
    for (const Vec3& bright : {Vec3(2.5f, 0.5f, 0.5f), Vec3(3.5f, 0.5f, 1.0f), Vec3(300.0f, 0.5f, 0.25f)}) {
        EXPECT_EQ(decoded({bright})[0].x, 1.0f);
        EXPECT_EQ(decoded({bright})[0].y, half);
    }
    for (const Vec3& integers : {Vec3(255, 127.5f, 0.5f), Vec3(20.5f, 127.5f, 0), Vec3(3, 127.5f, 90)}) {
        EXPECT_EQ(decoded({integers, Vec3(0)})[0].y, srgbToLinear(integers.y / 255.0f));
    }
    EXPECT_EQ(decoded({Vec3(3, 1, 0)})[0].x, srgbToLinear(3.0f / 255.0f));
}

}  // namespace
}  // namespace glint
