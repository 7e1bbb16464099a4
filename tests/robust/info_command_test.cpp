// `glint info` as its users meet it: what a scene names in vain, scenes with nothing in them, files that
// are none.
#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/io/image_io.h"
#include "tests/support/run_program.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::TempFolder;
using Json = nlohmann::json;

class InfoCommand : public testing::Test {
  protected:
    void SetUp() override {
        if (!test::programExists()) { GTEST_SKIP() << "the program was not built"; }
    }
    static Json reportOf(const std::string& scene) {
        return Json::parse(runProgram({"info", scene, "--json", "-"}).out, nullptr, false);
    }
    TempFolder folder;
};

testing::AssertionResult says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos
               ? testing::AssertionSuccess()
               : testing::AssertionFailure() << "'" << part << "' is not in: " << text;
}

const Json* rowOf(const Json& report, const std::string& part) {
    for (const Json& row : report["memory"]["parts"]) {
        if (row["part"] == part) { return &row; }
    }
    return nullptr;
}

constexpr const char* kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "property float u\nproperty float v\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n";

TEST_F(InfoCommand, WhatIsNamedInVainIsListedWithWhatItWouldTake) {
    ASSERT_TRUE(savePng(folder.path("wood.png"), {64, 32, std::vector<uint8_t>(64 * 32 * 3, 9)}));
    folder.write("leaf.ply", kPly);
    folder.write("tree.ply", "anything");
    const std::string scene = folder.write("vain.json", R"({"glint": 1, "resolution": [32, 32],
      "textures": {"wood": {"file": "wood.png"}, "gone": {"file": "gone.png"}},
      "materials": {"grey": {"type": "diffuse"}},
      "meshes": {"leaf": {"file": "leaf.ply"}, "tree": {"file": "tree.ply"}},
      "objects": [{"type": "mesh", "mesh": "leaf", "material": "grey"}],
      "lights": [{"type": "point", "position": [0, 0, 2]}],
      "environment": {"strength": 0, "image": {"generator": "sky", "width": 64}}})");
    const ProgramRun text = runProgram({"info", scene, "--memory"});
    ASSERT_EQ(text.exitCode, 0) << text.err;
    EXPECT_TRUE(says(text.out, "meshes     2, 1 of them placed, with 1 triangle, 1 as placed\n"));
    EXPECT_TRUE(says(text.out, "textures   2, 0 of them used\n"));
    EXPECT_TRUE(says(text.out, "not read   mesh 'tree' tree.ply (8 B): no object places it\n"));
    EXPECT_TRUE(says(text.out, "           texture 'wood' wood.png ("));
    EXPECT_TRUE(says(text.out, "           texture 'gone' gone.png: the file is missing\n"));
    EXPECT_TRUE(
        says(text.out, "           environment image 'sky': the environment does not shine with it\n"));
    EXPECT_TRUE(says(text.out, "\"gone.png\" is missing; nothing uses it"));
    EXPECT_EQ(text.out.find("held unused"), std::string::npos) << "an empty column says nothing";

    const Json report = reportOf(scene);
    EXPECT_EQ(report["placed_meshes"], 1);
    EXPECT_EQ(report["used_textures"], 0);
    ASSERT_EQ(report["not_read"].size(), 4u);
    EXPECT_EQ(report["not_read"][1]["memory_bytes"], 64 * 32 * 3);
    EXPECT_TRUE(report["not_read"][0]["memory_bytes"].is_null());
    EXPECT_TRUE(report["not_read"][2]["file_bytes"].is_null());
    EXPECT_EQ(report["memory"]["held_unused_bytes"], 0);
    const Json* textures = rowOf(report, "textures");
    ASSERT_TRUE(textures);
    EXPECT_EQ((*textures)["used_bytes"], 0);
    EXPECT_EQ((*textures)["not_allocated_bytes"], 64 * 32 * 3);
    const Json* shading = rowOf(report, "normals, texture coordinates, vertex colours");
    ASSERT_TRUE(shading);
    EXPECT_EQ((*shading)["not_allocated_bytes"], 3 * 8);
    const Json* environment = rowOf(report, "environment image and its distribution");
    ASSERT_TRUE(environment);
    EXPECT_EQ((*environment)["not_allocated_bytes"], 64 * 32 * 3 * 4);

    // Converting keeps all of it.
    const std::string copy = folder.path("copy.json");
    ASSERT_EQ(runProgram({"convert", scene, copy}).exitCode, 0);
    EXPECT_EQ(reportOf(copy)["not_read"], report["not_read"]);
}

TEST_F(InfoCommand, WhatStandsInTheSceneFileIsHeld) {
    const std::string scene = folder.write("inline.json", R"({"glint": 1,
      "materials": {"grey": {"type": "diffuse"}},
      "meshes": {"idle": {"positions": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "triangles": [[0, 1, 2]]}},
      "objects": [{"type": "mesh", "material": "grey", "mesh": {"positions": [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
                   "uvs": [[0, 0], [1, 0], [0, 1]], "triangles": [[0, 1, 2]]}}]})");
    const ProgramRun text = runProgram({"info", scene, "--memory"});
    EXPECT_TRUE(says(text.out, "held unused"));
    EXPECT_TRUE(says(text.out, "lights     none: the picture is black"));
    EXPECT_EQ(reportOf(scene)["memory"]["held_unused_bytes"], 3 * 12 + 3 * 4 + 3 * 8);
}

TEST_F(InfoCommand, AllReadableScenesAreReportedWithinATerminalsWidth) {
    folder.write("leaf.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("leaf.ply", kPly);
    folder.write("bare.json", "{\"glint\": 1}");
    folder.write("ball.txt", "Group { numObjects 1 Sphere { center 0 0 0 radius 1 } }");
    std::vector<std::string> scenes;
    for (const char* name : {"leaf.obj", "leaf.ply", "bare.json", "ball.txt"}) {
        scenes.push_back(folder.path(name));
    }
    for (const char* name : {"cornell", "many_lights", "sppm_glass_sphere"}) {
        scenes.push_back(std::string(GLINT_SOURCE_DIR) + "/scenes/" + name + ".json");
    }
    for (const std::string& scene : scenes) {
        SCOPED_TRACE(scene);
        const ProgramRun text = runProgram({"info", scene, "--memory"});
        ASSERT_EQ(text.exitCode, 0) << text.err;
        EXPECT_TRUE(text.err.empty()) << text.err;
        std::istringstream lines(text.out);
        for (std::string line; std::getline(lines, line);) {
            EXPECT_TRUE(line.size() <= 125 || line.starts_with("warning")) << line;
        }
        EXPECT_FALSE(reportOf(scene).is_discarded());
    }
    EXPECT_TRUE(says(runProgram({"info", folder.path("bare.json")}).out, "objects    none"));
}

TEST_F(InfoCommand, FilesThatAreNoScenesAreRefusedInOneLine) {
    const std::pair<const char*, const char*> files[] = {{"empty.json", "is empty; expected a scene"},
                                                         {"vertices.obj", "the file has no faces"},
                                                         {"cut.ply", "expected"},
                                                         {"noise.bin", "is not a scene Glint knows"}};
    folder.write("empty.json", "");
    folder.write("vertices.obj", "v 0 0 0\n");
    folder.write("cut.ply", std::string(kPly).substr(0, 180));
    folder.write("noise.bin", std::string("\x01\x02\x00\xff", 4));
    for (const auto& [name, message] : files) {
        const ProgramRun run = runProgram({"info", folder.path(name), "--memory"});
        EXPECT_EQ(run.exitCode, 1) << name;
        EXPECT_TRUE(run.out.empty()) << name << ": " << run.out;
        EXPECT_TRUE(says(run.err, message)) << name;
        EXPECT_TRUE(run.err.starts_with("error: " + folder.path(name))) << run.err;
    }
}

}  // namespace
}  // namespace glint
