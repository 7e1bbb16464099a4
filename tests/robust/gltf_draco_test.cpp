// KHR_draco_mesh_compression: what the library's encoder writes is read as what was written, and broken files
// give one error.
#include <random>

#include <draco/compression/decode.h>
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gmock/gmock.h>

#include "tests/support/gltf_test.h"
#include "tests/support/torus_mesh.h"

namespace glint::test {
namespace {

using testing::HasSubstr;

using GltfDraco = GltfTest;

std::string dracoTorus(int method) {
    const MeshData& mesh = torus();
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(static_cast<int>(mesh.triangleCount()));
    const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int uvs = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
    for (uint32_t i = 0; i < mesh.triangleCount(); ++i) {
        const uint32_t* c = &mesh.indices[3 * size_t{i}];
        const draco::FaceIndex face(i);
        builder.SetAttributeValuesForFace(positions, face, &mesh.positions[c[0]], &mesh.positions[c[1]],
                                          &mesh.positions[c[2]]);
        builder.SetAttributeValuesForFace(uvs, face, &mesh.uvs[c[0]], &mesh.uvs[c[1]], &mesh.uvs[c[2]]);
    }
    const std::unique_ptr<draco::Mesh> packed = builder.Finalize();
    draco::Encoder encoder;
    encoder.SetEncodingMethod(method);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 16);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*packed, &buffer).ok());
    return {buffer.data(), buffer.size()};
}

std::string dracoFile(const std::string& bytes, size_t vertices, const std::string& attributes) {
    const std::string primitive =
        R"({"attributes": {"POSITION": 1, "TEXCOORD_0": 2}, "indices": 0, "extensions":
        {"KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {)" +
        attributes + "}}}}";
    return R"({"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_draco_mesh_compression"], "extensionsRequired":
        ["KHR_draco_mesh_compression"], "buffers": [{"byteLength": )" +
           std::to_string(bytes.size()) + R"(, "uri": "data:application/octet-stream;base64,)" +
           base64(bytes) + R"("}], "bufferViews": [{"buffer": 0, "byteLength": )" +
           std::to_string(bytes.size()) + R"(}], "accessors": [{"componentType": 5125, "count": )" +
           std::to_string(torus().indices.size()) +
           R"(, "type": "SCALAR"}, {"componentType": 5126, "count": )" + std::to_string(vertices) +
           R"(, "type": "VEC3"}, {"componentType": 5126, "count": )" + std::to_string(vertices) +
           R"(, "type": "VEC2"}], "meshes": [{"primitives": [)" + primitive + ", " + primitive +
           R"(]}], "nodes": [{"mesh": 0}]})";
}

/// How many vertices Draco makes of the torus's.
size_t dracoVertices(const std::string& bytes) {
    draco::DecoderBuffer buffer;
    buffer.Init(bytes.data(), bytes.size());
    return draco::Decoder().DecodeMeshFromBuffer(&buffer).value()->num_points();
}

constexpr const char* kDracoIds = R"("POSITION": 0, "TEXCOORD_0": 1)";

TEST_F(GltfDraco, BothMethodsAreUnpacked) {
    for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
        const std::string bytes = dracoTorus(method);
        const SceneDescription scene = load(dracoFile(bytes, dracoVertices(bytes), kDracoIds));
        EXPECT_EQ(scene.objects.size(), 2u);
        ASSERT_EQ(scene.meshes.size(), 1u) << "primitives of the same bytes share their mesh";
        const MeshData& mesh = *scene.meshes[0].data;
        ASSERT_EQ(mesh.indices.size(), torus().indices.size());
        float volume = 0.0f;
        for (size_t i = 0; i < mesh.indices.size(); i += 3) {
            volume +=
                glm::dot(mesh.positions[mesh.indices[i]], glm::cross(mesh.positions[mesh.indices[i + 1]],
                                                                     mesh.positions[mesh.indices[i + 2]])) /
                6.0f;
        }
        EXPECT_NEAR(volume, 2.0f * kPi * kPi * 0.16f, 0.05f) << "the front outside";
    }
}

TEST_F(GltfDraco, WhatDoesNotFitIsRefused) {
    const std::string bytes = dracoTorus(draco::MESH_EDGEBREAKER_ENCODING);
    const size_t vertices = dracoVertices(bytes);
    const auto errorOf = [&](const std::string& text) {
        const auto scene = loadScene(folder.write("bad.gltf", text));
        return scene ? "no error" : scene.error().format();
    };
    EXPECT_THAT(errorOf(dracoFile(bytes.substr(0, bytes.size() / 2), vertices, kDracoIds)),
                HasSubstr("is broken"));
    EXPECT_THAT(errorOf(dracoFile(bytes, vertices - 1, kDracoIds)), HasSubstr("its accessor states"));
    EXPECT_THAT(errorOf(dracoFile(bytes, vertices, R"("POSITION": 7)")), HasSubstr("has no POSITION"));
    EXPECT_THAT(errorOf(dracoFile("DRACO", vertices, kDracoIds)),
                HasSubstr("is no Draco mesh of version 2.2"));
    std::string many = bytes;
    many.replace(12, 5, "\xff\xff\xff\xff\x07");
    EXPECT_THAT(errorOf(dracoFile(many, vertices, kDracoIds)), HasSubstr("are more than its"));
}

/// A thousand views of the same bytes.
TEST_F(GltfDraco, WhatUnpacksToTooMuchIsRefused) {
    const std::string bytes = dracoTorus(draco::MESH_EDGEBREAKER_ENCODING);
    std::string text = dracoFile(bytes, dracoVertices(bytes), kDracoIds);
    std::string views, primitives;
    constexpr int kViews = 2000;
    for (int i = 0; i < kViews; ++i) {
        views += R"({"buffer": 0, "byteLength": )" + std::to_string(bytes.size()) + "},";
        primitives += R"({"attributes": {"POSITION": 1}, "indices": 0, "extensions":
            {"KHR_draco_mesh_compression": {"bufferView": )" +
                      std::to_string(i) + R"(, "attributes": {"POSITION": 0}}}},)";
    }
    const std::string viewsKey = "\"bufferViews\": [", primitivesKey = "\"primitives\": [";
    text.insert(text.find(viewsKey) + viewsKey.size(), views);
    text.insert(text.find(primitivesKey) + primitivesKey.size(), primitives);
    const auto scene = loadScene(folder.write("many.gltf", text));
    ASSERT_FALSE(scene);
    EXPECT_THAT(scene.error().format(), HasSubstr("unpack to too much"));
}

/// Whatever the bytes are: a scene or an error.
TEST_F(GltfDraco, DamagedBytesNeverCrash) {
    std::mt19937 random(1);
    const std::string sound = dracoTorus(draco::MESH_EDGEBREAKER_ENCODING);
    const size_t vertices = dracoVertices(sound);
    for (int i = 0; i < 300; ++i) {
        std::string bytes = sound;
        for (int k = 0; k < 1 + i % 8; ++k) {
            bytes[random() % bytes.size()] = static_cast<char>(random());
        }
        (void)loadScene(folder.write("bad.gltf", dracoFile(bytes, vertices, kDracoIds)));
    }
}

}  // namespace
}  // namespace glint::test
