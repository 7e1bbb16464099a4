// glTF 2.0 specification, sections 3.6 and 4.
#include "engine/io/gltf_writer.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>

#include <fmt/format.h>

namespace glint {
namespace {

constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kVertexData = 34962, kIndexData = 34963;

template <class Value>
std::string_view bytesOf(std::span<const Value> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

void appendNumber(uint32_t number, std::string* out) {
    *out += bytesOf(std::span<const uint32_t>(&number, 1));
}

void pad(char filler, std::string* bytes) { bytes->resize((bytes->size() + 3) / 4 * 4, filler); }

}  // namespace

std::string dumpedGltf(const GltfJson& document) {
    return document.dump(-1, ' ', false, GltfJson::error_handler_t::replace);
}

std::string binaryGltf(std::string json, std::string_view buffer) {
    pad(' ', &json);
    constexpr uint32_t kVersion = 2, kHeaders = 28;
    std::string out = "glTF";
    appendNumber(kVersion, &out);
    appendNumber(static_cast<uint32_t>(kHeaders + json.size() + buffer.size()), &out);
    appendNumber(static_cast<uint32_t>(json.size()), &out);
    out += "JSON" + json;
    appendNumber(static_cast<uint32_t>(buffer.size()), &out);
    return out.append("BIN\0", 4).append(buffer);
}

std::string gltfUri(const std::string& path) {
    std::string uri;
    for (const char c : path) {
        const bool isPlain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                             std::string_view("-._~/").find(c) != std::string_view::npos;
        uri += isPlain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return uri;
}

GltfJson gltfJson(float value) {
    char text[32];
    const char* end = std::to_chars(std::begin(text), std::end(text), value).ptr;
    double number = 0.0;
    std::from_chars(text, end, number);
    return number;
}

GltfJson gltfJson(std::span<const float> values) {
    GltfJson numbers = GltfJson::array();
    for (const float value : values) {
        numbers.push_back(gltfJson(value));
    }
    return numbers;
}

/// What comes first is what the exporter knows its own files by.
GltfWriter::GltfWriter()
    : document_(GltfJson::object({{"asset", {{"generator", "Glint"}, {"version", "2.0"}}}, {"scene", 0}})) {
    add("scenes", GltfJson::object({{"nodes", GltfJson::array()}}));
}

size_t GltfWriter::add(const char* array, GltfJson object) {
    document_[array].push_back(std::move(object));
    return document_[array].size() - 1;
}

void GltfWriter::addNode(GltfJson node) {
    const size_t index = add("nodes", std::move(node));
    document_["scenes"][0]["nodes"].push_back(index);
}

GltfJson GltfWriter::addLight(GltfJson light) {
    GltfJson& lights = document_["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back(std::move(light));
    GltfJson node;
    extend(&node, "KHR_lights_punctual", GltfJson::object({{"light", lights.size() - 1}}));
    return node;
}

void GltfWriter::extend(GltfJson* object, const char* extension, GltfJson members) {
    (*object)["extensions"][extension] = std::move(members);
    GltfJson& used = document_["extensionsUsed"];
    if (std::ranges::find(used, extension) == used.end()) { used.push_back(extension); }
}

size_t GltfWriter::addView(std::string_view bytes) {
    pad('\0', &buffer_);
    GltfJson view{{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
    buffer_ += bytes;
    return add("bufferViews", std::move(view));
}

size_t GltfWriter::addAccessor(std::string_view bytes, int target, int componentType, size_t count,
                               const char* type) {
    const size_t view = addView(bytes);
    document_["bufferViews"][view]["target"] = target;
    return add("accessors",
               {{"bufferView", view}, {"componentType", componentType}, {"count", count}, {"type", type}});
}

template <class Vector>
size_t GltfWriter::addVectors(std::span<const Vector> values) {
    return addAccessor(bytesOf(values), kVertexData, kFloat, values.size(),
                       fmt::format("VEC{}", Vector::length()).c_str());
}

GltfJson GltfWriter::addPrimitive(const MeshData& mesh, bool flipV) {
    GltfJson attributes;
    const size_t positions = addVectors<Vec3>(mesh.positions);
    Vec3 least = mesh.positions.front(), most = least;
    for (const Vec3& position : mesh.positions) {
        least = glm::min(least, position);
        most = glm::max(most, position);
    }
    document_["accessors"][positions]["min"] = gltfJson(least);
    document_["accessors"][positions]["max"] = gltfJson(most);
    attributes["POSITION"] = positions;
    if (!mesh.normals.empty()) { attributes["NORMAL"] = addVectors<Vec3>(mesh.normals); }
    if (!mesh.tangents.empty()) { attributes["TANGENT"] = addVectors<Vec4>(mesh.tangents); }
    if (!mesh.uvs.empty()) {
        std::vector<Vec2> uvs = mesh.uvs;
        for (Vec2& uv : uvs) {
            uv.y = flipV ? 1.0f - uv.y : uv.y;
        }
        attributes["TEXCOORD_0"] = addVectors<Vec2>(uvs);
    }
    if (!mesh.colors.empty()) { attributes["COLOR_0"] = addVectors<Vec3>(mesh.colors); }
    const size_t indices =
        addAccessor(bytesOf<uint32_t>(mesh.indices), kIndexData, kUnsignedInt, mesh.indices.size(), "SCALAR");
    return {{"attributes", std::move(attributes)}, {"indices", indices}};
}

std::string GltfWriter::text(const std::string& bufferUri) {
    if (!buffer_.empty()) { add("buffers", {{"byteLength", buffer_.size()}, {"uri", bufferUri}}); }
    return dumpedGltf(document_) + "\n";
}

std::string GltfWriter::binary() {
    pad('\0', &buffer_);
    if (!buffer_.empty()) { add("buffers", GltfJson::object({{"byteLength", buffer_.size()}})); }
    return binaryGltf(dumpedGltf(document_), buffer_);
}

}  // namespace glint
