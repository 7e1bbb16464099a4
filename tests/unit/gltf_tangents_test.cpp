// glTF's TANGENT: shading normals and directions of highlights against closed forms, poses, repairs, and what
// is saved.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/builders/tangent_builder.h"
#include "engine/io/image_io.h"
#include "engine/io/scene_json.h"
#include "engine/kernels/intersect.h"
#include "engine/kernels/surface.h"
#include "engine/scene/scene_building.h"
#include "engine/scene/scene_hash.h"
#include "tests/support/gltf_export_test.h"
#include "tests/support/render_scene.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr FeatureMask kMask = kAllFeatures | kFeatureTangents;
/// x and y of the normal that a map of these codes has.
const Vec3 kCoded = 2.0f * Vec3(205.0f, 153.0f, 230.0f) / 255.0f - Vec3(1.0f);
const std::string kNormalMap = material(R"("doubleSided": true, "normalTexture": {"index": 0})") +
                               R"(, "textures": [{"source": 0}], "images": [{"uri": "n.png"}])";
const std::string kBrushed = material(
    R"("pbrMetallicRoughness": {"roughnessFactor": 0.4}, "extensions": {"KHR_materials_anisotropy":
    {"anisotropyStrength": 0.8}})");

/// The square of gltf_files.h with normals, and with tangents whose type the accessor says.
class GltfTangents : public GltfExportTest {
  protected:
    GltfTangents() { EXPECT_TRUE(savePng(folder.path("n.png"), {1, 1, {205, 153, 230}})); }

    static std::string text(const std::string& tangents, const std::string& more = kNormalMap,
                            const std::string& type = R"("componentType": 5126, "type": "VEC4")",
                            const std::string& node = kNode, const std::string& mesh = "") {
        const std::string buffer = kSquare + packed<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}) + tangents;
        const std::string views =
            R"("bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32},
            {"buffer": 0, "byteOffset": 80, "byteLength": 12}, {"buffer": 0, "byteOffset": 92, "byteLength": 48},
            {"buffer": 0, "byteOffset": 140, "byteLength": )" +
            std::to_string(std::max<size_t>(tangents.size(), 1)) + R"(}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"},
            {"bufferView": 3, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 4, "count": 4, )" +
            type + "}]";
        const std::string has = tangents.empty() ? "" : R"(, "TANGENT": 4)";
        const std::string own = R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1,
            "NORMAL": 3)" + has +
                                R"(}, "indices": 2, "material": 0}]}])";
        return gltf(more, mesh.empty() ? own : mesh, node, views, buffer);
    }
    static std::string same(const Vec4& tangent) {
        std::string out;
        for (int i = 0; i < 4; ++i) {
            out += packed<float>({tangent.x, tangent.y, tangent.z, tangent.w});
        }
        return out;
    }
    /// At (0.3, 0.2, 0), seen from +z.
    static SurfacePoint surfaceOf(const SceneDescription& scene) {
        const auto built = buildAll(scene);
        EXPECT_TRUE(built);
        const Ray ray{Vec3(0.3f, 0.2f, 4.0f), Vec3(0.0f, 0.0f, -1.0f)};
        Hit hit;
        if (!built || !intersect<kMask>(built->view(), ray, &hit)) {
            ADD_FAILURE() << "no hit";
            return {};
        }
        return surfaceAt<kMask>(built->view(), ray, hit);
    }
    Vec3 normalOf(const std::string& gltfText) { return surfaceOf(load(gltfText)).ns; }
    static void expectNormal(const Vec3& normal, const Vec3& right, const Vec3& top) {
        const Vec3 expected =
            glm::normalize(kCoded.x * right + kCoded.y * top + kCoded.z * Vec3(0.0f, 0.0f, 1.0f));
        EXPECT_LT(glm::length(normal - expected), 1e-5f)
            << normal.x << " " << normal.y << " for " << expected.x << " " << expected.y;
    }
};

TEST_F(GltfTangents, TurnNormalMaps) {
    const Vec3 x(1, 0, 0), y(0, 1, 0);
    expectNormal(normalOf(text("")), x, y);
    expectNormal(normalOf(text(same({1, 0, 0, 1}))), x, y);
    expectNormal(normalOf(text(same({0, 1, 0, 1}))), y, -x);
    expectNormal(normalOf(text(same({1, 0, 0, -1}))), x, -y);
    expectNormal(normalOf(text(same({0, -1, 0, -1}))), -y, -x);
    // Only the part along the surface counts.
    expectNormal(normalOf(text(same({0, 0.6f, 0.8f, 1}))), y, -x);
    // The place of the image does not turn them.
    std::string placed = kNormalMap;
    placed.replace(placed.find("\"index\": 0"), 10,
                   R"("index": 0, "extensions": {"KHR_texture_transform": {"rotation": 1}})");
    expectNormal(normalOf(text(same({0, 1, 0, 1}), placed)), y, -x);
}

TEST_F(GltfTangents, FollowTheNodes) {
    const auto under = [&](const std::string& node, const Vec4& tangent) {
        return normalOf(text(same(tangent), kNormalMap, R"("componentType": 5126, "type": "VEC4")",
                             R"("nodes": [{"mesh": 0, )" + node + "}]"));
    };
    const Vec3 x(1, 0, 0), y(0, 1, 0);
    expectNormal(under(R"("rotation": [0, 0, 0.70710678, 0.70710678])", {1, 0, 0, 1}), y, -x);
    expectNormal(under(R"("scale": [-1, 1, 1])", {1, 0, 0, 1}), -x, y);
    expectNormal(under(R"("scale": [2, 1, 1])", {0, 1, 0, 1}), y, -x);
}

TEST_F(GltfTangents, EveryTypeAndSparse) {
    const Vec3 x(1, 0, 0), y(0, 1, 0);
    std::string bytes, shorts;
    for (int i = 0; i < 4; ++i) {
        bytes += packed<int8_t>({0, 127, 0, -127});
        shorts += packed<int16_t>({0, 32767, 0, -32767});
    }
    expectNormal(
        normalOf(text(bytes, kNormalMap, R"("componentType": 5120, "normalized": true, "type": "VEC4")")), y,
        x);
    expectNormal(
        normalOf(text(shorts, kNormalMap, R"("componentType": 5122, "normalized": true, "type": "VEC4")")), y,
        x);
    const std::string sparse =
        R"("componentType": 5126, "type": "VEC4", "sparse": {"count": 1, "indices": {"bufferView": 2,
        "componentType": 5123}, "values": {"bufferView": 3}})";
    const SceneDescription scene = load(text(same({0, 1, 0, 1}), kNormalMap, sparse));
    EXPECT_EQ(scene.meshes.at(0).data->tangents.at(0), Vec4(0, 0, 0, 0))
        << "the first four numbers of normals";
    EXPECT_EQ(scene.meshes[0].data->tangents.at(1), Vec4(0, 1, 0, -1));
}

TEST_F(GltfTangents, DamagedOnesFollowTheTextureCoordinates) {
    const Vec3 x(1, 0, 0), y(0, 1, 0);
    for (const Vec4& bad :
         {Vec4(0, 0, 0, 1), Vec4(NAN, 0, 0, 1), Vec4(0, 1, 0, 0), Vec4(0, INFINITY, 0, 1)}) {
        const SceneDescription scene = load(text(same(bad)));
        EXPECT_THAT(scene.warnings, Contains(HasSubstr("tangents without a direction or a side")));
        expectNormal(surfaceOf(scene).ns, x, y);
    }
    const std::string one = packed<float>({0, 0, 0, 1}) + same({0, 1, 0, 1}).substr(16);
    expectNormal(normalOf(text(one)), y, -x);
    const SceneDescription wide =
        load(text(same({0, 1, 0, 1}), kNormalMap, R"("componentType": 5126, "type": "VEC3")"));
    EXPECT_THAT(wide.warnings, Contains(HasSubstr("tangents that cannot be read")));
    expectNormal(surfaceOf(wide).ns, x, y);
    const SceneDescription flat =
        load(text(same({0, 1, 0, 1}), kNormalMap, R"("componentType": 5126, "type": "VEC4")", kNode,
                  R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "TANGENT": 4},
             "indices": 2, "material": 0}]}])"));
    EXPECT_THAT(flat.warnings, Contains(HasSubstr("tangents without normals")));
    expectNormal(surfaceOf(flat).ns, x, y);
}

TEST_F(GltfTangents, AreThoseOfHighlights) {
    const SceneDescription turned = load(text(same({0.6f, 0.8f, 0, 1}), kBrushed));
    SurfacePoint point = surfaceOf(turned);
    EXPECT_NEAR(std::fabs(glm::dot(glm::normalize(point.dpdu), Vec3(0.6f, 0.8f, 0.0f))), 1.0f, 1e-6f);
    // v is counted downwards.
    EXPECT_NEAR(glm::dot(glm::normalize(point.dpdv), Vec3(0.8f, -0.6f, 0.0f)), 1.0f, 1e-6f);
    point = surfaceOf(load(text(same({0.6f, 0.8f, 0, -1}), kBrushed)));
    EXPECT_NEAR(glm::dot(glm::normalize(point.dpdv), Vec3(0.8f, -0.6f, 0.0f)), -1.0f, 1e-6f);
    EXPECT_EQ(buildAll(turned)->tangents.at(0), nullptr) << "none are made";
    // A turn by the material of 30 degrees is one of the tangents.
    std::string more = kBrushed;
    more.replace(more.find("\"anisotropyStrength\""), 20,
                 R"("anisotropyRotation": 0.5, "anisotropyStrength")");
    SceneDescription lit = load(text(same({1, 0, 0, 1}), more));
    SceneDescription same5 = load(text(same({std::cos(0.5f), std::sin(0.5f), 0, 1}), kBrushed));
    for (SceneDescription* scene : {&lit, &same5}) {
        scene->environment.color = Vec3(0.0f);
        scene->lights = {directionalLight(glm::normalize(Vec3(-0.4f, -0.3f, -1.0f)))};
        scene->camera.position = {0.5f, -1.0f, 3.0f};
        scene->camera.target = Vec3(0.0f);
        scene->resolution = {8, 8};
    }
    const double a = meanLuminance(renderFilm(lit, 4)).mean, b = meanLuminance(renderFilm(same5, 4)).mean;
    EXPECT_GT(a, 0.0);
    EXPECT_NEAR(a, b, 1e-4 * a);
    SceneDescription without = same5;
    without.meshes[0].data = load(text("", kBrushed)).meshes[0].data;
    EXPECT_GT(std::fabs(meanLuminance(renderFilm(without, 4)).mean - a), 0.02 * a);
}

/// Nothing is kept of them, and films and fingerprints are those of a file without.
TEST_F(GltfTangents, AreReadWhereAMaterialUsesThem) {
    const std::string plain = material("");
    const SceneDescription with = load(text(same({0, 1, 0, 1}), plain)), without = load(text("", plain));
    EXPECT_THAT(with.meshes.at(0).data->tangents, IsEmpty());
    EXPECT_EQ(hashSceneParts(with), hashSceneParts(without));
    const SceneDescription mapped = load(text("")), turned = load(text(same({0, 1, 0, 1})));
    EXPECT_NE(hashSceneParts(mapped), hashSceneParts(turned));
    EXPECT_EQ(buildAll(mapped)->view().geometry.meshes[0].ownTangents, nullptr);
}

TEST_F(GltfTangents, MorphTargetsMoveThem) {
    const std::string mesh =
        R"("meshes": [{"weights": [0.5], "primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "NORMAL": 3,
        "TANGENT": 4}, "indices": 2, "material": 0, "targets": [{"TANGENT": 3}]}]}])";
    const SceneDescription scene =
        load(text(same({0, 1, 0, 1}), kNormalMap, R"("componentType": 5126, "type": "VEC4")", kNode, mesh));
    EXPECT_EQ(scene.meshes.at(0).data->tangents.at(2), Vec4(0, 1, 0.5f, -1));
}

TEST_F(GltfTangents, SkinsMoveThem) {
    // One joint that turns by a right angle about z, for all corners.
    std::string buffer = kSquare + packed<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}) + same({1, 0, 0, 1});
    for (int i = 0; i < 4; ++i) {
        buffer += packed<float>({1, 0, 0, 0});
    }
    buffer += packed<uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    const std::string views =
        R"("bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32},
        {"buffer": 0, "byteOffset": 80, "byteLength": 12}, {"buffer": 0, "byteOffset": 92, "byteLength": 48},
        {"buffer": 0, "byteOffset": 140, "byteLength": 64}, {"buffer": 0, "byteOffset": 204, "byteLength": 64},
        {"buffer": 0, "byteOffset": 268, "byteLength": 16}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
        {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"},
        {"bufferView": 3, "componentType": 5126, "count": 4, "type": "VEC3"},
        {"bufferView": 4, "componentType": 5126, "count": 4, "type": "VEC4"},
        {"bufferView": 5, "componentType": 5126, "count": 4, "type": "VEC4"},
        {"bufferView": 6, "componentType": 5121, "count": 4, "type": "VEC4"}])";
    const std::string mesh =
        R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "NORMAL": 3, "TANGENT": 4,
        "WEIGHTS_0": 5, "JOINTS_0": 6}, "indices": 2, "material": 0}]}])";
    const SceneDescription scene = load(gltf(
        kNormalMap + R"(, "skins": [{"joints": [1]}], "scene": 0, "scenes": [{"nodes": [0, 1]}])", mesh,
        R"("nodes": [{"mesh": 0, "skin": 0}, {"rotation": [0, 0, 0.70710678, 0.70710678]}])", views, buffer));
    EXPECT_LT(glm::length(scene.meshes.at(0).data->tangents.at(1) - Vec4(0, 1, 0, -1)), 1e-6f);
    expectNormal(surfaceOf(scene).ns, Vec3(0, 1, 0), Vec3(-1, 0, 0));
}

TEST_F(GltfTangents, SavedScenesAndFilesKeepThem) {
    for (const Vec4& tangent : {Vec4(0.6f, 0.8f, 0, 1), Vec4(0, -1, 0, -1)}) {
        const SceneDescription scene = load(text(same(tangent)));
        const auto& before = scene.meshes.at(0).data->tangents;
        const std::string path = folder.path("saved.json");
        ASSERT_TRUE(saveSceneJson(scene, path));
        const auto saved = loadScene(path, {.noStudio = true});
        ASSERT_TRUE(saved) << saved.error().format();
        EXPECT_EQ(saved->meshes.at(0).data->tangents, before);
        const SceneDescription written = exported(scene, "out.gltf");
        EXPECT_EQ(written.meshes.at(0).data->tangents, before);
        // Images that count v upwards: the file has other texture coordinates, and the same picture.
        SceneDescription upwards = scene;
        upwards.textures[0].flipV = false;
        const SceneDescription turned = exported(upwards, "up.glb");
        EXPECT_LT(glm::length(surfaceOf(turned).ns - surfaceOf(upwards).ns), 1e-5f);
        EXPECT_GT(glm::length(surfaceOf(turned).ns - surfaceOf(scene).ns), 0.1f);
        // Sheared and mirrored objects are written as they lie.
        SceneDescription sheared = scene;
        sheared.objects[0].objectToWorld.linear = Mat3(-1, 0.3f, 0, 0, 1, 0, 0, 0, 1);
        EXPECT_LT(glm::length(surfaceOf(exported(sheared, "s.glb")).ns - surfaceOf(sheared).ns), 1e-5f);
        EXPECT_THAT(warnings, Not(Contains(HasSubstr("tangents"))));
    }
}

/// A normal map that counts v the other way than the colour's image turns the tangents' side.
TEST_F(GltfTangents, ImagesThatDisagreeKeepTheDirectionOfHighlights) {
    for (const bool normalsFromTop : {false, true}) {
        for (const bool colorFromTop : {false, true}) {
            SceneDescription scene = load(text(same({0.6f, 0.8f, 0, 1})));
            Material& brushed = scene.materials.at(0);
            brushed.roughness.value = 0.6f, brushed.crossRoughness.value = 0.2f;
            brushed.anisotropyRotationDeg = 30.0f;
            scene.textures.at(0).flipV = normalsFromTop;
            scene.textures.push_back(scene.textures[0]);
            scene.textures[1].flipV = colorFromTop;
            brushed.color.texture = 1;
            const SceneDescription written = exported(scene, "out.gltf");
            const auto turn = [](const SceneDescription& of) {
                return of.materials.at(0).anisotropyRotationDeg * of.meshes.at(0).data->tangents.at(0).w;
            };
            EXPECT_NEAR(turn(written), turn(scene), 1e-3f) << normalsFromTop << colorFromTop;
        }
    }
}

TEST_F(GltfTangents, WhatLosesThemSaysSo) {
    const SceneDescription scene = load(text(same({0, 1, 0, 1})));
    for (const char* name : {"out.pbrt", "out.xml"}) {
        warnings.clear();
        ASSERT_TRUE(exporterOf(folder.path(name))->save(scene, folder.path(name), &warnings));
        EXPECT_THAT(warnings, Contains(HasSubstr("tangents run as the texture coordinates"))) << name;
    }
    const std::string one = packed<float>({0, 0, 0, 1}) + same({0, 1, 0, 1}).substr(16);
    exported(load(text(one)));
    EXPECT_THAT(warnings, Contains(HasSubstr("where a mesh lacks some")));
}

}  // namespace
}  // namespace glint::test
