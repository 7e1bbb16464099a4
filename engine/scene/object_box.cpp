#include "engine/scene/object_box.h"

#include <glm/ext/matrix_double3x3.hpp>

namespace glint {

WideBox meshBox(const MeshData& mesh, size_t step) {
    WideBox box;
    for (size_t i = 0; i < mesh.indices.size(); i += step) {
        box.grow(glm::dvec3(mesh.positions[mesh.indices[i]]));
    }
    return box;
}

WideBox placedBox(ShapeKind shape, const Affine& objectToWorld, const WideBox& meshBox) {
    WideBox local{glm::dvec3(-1.0), glm::dvec3(1.0)};
    if (shape == ShapeKind::Plane) { return {}; }
    if (shape == ShapeKind::Mesh) {
        local = meshBox;
    } else if (shape != ShapeKind::Sphere) {
        local.lo.z = local.hi.z = 0.0;
    }
    if (local.empty()) { return {}; }
    WideBox box;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) != 0 ? local.hi.x : local.lo.x,
                           (corner & 2) != 0 ? local.hi.y : local.lo.y,
                           (corner & 4) != 0 ? local.hi.z : local.lo.z);
        box.grow(glm::dmat3(objectToWorld.linear) * p + glm::dvec3(objectToWorld.translation));
    }
    return box;
}

}  // namespace glint
