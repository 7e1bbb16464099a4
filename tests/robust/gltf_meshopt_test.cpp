// EXT_meshopt_compression: what the library's encoder writes is read as what
// was written, and broken files give one error.
#include <random>

#include <gmock/gmock.h>
#include <meshoptimizer.h>

#include "tests/support/gltf_test.h"
#include "tests/support/torus_mesh.h"

namespace glint::test {
namespace {

using testing::HasSubstr;

using Bytes = std::vector<unsigned char>;

std::string textOf(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

template <class Vector>
std::string packedVertices(const std::vector<Vector>& values) {
    Bytes out(meshopt_encodeVertexBufferBound(values.size(), sizeof(Vector)));
    out.resize(
        meshopt_encodeVertexBuffer(out.data(), out.size(), values.data(), values.size(), sizeof(Vector)));
    return textOf(out);
}

/// A glTF file whose views are unpacked from these bytes, each with the members of its extension.
struct PackedFile {
    std::string buffer, views, fallback;
    size_t count = 0;

    void add(const std::string& bytes, const std::string& members, size_t size) {
        views += (count++ > 0 ? ", " : "") + std::string(R"({"buffer": 1, "byteLength": )") +
                 std::to_string(size) +
                 R"(, "extensions": {"EXT_meshopt_compression": {"buffer": 0, "byteOffset": )" +
                 std::to_string(buffer.size()) + R"(, "byteLength": )" + std::to_string(bytes.size()) + ", " +
                 members + "}}}";
        buffer += bytes;
        buffer.resize((buffer.size() + 3) / 4 * 4);
    }
    std::string json(const std::string& accessors, const std::string& attributes,
                     bool isBinary = false) const {
        const std::string uri =
            isBinary ? "" : R"(, "uri": "data:application/octet-stream;base64,)" + base64(buffer) + '"';
        return R"({"asset": {"version": "2.0"}, "extensionsUsed": ["EXT_meshopt_compression"], "extensionsRequired":
            ["EXT_meshopt_compression"], "buffers": [{"byteLength": )" +
               std::to_string(buffer.size()) + uri +
               R"(}, {"byteLength": 1099511627776, "extensions": {"EXT_meshopt_compression": {"fallback": true}}}],
            "bufferViews": [)" +
               views + R"(], "accessors": [)" + accessors +
               R"(], "meshes": [{"primitives": [{"attributes": {)" + attributes +
               R"(}, "indices": 0}]}], "nodes": [{"mesh": 0}]})";
    }
};

std::string accessor(size_t view, int type, size_t count, const char* kind, bool isNormalized = false) {
    return R"({"bufferView": )" + std::to_string(view) + R"(, "componentType": )" + std::to_string(type) +
           R"(, "count": )" + std::to_string(count) + R"(, "type": ")" + kind + '"' +
           (isNormalized ? R"(, "normalized": true})" : "}");
}

std::string members(size_t count, size_t stride, const char* mode, const char* filter = "NONE") {
    return R"("count": )" + std::to_string(count) + R"(, "byteStride": )" + std::to_string(stride) +
           R"(, "mode": ")" + mode + R"(", "filter": ")" + filter + '"';
}

PackedFile packedTorus() {
    const MeshData& mesh = torus();
    const size_t vertices = mesh.positions.size();
    Bytes indices(meshopt_encodeIndexBufferBound(mesh.indices.size(), vertices));
    indices.resize(
        meshopt_encodeIndexBuffer(indices.data(), indices.size(), mesh.indices.data(), mesh.indices.size()));
    PackedFile file;
    file.add(textOf(indices), members(mesh.indices.size(), 4, "TRIANGLES"), 4 * mesh.indices.size());
    file.add(packedVertices(mesh.positions), members(vertices, 12, "ATTRIBUTES"), 12 * vertices);
    file.add(packedVertices(mesh.uvs), members(vertices, 8, "ATTRIBUTES"), 8 * vertices);
    return file;
}

std::string torusAccessors() {
    const size_t vertices = torus().positions.size();
    return accessor(0, 5125, torus().indices.size(), "SCALAR") + ", " + accessor(1, 5126, vertices, "VEC3") +
           ", " + accessor(2, 5126, vertices, "VEC2");
}
constexpr const char* kTorusAttributes = R"("POSITION": 1, "TEXCOORD_0": 2)";

/// The same corners of each triangle, in any turn.
void expectSameTriangles(const MeshData& a, const MeshData& b, float tolerance) {
    ASSERT_EQ(a.indices.size(), b.indices.size());
    for (size_t i = 0; i < a.indices.size(); i += 3) {
        Vec3 centreA(0.0f), centreB(0.0f);
        for (size_t c = 0; c < 3; ++c) {
            centreA += a.positions[a.indices[i + c]] / 3.0f;
            centreB += b.positions[b.indices[i + c]] / 3.0f;
        }
        ASSERT_LE(glm::length(centreA - centreB), tolerance) << i;
    }
}

using GltfMeshopt = GltfTest;

TEST_F(GltfMeshopt, TextAndBinaryFilesAreUnpacked) {
    const PackedFile file = packedTorus();
    const SceneDescription text = load(file.json(torusAccessors(), kTorusAttributes));
    ASSERT_EQ(text.meshes.size(), 1u);
    expectSameTriangles(*text.meshes[0].data, torus(), 1e-6f);
    EXPECT_EQ(text.meshes[0].data->positions, torus().positions) << "bit for bit";
    std::string chunk = file.json(torusAccessors(), kTorusAttributes, true);
    chunk.resize((chunk.size() + 3) / 4 * 4, ' ');
    const auto size = [](size_t bytes) { return static_cast<uint32_t>(bytes); };
    const std::string glb =
        "glTF" + packed<uint32_t>({2, size(28 + chunk.size() + file.buffer.size()), size(chunk.size())}) +
        "JSON" + chunk + packed<uint32_t>({size(file.buffer.size())}) + std::string("BIN\0", 4) + file.buffer;
    const SceneDescription binary = load(glb, "a.glb");
    ASSERT_EQ(binary.meshes.size(), 1u);
    EXPECT_EQ(binary.meshes[0].data->positions, torus().positions);
    EXPECT_EQ(binary.meshes[0].data->indices, text.meshes[0].data->indices);
}

/// Octahedral normals of 8 and 16 bits, exponential positions, and indices of no triangles' order.
TEST_F(GltfMeshopt, FiltersAreUndone) {
    const MeshData& mesh = torus();
    const size_t vertices = mesh.positions.size();
    std::vector<float> normals;
    for (const Vec3& normal : mesh.normals) {
        const Vec3 n = glm::normalize(normal);
        normals.insert(normals.end(), {n.x, n.y, n.z, 0.0f});
    }
    for (const bool isShort : {false, true}) {
        const size_t stride = isShort ? 8 : 4;
        Bytes octahedral(stride * vertices), exponential(12 * vertices);
        meshopt_encodeFilterOct(octahedral.data(), vertices, stride, isShort ? 14 : 8, normals.data());
        meshopt_encodeFilterExp(exponential.data(), vertices, 12, 20, &mesh.positions[0].x);
        const auto pack = [vertices](const Bytes& bytes, size_t size) {
            Bytes out(meshopt_encodeVertexBufferBound(vertices, size));
            out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), bytes.data(), vertices, size));
            return textOf(out);
        };
        Bytes sequence(meshopt_encodeIndexSequenceBound(mesh.indices.size(), vertices));
        sequence.resize(meshopt_encodeIndexSequence(sequence.data(), sequence.size(), mesh.indices.data(),
                                                    mesh.indices.size()));
        PackedFile file;
        file.add(textOf(sequence), members(mesh.indices.size(), 4, "INDICES"), 4 * mesh.indices.size());
        file.add(pack(exponential, 12), members(vertices, 12, "ATTRIBUTES", "EXPONENTIAL"), 12 * vertices);
        file.add(pack(octahedral, stride), members(vertices, stride, "ATTRIBUTES", "OCTAHEDRAL"),
                 stride * vertices);
        file.views.insert(file.views.rfind("\"byteLength\": " + std::to_string(stride * vertices)),
                          "\"byteStride\": " + std::to_string(stride) + ", ");
        const SceneDescription scene = load(file.json(
            accessor(0, 5125, mesh.indices.size(), "SCALAR") + ", " + accessor(1, 5126, vertices, "VEC3") +
                ", " + accessor(2, isShort ? 5122 : 5120, vertices, "VEC3", true),
            R"("POSITION": 1, "NORMAL": 2)"));
        ASSERT_EQ(scene.meshes.size(), 1u);
        const MeshData& read = *scene.meshes[0].data;
        EXPECT_EQ(read.indices, mesh.indices);
        ASSERT_EQ(read.normals.size(), vertices);
        for (size_t i = 0; i < vertices; ++i) {
            ASSERT_LT(glm::length(read.positions[i] - mesh.positions[i]), 1e-5f);
            ASSERT_GT(glm::dot(glm::normalize(read.normals[i]), glm::normalize(mesh.normals[i])),
                      isShort ? 0.9999f : 0.999f);
        }
    }
}

/// The torus's bytes by Draco; the ids of positions and texture coordinates are 0 and 1.
TEST_F(GltfMeshopt, WhatDoesNotFitIsRefused) {
    const std::string good = packedTorus().json(torusAccessors(), kTorusAttributes);
    const auto errorOf = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        const size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        const auto scene = loadScene(folder.write("bad.gltf", text.replace(at, from.size(), to)));
        return scene ? "no error" : scene.error().format();
    };
    EXPECT_THAT(errorOf("\"mode\": \"TRIANGLES\"", "\"mode\": \"STRIPS\""), HasSubstr("makes no sense"));
    EXPECT_THAT(errorOf("\"byteStride\": 12", "\"byteStride\": 13"), HasSubstr("makes no sense"));
    EXPECT_THAT(errorOf("\"byteStride\": 12", "\"byteStride\": -4"), HasSubstr("makes no sense"));
    EXPECT_THAT(errorOf("\"filter\": \"NONE\"", "\"filter\": \"OCTAHEDRAL\""), HasSubstr("makes no sense"));
    EXPECT_THAT(errorOf("\"count\": ", "\"count\": 300000"), HasSubstr("are more than its"));
    EXPECT_THAT(errorOf("{\"buffer\": 0, \"byteOffset\": 0", "{\"buffer\": 5, \"byteOffset\": 0"),
                HasSubstr("there is no such buffer"));
    EXPECT_THAT(errorOf("{\"buffer\": 0, \"byteOffset\": 0", "{\"buffer\": 0, \"byteOffset\": 1999999999"),
                HasSubstr("ends beyond its buffer"));
    EXPECT_THAT(
        errorOf("\"byteOffset\": 0, \"byteLength\": ", "\"byteOffset\": 0, \"byteLength\": 1, \"was\": "),
        HasSubstr("are more than its"));
}

/// Whatever the bytes are: a scene or an error.
TEST_F(GltfMeshopt, DamagedBytesNeverCrash) {
    std::mt19937 random(1);
    for (int i = 0; i < 300; ++i) {
        PackedFile file = packedTorus();
        for (int k = 0; k < 1 + i % 8; ++k) {
            file.buffer[random() % file.buffer.size()] = static_cast<char>(random());
        }
        (void)loadScene(folder.write("bad.gltf", file.json(torusAccessors(), kTorusAttributes)));
    }
}

}  // namespace
}  // namespace glint::test
