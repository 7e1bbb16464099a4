// The area of a mesh's triangles.
#pragma once

#include "engine/scene/mesh_data.h"

namespace glint::test {

inline float areaOf(const MeshData& mesh) {
    float sum = 0.0f;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3& a = mesh.positions[mesh.indices[i]];
        sum += 0.5f * glm::length(glm::cross(mesh.positions[mesh.indices[i + 1]] - a,
                                             mesh.positions[mesh.indices[i + 2]] - a));
    }
    return sum;
}

}  // namespace glint::test
