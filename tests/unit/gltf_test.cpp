// glTF 2.0: what nodes, meshes, materials, cameras and lights become.
#include "tests/support/gltf_test.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/atomic_file.h"
#include "engine/io/image_io.h"
#include "engine/io/scene_json.h"
#include "engine/io/studio.h"
#include "tests/support/film_bits.h"

namespace glint {
namespace {

using test::base64;
using test::gltf;
using test::kMesh;
using test::kNode;
using test::kSquare;
using test::material;
using test::packed;
using testing::ElementsAre;
using testing::IsEmpty;

using Gltf = test::GltfTest;

TEST_F(Gltf, TextAndBinaryFilesHoldTheSameMesh) {
    const std::string json = gltf(material(""));
    const SceneDescription text = load(json);
    ASSERT_EQ(text.objects.size(), 1u);
    EXPECT_EQ(text.meshes[0].data->positions.size(), 4u);
    EXPECT_THAT(text.meshes[0].data->indices, ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_TRUE(text.meshes[0].data->normals.empty()) << "flat where the file has none";
    EXPECT_THAT(text.warnings, IsEmpty());
    std::string chunk = json;
    const size_t uri = chunk.find(", \"uri\""), end = chunk.find("\"}]", uri);
    chunk.erase(uri, end + 1 - uri);
    chunk.resize((chunk.size() + 3) / 4 * 4, ' ');
    std::string glb = "glTF" +
                      packed<uint32_t>({2, static_cast<uint32_t>(28 + chunk.size() + kSquare.size()),
                                        static_cast<uint32_t>(chunk.size())}) +
                      "JSON" + chunk + packed<uint32_t>({static_cast<uint32_t>(kSquare.size())}) +
                      std::string("BIN\0", 4) + kSquare;
    for (const char* name : {"a.glb", "noname"}) {
        const SceneDescription binary = load(glb, name);
        ASSERT_EQ(binary.meshes.size(), 1u) << name;
        EXPECT_EQ(binary.meshes[0].data->positions, text.meshes[0].data->positions);
    }
    EXPECT_EQ(load(json, "a.json").objects.size(), 1u) << "by its content";
    folder.write("with space.bin", kSquare);
    std::string apart = json;
    const size_t from = apart.find("data:");
    apart.replace(from, apart.find('"', from) - from, "with%20space.bin");
    EXPECT_EQ(load(apart).meshes.size(), 1u);
}

/// Of what is read, nothing is refused where a file needs it.
TEST_F(Gltf, WhatIsReadMayBeNeeded) {
    for (const char* extension : {"KHR_materials_diffuse_transmission", "KHR_materials_volume",
                                  "KHR_materials_specular", "KHR_materials_clearcoat", "KHR_materials_sheen",
                                  "KHR_materials_anisotropy", "KHR_materials_iridescence",
                                  "KHR_materials_variants", "KHR_texture_transform", "KHR_lights_punctual"}) {
        EXPECT_FALSE(
            load(gltf(material("") + R"(, "extensionsRequired": [")" + extension + "\"]")).objects.empty())
            << extension;
    }
}

TEST_F(Gltf, EveryKindOfIndicesAndPrimitives) {
    const std::string positions = packed<float>({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
    const auto indicesOf = [&](const std::string& bytes, int type, int count, int mode) {
        const std::string views =
            R"("bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48,
            "byteLength": )" +
            std::to_string(bytes.size()) + R"(}], "accessors": [{"bufferView": 0,
            "componentType": 5126, "count": 4, "type": "VEC3"}, {"bufferView": 1, "componentType": )" +
            std::to_string(type) + ", \"count\": " + std::to_string(count) + R"(, "type": "SCALAR"}])";
        const std::string mesh = R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1,
            "mode": )" + std::to_string(mode) +
                                 "}]}]";
        const SceneDescription scene = load(gltf("", mesh, kNode, views, positions + bytes));
        return scene.meshes.empty() ? std::vector<uint32_t>() : scene.meshes[0].data->indices;
    };
    EXPECT_THAT(indicesOf(packed<uint8_t>({0, 1, 2}), 5121, 3, 4), ElementsAre(0, 1, 2));
    EXPECT_THAT(indicesOf(packed<uint32_t>({0, 1, 2, 3, 0, 2}), 5125, 6, 4), ElementsAre(0, 1, 2, 3, 0, 2));
    EXPECT_THAT(indicesOf(packed<uint16_t>({0, 1, 3, 2}), 5123, 4, 5), ElementsAre(0, 1, 3, 3, 1, 2))
        << "a strip";
    EXPECT_THAT(indicesOf(packed<uint16_t>({0, 1, 2, 3}), 5123, 4, 6), ElementsAre(0, 1, 2, 0, 2, 3))
        << "a fan";
}

TEST_F(Gltf, StridesNormalisedAndSparseNumbers) {
    // Positions as bytes with a stride, colours as normalised shorts, and a sparse part that moves a corner.
    const std::string buffer = packed<int8_t>({-1, -1, 0, 9, 1, -1, 0, 9, 1, 1, 0, 9}) +
                               packed<uint16_t>({65535, 0, 32768, 0, 0, 0, 0, 0, 0}) + std::string(2, '\0') +
                               packed<uint16_t>({2, 0}) + packed<int8_t>({5, 6, 7, 0});
    const std::string views = R"("bufferViews": [{"buffer": 0, "byteLength": 12, "byteStride": 4},
        {"buffer": 0, "byteOffset": 12, "byteLength": 18}, {"buffer": 0, "byteOffset": 32, "byteLength": 2},
        {"buffer": 0, "byteOffset": 36, "byteLength": 3}],
        "accessors": [{"bufferView": 0, "componentType": 5120, "count": 3, "type": "VEC3", "sparse": {"count": 1,
            "indices": {"bufferView": 2, "componentType": 5123}, "values": {"bufferView": 3}}},
        {"bufferView": 1, "componentType": 5123, "normalized": true, "count": 3, "type": "VEC3"}])";
    const SceneDescription scene =
        load(gltf(R"("extensionsRequired": ["KHR_mesh_quantization"])",
                  R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 1}}]}])", kNode,
                  views, buffer));
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_THAT(scene.meshes[0].data->positions, ElementsAre(Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(5, 6, 7)));
    EXPECT_NEAR(scene.meshes[0].data->colors[0].z, 0.5f, 1e-4f) << "linear, not sRGB";
    EXPECT_EQ(scene.meshes[0].data->colors[0].x, 1.0f);
}

TEST_F(Gltf, NodesPlaceMeshesWithinEachOtherAndShareThem) {
    const SceneDescription scene =
        load(gltf(material(""), kMesh, R"("scene": 1, "scenes": [{"nodes": [3]}, {"nodes": [0]}],
        "nodes": [{"translation": [1, 2, 3], "rotation": [0, 0, 0.70710678, 0.70710678], "children": [1, 2]},
                  {"mesh": 0, "scale": [2, 1, 1]},
                  {"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1], "name": "moved"},
                  {"mesh": 0}])"));
    ASSERT_EQ(scene.objects.size(), 2u) << "of the scene that the file shows";
    EXPECT_EQ(scene.objects[0].mesh, scene.objects[1].mesh);
    EXPECT_EQ(scene.objects[1].name, "moved");
    EXPECT_LT(glm::length(scene.objects[0].objectToWorld.point({1, 0, 0}) - Vec3(1, 4, 3)), 1e-5f);
    EXPECT_LT(glm::length(scene.objects[1].objectToWorld.point({1, 0, 0}) - Vec3(1, 8, 3)), 1e-5f);
}

TEST_F(Gltf, SkinsAndMorphTargetsAreAtRest) {
    // The square's left corners follow joint 1, its right ones joint 2; a morph target lifts all corners.
    const std::string buffer = packed<float>({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}) +
                               packed<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}) +
                               packed<uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}) +
                               packed<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}) +
                               packed<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}) +
                               packed<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -5, 0, 0, 1});
    const std::string views =
        R"("bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 48},
        {"buffer": 0, "byteOffset": 96, "byteLength": 16}, {"buffer": 0, "byteOffset": 112, "byteLength": 64},
        {"buffer": 0, "byteOffset": 176, "byteLength": 128}], "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"},
        {"bufferView": 2, "componentType": 5121, "count": 4, "type": "VEC4"},
        {"bufferView": 3, "componentType": 5126, "count": 4, "type": "VEC4"},
        {"bufferView": 4, "componentType": 5126, "count": 2, "type": "MAT4"}])";
    const std::string mesh =
        R"("meshes": [{"weights": [0.5], "primitives": [{"mode": 6, "attributes": {"POSITION": 0,
        "JOINTS_0": 2, "WEIGHTS_0": 3}, "targets": [{"POSITION": 1}]}]}])";
    const SceneDescription scene =
        load(gltf(R"("skins": [{"joints": [1, 2], "inverseBindMatrices": 4}])", mesh,
                  R"("nodes": [{"mesh": 0, "skin": 0, "translation": [100, 0, 0]}, {"translation": [0, 7, 0]},
                     {"translation": [5, 0, 2]}, {"mesh": 0, "weights": [2], "translation": [0, 0, 9]}])",
                  views, buffer));
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.objects[0].objectToWorld, Affine()) << "joints alone place a skin's mesh";
    EXPECT_THAT(scene.meshes[0].data->positions,
                ElementsAre(Vec3(-1, 6, 0.5f), Vec3(1, -1, 2.5f), Vec3(1, 1, 2.5f), Vec3(-1, 8, 0.5f)));
    EXPECT_EQ(scene.meshes[1].data->positions[0], Vec3(-1, -1, 2))
        << "twice the target, by the node's own weight";
    EXPECT_EQ(scene.objects[1].objectToWorld.translation, Vec3(0, 0, 9));
    const SceneDescription plain = load(gltf("", mesh, kNode, views, buffer));
    EXPECT_EQ(plain.meshes[0].data->positions[0], Vec3(-1, -1, 0.5f)) << "by the mesh's weight";
    const SceneDescription crowd = load(gltf(R"("skins": [{"joints": [1, 2]}, {"joints": [2, 1]}])", mesh,
                                             R"("nodes": [{"mesh": 0, "skin": 0}, {"translation": [0, 7, 0]},
                     {"translation": [5, 0, 2]}, {"mesh": 0, "skin": 0}, {"mesh": 0, "skin": 1}])",
                                             views, buffer));
    EXPECT_EQ(crowd.objects.size(), 3u);
    EXPECT_EQ(crowd.meshes.size(), 2u) << "one for each skin";
    const std::string twice =
        R"("meshes": [{"primitives": [{"mode": 6, "attributes": {"POSITION": 0, "JOINTS_0": 2, "WEIGHTS_0": 3,
        "JOINTS_1": 5, "WEIGHTS_1": 3}}]}])";
    const std::string more =
        std::string(views, 0, views.size() - 1) +
        R"(,{"bufferView": 2, "byteOffset": 4, "componentType": 5121, "count": 3, "type": "VEC4"}])";
    const SceneDescription both = load(
        gltf(R"("skins": [{"joints": [1, 2], "inverseBindMatrices": 4}])", twice,
             R"("nodes": [{"mesh": 0, "skin": 0}, {"translation": [0, 7, 0]}, {"translation": [5, 0, 2]}])",
             more, buffer));
    EXPECT_EQ(both.meshes[0].data->positions[0], Vec3(-1, -1 + 3.5f, 1)) << "half of each joint";
}

TEST_F(Gltf, InstancesShareTheMeshOfTheirNode) {
    const std::string buffer =
        kSquare + packed<float>({1, 0, 0, 0, 2, 0}) + packed<float>({2, 2, 2, 3, 3, 3});
    std::string views = test::kViews;
    views.insert(views.find("],"), R"(, {"buffer": 0, "byteOffset": 92, "byteLength": 24}, {"buffer": 0,
        "byteOffset": 116, "byteLength": 24})");
    views.insert(views.rfind(']'), R"(, {"bufferView": 3, "componentType": 5126, "count": 2, "type": "VEC3"},
        {"bufferView": 4, "componentType": 5126, "count": 2, "type": "VEC3"})");
    const SceneDescription scene =
        load(gltf(material("") + R"(, "extensionsRequired": ["EXT_mesh_gpu_instancing"])", kMesh,
                  R"("nodes": [{"mesh": 0, "translation": [0, 0, 5], "extensions": {"EXT_mesh_gpu_instancing":
        {"attributes": {"TRANSLATION": 3, "SCALE": 4}}}}])",
                  views, buffer));
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.objects[0].mesh, scene.objects[1].mesh);
    EXPECT_EQ(scene.objects[0].objectToWorld.point({1, 1, 0}), Vec3(3, 2, 5));
    EXPECT_EQ(scene.objects[1].objectToWorld.point({1, 1, 0}), Vec3(3, 5, 5));
}

TEST_F(Gltf, CamerasAndLights) {
    const SceneDescription scene =
        load(gltf(material("") + R"(, "cameras": [{"type": "perspective",
        "perspective": {"yfov": 0.5, "aspectRatio": 2, "znear": 0.1}}], "extensions": {"KHR_lights_punctual": {"lights": [
        {"type": "point", "intensity": 683, "color": [1, 0.5, 0]}, {"type": "spot", "spot": {"innerConeAngle": 0.1,
        "outerConeAngle": 0.2}}, {"type": "directional", "intensity": 1366}]}})",
                  kMesh, R"("nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 0, 5]},
        {"translation": [0, 3, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"rotation": [-0.70710678, 0, 0, 0.70710678], "extensions": {"KHR_lights_punctual": {"light": 1}}},
        {"extensions": {"KHR_lights_punctual": {"light": 2}}}])"));
    EXPECT_EQ(scene.camera.position, Vec3(0, 0, 5));
    EXPECT_EQ(scene.camera.target, Vec3(0, 0, 0)) << "the middle of the model";
    EXPECT_NEAR(scene.camera.verticalFovDeg, 28.65f, 0.01f);
    EXPECT_EQ(scene.resolution, (Resolution{1200, 600}));
    ASSERT_EQ(scene.lights.size(), 3u);
    EXPECT_EQ(scene.lights[0].position, Vec3(0, 3, 0));
    EXPECT_FLOAT_EQ(scene.lights[0].strength, 1.0f);
    EXPECT_EQ(scene.lights[0].color, Vec3(1.0f, 0.5f, 0.0f));
    EXPECT_EQ(scene.lights[1].kind, LightKind::Spot);
    EXPECT_LT(glm::length(scene.lights[1].direction - Vec3(0, -1, 0)), 1e-5f);
    EXPECT_NEAR(scene.lights[1].coneAngleDeg, 11.459f, 1e-3f);
    EXPECT_NEAR(scene.lights[1].coneFalloffStartDeg, 5.730f, 1e-3f);
    EXPECT_EQ(scene.lights[2].kind, LightKind::Directional);
    EXPECT_FLOAT_EQ(scene.lights[2].strength, 2.0f);
    EXPECT_FALSE(scene.environment.emissive()) << "it brings its own light";
}

TEST_F(Gltf, OrthographicCamerasAreThat) {
    const auto withCamera = [&](const std::string& lens) {
        return load(gltf(material("") + R"(, "cameras": [{"type": "orthographic", "orthographic": {)" + lens +
                             R"(, "znear": 0.1, "zfar": 9}}])",
                         kMesh, R"("nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 0, 5]}])"));
    };
    const SceneDescription scene = withCamera(R"("xmag": 3, "ymag": 1.5)");
    EXPECT_EQ(scene.camera.kind, ProjectionKind::Orthographic);
    EXPECT_EQ(scene.camera.viewHeight, 3.0f);
    EXPECT_EQ(scene.resolution, (Resolution{1200, 600}));
    EXPECT_EQ(scene.camera.position, Vec3(0, 0, 5));
    EXPECT_TRUE(scene.warnings.empty());
    const SceneDescription flat = withCamera(R"("xmag": 3, "ymag": 0)");
    EXPECT_EQ(flat.camera.kind, ProjectionKind::Perspective) << "the default view";
    EXPECT_EQ(flat.warnings.size(), 1u);
}

TEST_F(Gltf, ModelsWithoutLampsGetTheStudio) {
    const auto hasGround = [&](const std::string& members) {
        const auto scene = loadScene(folder.write("a.gltf", gltf(material(members))));
        EXPECT_TRUE(scene) << scene.error().format();
        return scene && hasStudio(*scene);
    };
    EXPECT_TRUE(hasGround(""));
    EXPECT_TRUE(hasGround(R"("emissiveFactor": [1, 1, 1])")) << "a screen is no lamp";
    EXPECT_FALSE(hasGround(R"("emissiveFactor": [1, 1, 1],
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 5}})"));
}

TEST_F(Gltf, SavedAndLoadedAgainRendersTheSame) {
    ASSERT_TRUE(savePng(folder.path("t.png"), {2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 0}}));
    const std::string png = base64(readFile(folder.path("t.png")).value());
    test::expectSameFilmWhenSaved(folder.write(
        "a.gltf",
        gltf(R"("images": [{"uri": "data:image/png;base64,)" + png +
             R"("}], "textures": [{"source": 0}], "materials": [{"pbrMetallicRoughness": {"metallicFactor": 0,
        "baseColorTexture": {"index": 0}, "baseColorFactor": [1, 0.5, 1, 1]}}])")));
}

}  // namespace
}  // namespace glint
