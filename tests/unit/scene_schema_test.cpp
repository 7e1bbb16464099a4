// scenes/glint.schema.json and the reader know the same format.
#include <filesystem>
#include <fstream>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/io/scene_json.h"
#include "engine/io/scene_json_keys.h"
#include "engine/io/scene_loader.h"
#include "engine/scene/generated_mesh.h"
#include "engine/scene/metals.h"
#include "tests/support/json_schema.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

Json parse(std::istream& text) { return Json::parse(text, nullptr, true, true); }

const Json& schema() {
    static const Json kSchema = [] {
        std::ifstream file(GLINT_SOURCE_DIR "/scenes/glint.schema.json");
        return parse(file);
    }();
    return kSchema;
}

std::string violation(const Json& scene) { return test::schemaViolation(schema(), schema(), scene, ""); }

std::vector<fs::path> ownScenes() {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(GLINT_SOURCE_DIR "/scenes")) {
        if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema") {
            paths.push_back(entry.path());
        }
    }
    return paths;
}

TEST(SceneSchema, ListsExactlyTheKeysTheReaderKnows) {
    std::set<std::string> closedDefinitions;
    for (const auto& [name, definition] : schema()["definitions"].items()) {
        if (definition.contains("properties")) {
            EXPECT_EQ(definition.value("additionalProperties", Json(true)), Json(false)) << name;
            closedDefinitions.insert(name);
        }
    }
    for (const JsonKind& kind : sceneJsonKinds()) {
        const std::string name(kind.name);
        ASSERT_EQ(closedDefinitions.erase(name), 1u) << name;
        std::set<std::string> keys;
        for (const auto& [key, property] : schema()["definitions"][name]["properties"].items()) {
            keys.insert(key);
        }
        EXPECT_EQ(keys, std::set<std::string>(kind.keys.begin(), kind.keys.end())) << name;
    }
    EXPECT_THAT(closedDefinitions, testing::IsEmpty());
}

TEST(SceneSchema, ListsTheMetalsAndGenerators) {
    const auto words = [](const char* kind, const char* key) {
        return schema()["definitions"][kind]["properties"][key]["enum"].get<std::set<std::string>>();
    };
    const auto metals = metalNames();
    const auto generators = meshGeneratorNames();
    EXPECT_EQ(words("conductor", "metal"), std::set<std::string>(metals.begin(), metals.end()));
    EXPECT_EQ(words("meshGenerator", "generator"),
              std::set<std::string>(generators.begin(), generators.end()));
}

TEST(SceneSchema, AcceptsOurOwnScenesAndWhatWeSave) {
    EXPECT_GE(ownScenes().size(), 6u);
    for (const fs::path& path : ownScenes()) {
        std::ifstream file(path);
        const Json json = parse(file);
        EXPECT_EQ(violation(json), "") << path;
        EXPECT_FALSE(json.value("title", "").empty()) << path;
        EXPECT_FALSE(json.value("description", "").empty()) << path;
        EXPECT_EQ(json.value("$schema", ""), "glint.schema.json") << path;
        const auto scene = loadScene(path.string());
        ASSERT_TRUE(scene.ok()) << scene.error().format();
        const auto saved = writeSceneJson(*scene, path.string());
        ASSERT_TRUE(saved.ok()) << saved.error().format();
        EXPECT_EQ(violation(Json::parse(*saved)), "") << path;
    }
}

TEST(SceneSchema, RejectsWhatTheReaderRejects) {
    for (const char* text : {
             R"({"title": "no version"})",
             R"({"glint": 2})",
             R"({"glint": 1, "camra": {}})",
             R"({"glint": 1, "resolution": [0, 10]})",
             R"({"glint": 1, "camera": {"verticalFovDeg": 200}})",
             R"({"glint": 1, "camera": {"position": [1, 2]}})",
             R"({"glint": 1, "render": {"filter": "gausian"}})",
             R"({"glint": 1, "render": {"sppm": {"alpha": 1}}})",
             R"({"glint": 1, "render": {"sppm": {"photonsPerPass": 0}}})",
             R"({"glint": 1, "render": {"sppm": {"radius": -0.1}}})",
             R"({"glint": 1, "render": {"sppm": {"radiusFootprints": 0}}})",
             R"({"glint": 1, "render": {"sppm": {"lookup": "octree"}}})",
             R"({"glint": 1, "render": {"sppm": {"photons": 5}}})",
             R"({"glint": 1, "materials": {"m": {"type": "diffuse", "ior": 2}}})",
             R"({"glint": 1, "materials": {"m": {"type": "diffuse", "color": [2, 0, 0]}}})",
             R"({"glint": 1, "materials": {"m": {"type": "diffuse", "color": "#ff00"}}})",
             R"({"glint": 1, "materials": {"m": {"color": 1}}})",
             R"({"glint": 1, "objects": [{"type": "sphere"}]})",
             R"({"glint": 1, "objects": [{"type": "cube", "material": "m"}]})",
             R"({"glint": 1, "lights": [{"type": "point"}]})",
             R"({"glint": 1, "environment": {"image": {"generator": "sky", "width": 15}}})",
         }) {
        EXPECT_NE(violation(Json::parse(text)), "") << text;
        EXPECT_FALSE(readSceneJson({"scene.json", text}, {}).ok()) << text;
    }
}

}  // namespace
}  // namespace glint
