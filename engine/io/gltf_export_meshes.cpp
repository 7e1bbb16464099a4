// Meshes as glTF wants them.
#include <algorithm>
#include <cmath>

#include "engine/io/gltf_export.h"
#include "engine/io/scene_export.h"

namespace glint {

bool isPlacement(const Affine& toWorld) {
    constexpr float kMostSkew = 1e-4f;
    const Mat3& m = toWorld.linear;
    for (int a = 0; a < 3; ++a) {
        const Vec3 u = m[a], v = m[(a + 1) % 3];
        if (!(std::fabs(glm::dot(u, v)) <= kMostSkew * glm::length(u) * glm::length(v))) { return false; }
    }
    return true;
}

Affine lookingAlong(const Vec3& position, const Vec3& direction) {
    const float length = glm::length(direction);
    const Vec3 z = -direction / length, aside = std::fabs(z.y) < 0.9f ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 x = glm::normalize(glm::cross(aside, z)), y = glm::cross(z, x);
    return {Mat3(length * x, length * y, -direction), position};
}

MeshData placed(MeshData mesh, const Affine& toWorld) {
    const Mat3 toObject = inverse(toWorld).linear;
    for (Vec3& position : mesh.positions) {
        position = toWorld.point(position);
    }
    for (Vec3& normal : mesh.normals) {
        normal = transformNormal(toObject, normal);
    }
    for (Vec4& tangent : mesh.tangents) {
        const float side = toWorld.determinant() < 0.0f ? -tangent.w : tangent.w;
        tangent = Vec4(toWorld.vector(Vec3(tangent)), side);
    }
    for (size_t i = 0; toWorld.determinant() < 0.0f && i < mesh.indices.size(); i += 3) {
        std::swap(mesh.indices[i], mesh.indices[i + 1]);
    }
    return mesh;
}

MeshData withUnitNormals(MeshData mesh) {
    if (std::ranges::all_of(mesh.normals, isZero)) {
        mesh.normals.clear();
        return mesh;
    }
    const auto repeat = [](auto* values, uint32_t from) {
        if (!values->empty()) {
            values->push_back(typename std::decay_t<decltype(*values)>::value_type((*values)[from]));
        }
    };
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        const uint32_t corner = mesh.indices[i];
        if (!isZero(mesh.normals[corner])) { continue; }
        const uint32_t* face = &mesh.indices[i - i % 3];
        const Vec3 a = mesh.positions[face[0]], b = mesh.positions[face[1]], c = mesh.positions[face[2]];
        mesh.indices[i] = static_cast<uint32_t>(mesh.normals.size());
        repeat(&mesh.positions, corner);
        repeat(&mesh.uvs, corner);
        repeat(&mesh.colors, corner);
        repeat(&mesh.tangents, corner);
        mesh.normals.push_back(glm::cross(b - a, c - a));
    }
    constexpr float kRounding = 1e-3f;
    for (Vec3& normal : mesh.normals) {
        const float length = glm::length(normal);
        if (std::fabs(length - 1.0f) > kRounding) {
            normal = length > 0.0f ? normal / length : Vec3(0, 1, 0);
        }
    }
    return mesh;
}

bool makeGltfTangents(MeshData* mesh, bool countsFromTop) {
    if (mesh->tangents.empty()) { return true; }
    const auto isMissing = [](const Vec4& t) { return t.w == 0.0f || isZero(Vec3(t)); };
    if (mesh->normals.empty() || std::ranges::any_of(mesh->tangents, isMissing)) {
        mesh->tangents.clear();
        return false;
    }
    constexpr float kRounding = 1e-3f;
    for (Vec4& tangent : mesh->tangents) {
        const Vec3 along(tangent);
        const float length = glm::length(along);
        const bool isUnit = std::fabs(length - 1.0f) <= kRounding;
        tangent = Vec4(isUnit ? along : along / length, (tangent.w < 0.0f) == countsFromTop ? 1.0f : -1.0f);
    }
    return true;
}

}  // namespace glint
