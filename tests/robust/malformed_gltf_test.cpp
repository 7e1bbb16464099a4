// glTF files that are broken: one error that names the place, and never a crash.
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/builders/scene_validation.h"
#include "engine/io/scene_loader.h"
#include "tests/support/gltf_files.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::gltf;
using test::kMesh;
using test::kNode;
using test::kSquare;
using test::kViews;
using test::material;
using test::packed;
using test::TempFolder;
using testing::HasSubstr;

std::string replaced(std::string in, const std::string& from, const std::string& to) {
    const size_t at = in.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? in : in.replace(at, from.size(), to);
}

/// 1000 nodes that share a mesh of 1000 primitives are a file of 60 KB, and would be a million objects.
TEST(MalformedGltf, ObjectsAreBoundByTheFile) {
    const TempFolder folder;
    std::string primitives, nodes;
    for (int i = 0; i < 1000; ++i) {
        primitives += std::string(i > 0 ? "," : "") + R"({"attributes": {"POSITION": 0}, "indices": 2})";
        nodes += std::string(i > 0 ? "," : "") + R"({"mesh": 0})";
    }
    const auto load = [&](const std::string& some) {
        return loadScene(
            folder.write("a.gltf", gltf(material(""), "\"meshes\": [{\"primitives\": [" + primitives + "]}]",
                                        "\"nodes\": [" + some + "]")));
    };
    const auto many = load(nodes);
    ASSERT_FALSE(many);
    EXPECT_THAT(many.error().format(), HasSubstr("its nodes place more than 100000 meshes"));
    const auto some = load(nodes.substr(0, 12 * 50 - 1));
    ASSERT_TRUE(some) << some.error().format();
    EXPECT_EQ(some->objects.size(), 50'001u) << "with the studio's ground";
}

TEST(MalformedGltf, FilesGiveOneErrorThatNamesThePlace) {
    const TempFolder folder;
    const std::string good = gltf(material(""));
    const auto deep = [](size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); };
    const std::pair<std::string, const char*> files[] = {
        {good.substr(0, 150), "is no glTF file that can be read"},
        {"glTF" + packed<uint32_t>({2, 100, 50}) + "JSON{", "is no glTF file that can be read"},
        {R"({"asset": {"version": "1.0"}})", "is glTF 1.0; expected 2.0"},
        {"glTF" + packed<uint32_t>({1, 40, 20, 0, 0}), "is glTF 1.0; expected 2.0"},
        {R"({"asset": {"version": "2.0"}})", "has no triangles"},
        {gltf(material("") + R"(, "extensionsRequired": ["KHR_texture_basisu"])"),
         "needs KHR_texture_basisu, which Glint does not read"},
        {gltf(R"("extras": )" + deep(100'000)), "nested deeper than 200 levels"},
        {replaced(good, "\"count\": 4, \"type\": \"VEC3\"", "\"count\": 5, \"type\": \"VEC3\""),
         "mesh 0, primitive 0, positions, accessor 0: 5 elements of 12 bytes end beyond"},
        {replaced(good, "\"byteLength\": 48", "\"byteLength\": 1099511627776"), "buffer"},
        {replaced(good, "\"count\": 4", "\"count\": 4294967295"), "too many"},
        {replaced(good, "\"byteOffset\": 80", "\"byteOffset\": 100"), "buffer"},
        {replaced(good, "\"buffer\": 0", "\"buffer\": 7"), "buffer 7"},
        {replaced(good, "\"indices\": 2", "\"indices\": 9"), "accessor out of bounds"},
        {replaced(good, "\"indices\": 2", "\"indices\": 1"), "indices, accessor 1: expected elements of 1"},
        {replaced(good, "\"material\": 0", "\"material\": 3"), "no material 3"},
        {replaced(good, "{\"mesh\": 0}", "{\"mesh\": 5}"), "no mesh 5"},
        {replaced(good, kNode, R"("scenes": [{"nodes": [1]}], "nodes": [{"mesh": 0}, {"children": [0, 0]}])"),
         "node 0 has two parents"},
        {replaced(good, kNode, R"("scenes": [{"nodes": [0]}], "nodes": [{"children": [0], "mesh": 0}])"),
         "its own"},
        {replaced(good, kNode, R"("scenes": [{"nodes": [4]}], "nodes": [{"mesh": 0}])"), "no node 4"},
        {gltf(material(R"("pbrMetallicRoughness": {"baseColorTexture": {"index": 2}})")), "no texture 2"},
        {gltf(R"("textures": [{"source": 3}], )" +
              material(R"("emissiveTexture": {"index": 0}, "emissiveFactor": [1,1,1])")),
         "no image 3"},
        {gltf(material(""), kMesh, kNode, kViews,
              replaced(kSquare, packed<uint16_t>({0, 1, 2, 0, 2, 3}), packed<uint16_t>({0, 1, 2, 0, 2, 4}))),
         "an index is 4; there are 4 vertices"},
        {gltf(material(""), kMesh, kNode, kViews, packed<float>({NAN}) + kSquare.substr(4)), "not finite"}};
    for (const auto& [text, message] : files) {
        const auto scene = loadScene(folder.write("bad.gltf", text));
        ASSERT_FALSE(scene) << message;
        EXPECT_THAT(scene.error().format(), HasSubstr(message));
        EXPECT_THAT(scene.error().format(), HasSubstr("bad.gltf: "));
    }
}

TEST(MalformedGltf, DamagedFilesNeverCrash) {
    const TempFolder folder;
    const std::string good = gltf(
        R"("images": [{"bufferView": 0, "mimeType": "image/png"}], "textures": [{"source": 0}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}}],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "spot": {}}]}}, )" +
            material(
                R"("pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "extensions": {"KHR_materials_ior": {"ior": 1.3}})"),
        kMesh, R"("nodes": [{"mesh": 0, "children": [1, 2]}, {"camera": 0},
        {"extensions": {"KHR_lights_punctual": {"light": 0}}}])");
    std::mt19937 random(9);
    constexpr char kOften[] = "0123456789-{}[]\",:.e";
    int opened = 0;
    for (int round = 0; round < 1000; ++round) {
        std::string text = good;
        for (size_t changes = 1 + random() % 3; changes > 0; --changes) {
            text[random() % text.size()] =
                random() % 4 == 0 ? static_cast<char>(random()) : kOften[random() % (sizeof kOften - 1)];
        }
        if (random() % 8 == 0) { text.resize(random() % text.size()); }
        const auto scene = loadScene(folder.write("damaged.gltf", text));
        if (scene) {
            ++opened;
            EXPECT_TRUE(validateScene(*scene, EditKind::Everything)) << text;
        } else {
            EXPECT_FALSE(scene.error().message.empty());
        }
    }
    EXPECT_GT(opened, 30);
}

}  // namespace
}  // namespace glint
