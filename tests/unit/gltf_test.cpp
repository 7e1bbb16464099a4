// glTF 2.0: what nodes, meshes, materials, cameras and lights become.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/builders/scene_validation.h"
#include "engine/io/atomic_file.h"
#include "engine/io/image_io.h"
#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"
#include "engine/io/studio.h"
#include "tests/support/film_bits.h"
#include "tests/support/gltf_files.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::base64;
using test::gltf;
using test::kMesh;
using test::kNode;
using test::kSquare;
using test::material;
using test::packed;
using test::TempFolder;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Gltf : public testing::Test {
  protected:
    SceneDescription load(const std::string& text, const std::string& name = "a.gltf") {
        auto scene = loadScene(folder.write(name, text), {.noStudio = true});
        EXPECT_TRUE(scene) << scene.error().format();
        if (!scene) { return {}; }
        EXPECT_TRUE(validateScene(*scene, EditKind::Everything));
        return std::move(*scene);
    }
    Material only(const std::string& members) {
        const SceneDescription scene = load(gltf(material(members)));
        return scene.materials.empty() ? Material() : scene.materials[0];
    }
    TempFolder folder;
};

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

TEST_F(Gltf, MaterialsBecomeTheNearestOfGlint) {
    const Material plain = only("");
    EXPECT_EQ(plain.kind, MaterialKind::Conductor) << "metallic is 1 unless it is said";
    const Material plastic =
        only(R"("pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 1], "metallicFactor": 0,
        "roughnessFactor": 0.5}, "extensions": {"KHR_materials_ior": {"ior": 1.3}})");
    EXPECT_EQ(plastic.kind, MaterialKind::Plastic);
    EXPECT_EQ(plastic.color.value, Vec3(0.5f, 0.25f, 1.0f));
    EXPECT_EQ(plastic.roughness.value, 0.25f);
    EXPECT_FLOAT_EQ(plastic.ior.value, 1.3f);
    const Material metal =
        only(R"("pbrMetallicRoughness": {"baseColorFactor": [0.9, 0.6, 0.2, 1], "roughnessFactor": 0})");
    ASSERT_EQ(metal.kind, MaterialKind::Conductor);
    for (int c = 0; c < 3; ++c) {
        const float n = metal.eta.value[c], k = metal.k.value[c];
        EXPECT_NEAR(((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k), Vec3(0.9f, 0.6f, 0.2f)[c],
                    1e-4f);
    }
    const std::string passing = R"("extensions": {"KHR_materials_transmission": {"transmissionFactor": 1})";
    EXPECT_EQ(only(passing + "}").kind, MaterialKind::Dielectric);
    EXPECT_TRUE(only(passing + "}").thin);
    EXPECT_FALSE(only(passing + R"(, "KHR_materials_volume": {"thicknessFactor": 0.1}})").thin);
    const Material lamp = only(R"("emissiveFactor": [1, 0.5, 0], "doubleSided": true,
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 20}})");
    EXPECT_EQ(lamp.emission.value, Vec3(1.0f, 0.5f, 0.0f));
    EXPECT_EQ(lamp.emissionStrength, 20.0f);
    EXPECT_TRUE(lamp.emitsBothSides);
    const Material older =
        only(R"("extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.5, 0.25, 1, 1],
        "glossinessFactor": 0.5}})");
    EXPECT_EQ(older.kind, MaterialKind::Plastic);
    EXPECT_EQ(older.color.value, Vec3(0.5f, 0.25f, 1.0f));
    EXPECT_EQ(older.roughness.value, 0.25f);
    const Material unlit = only(R"("pbrMetallicRoughness": {"baseColorFactor": [0.2, 0.4, 0.6, 1]},
        "extensions": {"KHR_materials_unlit": {}})");
    EXPECT_EQ(unlit.emission.value, Vec3(0.2f, 0.4f, 0.6f));
    EXPECT_EQ(unlit.color.value, Vec3(0.0f));
}

TEST_F(Gltf, WhatGlintDoesNotDrawIsSaidOnceOfEachKind) {
    const SceneDescription scene = load(gltf(R"("materials": [{"name": "a", "alphaMode": "MASK",
        "pbrMetallicRoughness": {"metallicFactor": 0.7}, "extensions": {"KHR_materials_sheen": {}}}],
        "animations": [{"channels": [], "samplers": []}])"));
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("nothing is cut out: \"a\"")));
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("between metal, glass and neither")));
    EXPECT_THAT(scene.warnings,
                Contains(HasSubstr("extensions of materials are left out: \"KHR_materials_sheen\"")));
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("animations are left out")));
    EXPECT_FALSE(loadScene(scene.path, {.strict = true}));
}

TEST_F(Gltf, TexturesArePlacedAndMultiplied) {
    // The top half of the image is red.
    std::vector<uint8_t> rgb(3 * 4 * 4, 0);
    for (size_t i = 0; i < 8; ++i) {
        rgb[3 * i] = 255;
    }
    ASSERT_TRUE(savePng(folder.path("t.png"), {4, 4, rgb}));
    const std::string more =
        R"("images": [{"uri": "t.png"}], "samplers": [{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728}],
        "textures": [{"source": 0, "sampler": 0}], "materials": [{"pbrMetallicRoughness": {"metallicFactor": 0,
        "baseColorFactor": [0.5, 1, 1, 1], "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform":
        {"offset": [0.25, 0.5], "rotation": 1.5707963, "scale": [2, 3]}}}}}])";
    const SceneDescription scene = load(gltf(more));
    ASSERT_EQ(scene.textures.size(), 1u);
    const Texture& texture = scene.textures[0];
    EXPECT_TRUE(texture.flipV) << "v counts from the top row";
    EXPECT_EQ(texture.wrapU, WrapMode::Clamp);
    EXPECT_EQ(texture.wrapV, WrapMode::Mirror);
    EXPECT_EQ(texture.filter, TexelFilter::Nearest);
    EXPECT_EQ(texture.scale, Vec2(2, 3));
    EXPECT_EQ(texture.offset, Vec2(0.25f, 0.5f));
    EXPECT_NEAR(texture.rotationDeg, 90.0f, 1e-3f);
    EXPECT_EQ(texture.encoding, ColorEncoding::Srgb);
    EXPECT_EQ(scene.meshes[0].data->colors[0], Vec3(0.5f, 1.0f, 1.0f)) << "the factor, on the vertices";
    // In a data URI, and in the buffer; a missing one is a warning.
    const std::string png = base64(readFile(folder.path("t.png")).value());
    std::string inside = more;
    inside.replace(inside.find("t.png"), 5, "data:image/png;base64," + png);
    EXPECT_TRUE(load(gltf(inside)).textures.at(0).image.isRead());
    std::string gone = more;
    gone.replace(gone.find("t.png"), 5, "gone.png");
    const SceneDescription without = load(gltf(gone));
    EXPECT_THAT(without.warnings, Contains(HasSubstr("images cannot be read")));
    EXPECT_EQ(without.materials[0].color.texture, -1);
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
