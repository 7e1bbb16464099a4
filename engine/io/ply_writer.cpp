#include "engine/io/ply_writer.h"

#include <bit>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"

namespace glint {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

namespace {

template <class T>
void put(std::string* bytes, const T& value) {
    bytes->append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

std::string encodePly(const MeshData& mesh) {
    const bool normals = !mesh.normals.empty(), uvs = !mesh.uvs.empty(), colors = !mesh.colors.empty();
    std::string bytes = fmt::format(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
        "property float x\nproperty float y\nproperty float z\n{}{}{}"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.positions.size(), normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "",
        uvs ? "property float u\nproperty float v\n" : "",
        colors ? "property float color_0\nproperty float color_1\nproperty float color_2\n" : "",
        mesh.triangleCount());
    bytes.reserve(bytes.size() + mesh.positions.size() * 44 + mesh.indices.size() / 3 * 13);
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        put(&bytes, mesh.positions[i]);
        if (normals) { put(&bytes, mesh.normals[i]); }
        if (uvs) { put(&bytes, mesh.uvs[i]); }
        if (colors) { put(&bytes, mesh.colors[i]); }
    }
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        bytes.push_back(3);
        bytes.append(reinterpret_cast<const char*>(&mesh.indices[i]), 3 * sizeof(uint32_t));
    }
    return bytes;
}

Status savePly(const std::string& path, const MeshData& mesh) {
    return writeFileAtomically(path, encodePly(mesh));
}

}  // namespace glint
