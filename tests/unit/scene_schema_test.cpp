// scenes/glint.schema.json and the reader know the same format.
#include "engine/io/scene_schema.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"
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

TEST(SceneSchema, IsWhatTheProgramPrints) {
    std::ifstream file(GLINT_SOURCE_DIR "/scenes/glint.schema.json");
    const std::string stored{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(stored, sceneSchema()) << "write it anew: glint schema > scenes/glint.schema.json";
}

/// The message for an unknown key names those that the reader knows.
TEST(SceneSchema, ListsExactlyTheKeysTheReaderKnows) {
    const std::map<std::string, std::string> places{
        {"scene", R"("x": 0)"},
        {"camera", R"("camera": {"x": 0})"},
        {"render", R"("render": {"x": 0})"},
        {"sppm", R"("render": {"sppm": {"x": 0}})"},
        {"textureFile", R"("textures": {"t": {"x": 0}})"},
        {"checkerboard", R"("textures": {"t": {"generator": "checkerboard", "x": 0}})"},
        {"raycast", R"("render": {"raycast": {"x": 0}})"},
        {"textureUse", R"("materials": {"m": {"type": "diffuse", "color": {"x": 0}}})"},
        {"meshFile", R"("meshes": {"m": {"x": 0}})"},
        {"meshGenerator", R"("meshes": {"m": {"generator": "cube", "x": 0}})"},
        {"meshInline", R"("meshes": {"m": {"positions": [], "x": 0}})"},
        {"transformStep", R"("objects": [{"type": "sphere", "transform": {"x": 0}}])"},
        {"rotation", R"("objects": [{"type": "sphere", "transform": {"rotate": {"x": 0}}}])"},
        {"environment", R"("environment": {"x": 0})"},
        {"environmentFile", R"("environment": {"image": {"x": 0}})"},
        {"sky", R"("environment": {"image": {"generator": "sky", "x": 0}})"}};
    for (const auto& [name, definition] : schema()["definitions"].items()) {
        if (!definition.contains("properties")) { continue; }
        EXPECT_EQ(definition.value("additionalProperties", Json(true)), Json(false)) << name;
        std::vector<std::string> texts;
        if (const auto place = places.find(name); place != places.end()) {
            texts = {place->second};
        } else {
            for (const char* text :
                 {R"("materials": {{"m": {{"type": "{}", "x": 0}}}})",
                  R"("objects": [{{"type": "{}", "x": 0}}])", R"("lights": [{{"type": "{}", "x": 0}}])"}) {
                texts.push_back(fmt::format(fmt::runtime(text), name));
            }
        }
        std::set<std::string> keys;
        for (const auto& [key, property] : definition["properties"].items()) {
            keys.insert(key);
        }
        std::set<std::string> known;
        for (const std::string& text : texts) {
            const auto scene = readSceneJson({"scene.json", "{\"glint\": 1, " + text + "}"}, {});
            ASSERT_FALSE(scene.ok()) << name;
            std::smatch match;
            const std::string message = scene.error().message;
            if (!std::regex_search(message, match, std::regex("unknown key \"x\".*; expected (.*)"))) {
                continue;
            }
            std::string list = match[1];
            list = std::regex_replace(list, std::regex(" or "), ", ");
            for (size_t begin = 0; begin < list.size();) {
                const size_t end = std::min(list.find(", ", begin), list.size());
                known.insert(list.substr(begin, end - begin));
                begin = end + 2;
            }
        }
        EXPECT_EQ(known, keys) << name;
    }
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
             R"({"glint": 1, "render": {"accelerator": "octree"}})",
             R"({"glint": 1, "render": {"raycast": {"shadows": true}}})",
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
