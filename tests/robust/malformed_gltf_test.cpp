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

/// A skin, an animation, morph targets, sparse numbers, instances, variants, layers.
std::string richFile() {
    const std::string buffer =
        kSquare + std::string(16, '\0') + packed<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}) +
        packed<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}) + packed<float>({0, 1}) +
        packed<float>({0, 0, 0, 1, 2, 3}) + packed<uint16_t>({2, 0}) + packed<float>({1, 1, 1});
    const std::string views =
        R"("bufferViews": [{"buffer": 0, "byteLength": 80}, {"buffer": 0, "byteOffset": 80,
        "byteLength": 12}, {"buffer": 0, "byteOffset": 92, "byteLength": 192}], "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "sparse": {"count": 1,
         "indices": {"bufferView": 2, "byteOffset": 176, "componentType": 5123},
         "values": {"bufferView": 2, "byteOffset": 180}}},
        {"bufferView": 0, "byteOffset": 48, "componentType": 5126, "count": 4, "type": "VEC2"},
        {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
        {"bufferView": 2, "componentType": 5121, "count": 4, "type": "VEC4"},
        {"bufferView": 2, "byteOffset": 16, "componentType": 5126, "count": 4, "type": "VEC4"},
        {"bufferView": 2, "byteOffset": 80, "componentType": 5126, "count": 1, "type": "MAT4"},
        {"bufferView": 2, "byteOffset": 144, "componentType": 5126, "count": 2, "type": "SCALAR"},
        {"bufferView": 2, "byteOffset": 152, "componentType": 5126, "count": 2, "type": "VEC3"}])";
    return gltf(
        R"("skins": [{"joints": [1], "inverseBindMatrices": 5}],
        "animations": [{"samplers": [{"input": 6, "output": 7}], "channels": [{"sampler": 0,
         "target": {"node": 1, "path": "translation"}}]}],
        "extensionsUsed": ["EXT_mesh_gpu_instancing", "EXT_strange"],
        "extensions": {"KHR_materials_variants": {"variants": [{"name": "a"}, {"name": "b"}]}}, )" +
            material(R"("extensions": {"KHR_materials_iridescence": {"iridescenceFactor": 0.5},
        "KHR_materials_clearcoat": {"clearcoatFactor": 1}, "KHR_materials_sheen": {"sheenColorFactor": [1, 0, 1]}})"),
        R"("meshes": [{"weights": [0.5], "primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1,
        "JOINTS_0": 3, "WEIGHTS_0": 4}, "indices": 2, "material": 0, "targets": [{"POSITION": 0}],
        "extensions": {"KHR_materials_variants": {"mappings": [{"material": 0, "variants": [1]}]}}}]}])",
        R"("nodes": [{"mesh": 0, "skin": 0}, {"translation": [1, 0, 0]}, {"mesh": 0, "weights": [1],
        "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 7}}}}])",
        views, buffer);
}

/// How many of a thousand damaged ones still open.
int openDamaged(const TempFolder& folder, const std::string& good, const SceneParameters& parameters) {
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
        const auto scene = loadScene(folder.write("damaged.gltf", text), {.parameters = parameters});
        if (scene) {
            ++opened;
            const Status valid = validateScene(*scene, EditKind::Everything);
            EXPECT_TRUE(valid) << valid.error().format() << text;
        } else {
            EXPECT_FALSE(scene.error().message.empty());
        }
    }
    return opened;
}

TEST(MalformedGltf, DamagedFilesNeverCrash) {
    const TempFolder folder;
    ASSERT_TRUE(loadScene(folder.write("rich.gltf", richFile())));
    EXPECT_GT(openDamaged(folder, richFile(), {{"time", "0.5"}, {"variant", "b"}}), 30);
    const std::string good = gltf(
        R"("images": [{"bufferView": 0, "mimeType": "image/png"}], "textures": [{"source": 0}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}}],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "spot": {}}]}}, )" +
            material(
                R"("pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "extensions": {"KHR_materials_ior": {"ior": 1.3}})"),
        kMesh, R"("nodes": [{"mesh": 0, "children": [1, 2]}, {"camera": 0},
        {"extensions": {"KHR_lights_punctual": {"light": 0}}}])");
    EXPECT_GT(openDamaged(folder, good, {}), 30);
}

}  // namespace
}  // namespace glint
