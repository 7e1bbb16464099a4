#pragma once

#include "engine/math/transform.h"
#include "engine/scene/mesh_data.h"

namespace glint {

/// Of all triangles where they stand, in world units squared.
inline double areaOf(const MeshData& mesh, const Affine& toWorld = {}) {
    double sum = 0.0;
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto at = [&](size_t k) {
            return glm::dvec3(toWorld.point(mesh.positions[mesh.indices[i + k]]));
        };
        sum += 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
    }
    return sum;
}

}  // namespace glint
