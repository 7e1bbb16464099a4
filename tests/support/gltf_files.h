// Small glTF files for tests: a textured square, in one buffer.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>

namespace glint::test {

inline std::string base64(const std::string& bytes) {
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t three = 0;
        for (size_t k = 0; k < 3; ++k) {
            three = three << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0u);
        }
        for (size_t k = 0; k < 4; ++k) {
            out += i + k > bytes.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63];
        }
    }
    return out;
}

template <class Number>
std::string packed(std::initializer_list<Number> numbers) {
    std::string out;
    for (const Number number : numbers) {
        out.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
    return out;
}

/// A square in the plane z = 0 from (-1, -1) to (1, 1), texture coordinates and indices of 16 bits.
inline const std::string kSquare = packed<float>({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}) +
                                   packed<float>({0, 1, 1, 1, 1, 0, 0, 0}) +
                                   packed<uint16_t>({0, 1, 2, 0, 2, 3});

inline constexpr const char* kViews = R"("bufferViews": [{"buffer": 0, "byteLength": 48},
    {"buffer": 0, "byteOffset": 48, "byteLength": 32}, {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
    {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
    {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}])";
inline constexpr const char* kMesh =
    R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1},
    "indices": 2, "material": 0}]}])";
inline constexpr const char* kNode = R"("nodes": [{"mesh": 0}])";

inline std::string gltf(const std::string& more, const std::string& mesh = kMesh,
                        const std::string& node = kNode, const std::string& views = kViews,
                        const std::string& buffer = kSquare) {
    return R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": )" + std::to_string(buffer.size()) +
           R"(, "uri": "data:application/octet-stream;base64,)" + base64(buffer) + "\"}], " + views + ", " +
           mesh + ", " + node + (more.empty() ? "" : ", ") + more + "}";
}
inline std::string material(const std::string& members) { return R"("materials": [{)" + members + "}]"; }

}  // namespace glint::test
