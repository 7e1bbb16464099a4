#include "engine/scene/object_box.h"

#include <glm/ext/matrix_double3x3.hpp>

#include "engine/kernels/shapes/shape_facts.h"
#include "engine/scene/profile.h"

namespace glint {

Bounds sceneBounds(const SceneDescription& scene) {
    Bounds all;
    for (const Object& object : scene.objects) {
        Bounds own = profileBounds(object.profile);
        const auto mesh = static_cast<size_t>(object.mesh);
        if (object.shape == ShapeKind::Mesh && mesh < scene.meshes.size() && scene.meshes[mesh].data) {
            for (const Vec3& p : scene.meshes[mesh].data->positions) {
                own.grow(p);
            }
        }
        const Bounds local = objectBounds(object.shape, own);
        if (!local.empty()) { all.grow(transformBounds(object.objectToWorld, local)); }
    }
    return all;
}

WideBox meshBox(const MeshData& mesh, size_t step) {
    WideBox box;
    for (size_t i = 0; i < mesh.indices.size(); i += step) {
        box.grow(glm::dvec3(mesh.positions[mesh.indices[i]]));
    }
    return box;
}

WideBox placedBox(const Object& object, const WideBox& meshBox) {
    WideBox local = meshBox;
    if (object.shape != ShapeKind::Mesh) {
        const Bounds bounds = objectBounds(object.shape, profileBounds(object.profile));
        local = {glm::dvec3(bounds.lo), glm::dvec3(bounds.hi)};
    }
    if (local.empty()) { return {}; }
    WideBox box;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) != 0 ? local.hi.x : local.lo.x,
                           (corner & 2) != 0 ? local.hi.y : local.lo.y,
                           (corner & 4) != 0 ? local.hi.z : local.lo.z);
        box.grow(glm::dmat3(object.objectToWorld.linear) * p + glm::dvec3(object.objectToWorld.translation));
    }
    return box;
}

}  // namespace glint
