// `glint info` as its users meet it: what a scene names in vain, scenes with nothing in them, files that
// are none.
#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/io/image_io.h"
#include "tests/support/gltf_files.h"
#include "tests/support/program_test.h"
#include "tests/support/used_assets.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;
using test::TempFolder;
using Json = nlohmann::json;

class InfoCommand : public test::ProgramTest {
  protected:
    static Json reportOf(const std::string& scene) {
        return Json::parse(runProgram({"info", scene, "--json", "-"}).out, nullptr, false);
    }
};

const std::string kCornell = GLINT_SOURCE_DIR "/scenes/cornell.json";
const std::string kCaustic = GLINT_SOURCE_DIR "/scenes/cornell_glass_mirror.json";

const Json* rowOf(const Json& report, const std::string& part) {
    for (const Json& row : report["memory"]["parts"]) {
        if (row["part"] == part) { return &row; }
    }
    return nullptr;
}

TEST_F(InfoCommand, WhatIsNamedInVainIsListedWithWhatItWouldTake) {
    ASSERT_TRUE(savePng(folder.path("wood.png"), {64, 32, std::vector<uint8_t>(64 * 32 * 3, 9)}));
    folder.write("leaf.ply", test::kLeafPly);
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
    EXPECT_TRUE(says(text.out, "files are missing that nothing uses: \"gone.png\""));
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
    folder.write("leaf.ply", test::kLeafPly);
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
    folder.write("cut.ply", std::string(test::kLeafPly).substr(0, 180));
    folder.write("noise.bin", std::string("\x01\x02\x00\xff", 4));
    for (const auto& [name, message] : files) {
        const ProgramRun run = runProgram({"info", folder.path(name), "--memory"});
        EXPECT_EQ(run.exitCode, 1) << name;
        EXPECT_TRUE(run.out.empty()) << name << ": " << run.out;
        EXPECT_TRUE(says(run.err, message)) << name;
        EXPECT_TRUE(run.err.starts_with("error: " + folder.path(name))) << run.err;
    }
}

TEST_F(InfoCommand, TellsWhatPhotonMappingNeedsAndWhereItGainsNothing) {
    const ProgramRun glass = runProgram({"info", kCaustic});
    EXPECT_TRUE(says(glass.out, "262144 photons a pass"));
    EXPECT_EQ(glass.out.find("gains nothing"), std::string::npos);
    const std::string matt = folder.write(
        "matt.json",
        R"({"glint": 1, "objects": [{"type": "sphere", "material": {"type": "diffuse"}, "radius": 1}]})");
    EXPECT_TRUE(says(runProgram({"info", matt}).out, "gains nothing here"));
    const auto report = Json::parse(runProgram({"info", matt, "--json", "-"}).out, nullptr, false);
    ASSERT_FALSE(report.is_discarded());
    EXPECT_FALSE(report["sppm"]["has_caustic_caster"].get<bool>());
    EXPECT_EQ(report["integrator"], "path");
    EXPECT_LE(report["sppm"]["bytes_per_pixel"].get<int>(), 128);
    EXPECT_LE(report["sppm"]["bytes_per_stored_photon"].get<int>(), 48);
}

TEST_F(InfoCommand, TellsThatInfinitePlanesSendNoPhotons) {
    const auto scene = [&](const char* shape) {
        return folder.write(std::string(shape) + ".json",
                            std::string(R"({"glint": 1, "objects": [{"type": ")") + shape +
                                R"(", "material": {"type": "diffuse", "emission": 1}}]})");
    };
    EXPECT_TRUE(says(runProgram({"info", scene("plane")}).out, "send no photons"));
    EXPECT_EQ(runProgram({"info", scene("disc")}).out.find("send no photons"), std::string::npos);
}

TEST_F(InfoCommand, ReportsWhatIsThereAndWhatIsLeftOut) {
    const ProgramRun text = runProgram({"info", kCornell});
    ASSERT_EQ(text.exitCode, 0) << text.err;
    EXPECT_TRUE(says(text.out, "left out"));
    EXPECT_TRUE(says(text.out, "memory"));
    const auto report = Json::parse(runProgram({"info", kCornell, "--json", "-"}).out, nullptr, false);
    ASSERT_FALSE(report.is_discarded());
    EXPECT_GT(report["memory_total_bytes"].get<uint64_t>(), 0u);
    EXPECT_FALSE(report["kernel"].get<std::string>().empty());
    EXPECT_TRUE(report["left_out"].is_array());
}

/// The table's rows add up, and an integrator moves its parts from "not allocated" to "used".
TEST_F(InfoCommand, MemoryTellsUsedFromNotAllocated) {
    const ProgramRun text = runProgram({"info", kCornell, "--memory"});
    ASSERT_EQ(text.exitCode, 0) << text.err;
    EXPECT_TRUE(says(text.out, "not allocated"));
    EXPECT_TRUE(says(text.out, "SPPM: statistics of the pixels"));
    const std::string caustics = GLINT_SOURCE_DIR "/scenes/sppm_ring.json";
    for (const std::string& scene : {kCornell, caustics}) {
        const auto report = Json::parse(runProgram({"info", scene, "--json", "-"}).out, nullptr, false);
        ASSERT_FALSE(report.is_discarded());
        const auto& memory = report["memory"];
        uint64_t used = 0, unused = 0, notAllocated = 0;
        for (const auto& row : memory["parts"]) {
            used += row["used_bytes"].get<uint64_t>();
            unused += row["held_unused_bytes"].get<uint64_t>();
            notAllocated += row["not_allocated_bytes"].get<uint64_t>();
            if (row["part"].get<std::string>().starts_with("SPPM")) {
                EXPECT_EQ(row["used_bytes"].get<uint64_t>() > 0, scene == caustics) << row.dump();
                EXPECT_EQ(row["not_allocated_bytes"].get<uint64_t>() > 0, scene != caustics) << row.dump();
            }
        }
        EXPECT_EQ(used, memory["used_bytes"].get<uint64_t>());
        EXPECT_EQ(unused, memory["held_unused_bytes"].get<uint64_t>());
        EXPECT_EQ(notAllocated, memory["not_allocated_bytes"].get<uint64_t>());
        EXPECT_GT(memory["checkpoint_peak_bytes"].get<uint64_t>(), 0u);
    }
}

TEST_F(InfoCommand, WhatAGltfFileLetsOneChoose) {
    const std::string buffer = test::kSquare + test::packed<float>({1, 2.5f, 1, 0, 0, 4, 0, 0});
    const std::string views =
        R"("bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 92, "byteLength": 8},
        {"buffer": 0, "byteOffset": 100, "byteLength": 24}], "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [1], "max": [2.5]},
        {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}])";
    const std::string scene = folder.write(
        "a.gltf",
        test::gltf(R"("extensions": {"KHR_materials_variants": {"variants": [{"name": "red"}, {"name": ""}]}},
            "animations": [{"name": "walk", "channels": [{"sampler": 0, "target": {"node": 0, "path":
            "translation"}}], "samplers": [{"input": 1, "output": 2}]}])",
                   R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 6}]}])", test::kNode,
                   views, buffer));
    const ProgramRun text = runProgram({"info", scene});
    ASSERT_EQ(text.exitCode, 0) << text.err;
    EXPECT_TRUE(says(text.out, "animations walk (1 to 2.5 s)\n"));
    EXPECT_TRUE(says(text.out, "variants   red, 1\n"));
    const Json report = reportOf(scene);
    EXPECT_EQ(report["animations"],
              Json::parse(R"([{"name": "walk", "begin_seconds": 1.0, "end_seconds": 2.5}])"));
    EXPECT_EQ(report["variants"], Json::parse(R"(["red", "1"])"));
    EXPECT_EQ(reportOf(kCornell)["variants"], Json::array());
    EXPECT_EQ(runProgram({"info", kCornell}).out.find("variants"), std::string::npos);
    const ProgramRun wrong = runProgram({"info", scene, "-D", "variant=rad"});
    EXPECT_EQ(wrong.exitCode, 1);
    EXPECT_TRUE(says(wrong.err, "there is no variant \"rad\" (did you mean 'red'?)"));
}

}  // namespace
}  // namespace glint
