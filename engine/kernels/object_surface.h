// What an instance is, and its surface in object space at a hit, whichever shape it has.
#pragma once

#include "engine/kernels/scene_view.h"
#include "engine/kernels/shapes/shapes.h"

namespace glint {

/// Whether the instance is a mesh; known beforehand where a mask has no other shapes, or no meshes.
template <FeatureMask kMask>
GLINT_HD inline bool isMesh(const InstanceData& instance) {
    constexpr FeatureMask kOthers = featuresOfShapes(ShapeKind::Mesh);
    if constexpr (!hasFeature<kMask>(kFeatureMesh)) { return false; }
    if constexpr ((kMask & kOthers) == 0) { return true; }
    return instance.shape == ShapeKind::Mesh;
}

/// Whether the instance is a surface of revolution.
template <FeatureMask kMask>
GLINT_HD inline bool isRevolved(const InstanceData& instance) {
    return hasFeature<kMask>(kFeatureRevolved) && instance.shape == ShapeKind::Revolved;
}

/// The flags of the instance's material; none in views without materials, which only tests make.
GLINT_HD inline uint16_t materialFlagsOf(const SceneView& view, const InstanceData& instance) {
    return instance.material < view.materials.count ? view.materials[instance.material].flags : uint16_t{0};
}

/// The surface at a hit of the world-space `ray`. Sets *vertexColor where it is a mesh with colours.
template <FeatureMask kMask>
GLINT_HD inline ObjectPoint objectPointAt(const SceneView& view, const Ray& ray, const Hit& hit,
                                          Vec3* vertexColor) {
    const InstanceData& instance = view.geometry.instances[hit.instance];
    if (isMesh<kMask>(instance)) {
        return MeshShape::surface<kMask>(view.geometry.meshes[instance.mesh], hit, instance, ray,
                                         vertexColor);
    }
    const Vec3 pRough = toObjectSpace(instance, ray).at(hit.t);
    if (isRevolved<kMask>(instance)) {
        return RevolvedShape::surface<kMask>(profileAt(view.geometry, instance.mesh), hit, pRough);
    }
    return visitShape<ObjectPoint, kAnalyticOnly<kMask>>(
        instance.shape, [&](auto shape) { return decltype(shape)::template surface<kMask>(pRough); });
}

/// Whether the instance is a mesh with tangents of its own.
template <FeatureMask kMask>
GLINT_HD inline bool hasOwnTangents(const SceneView& view, uint32_t instance) {
    const InstanceData& data = view.geometry.instances[instance];
    return isMesh<kMask>(data) && view.geometry.meshes[data.mesh].ownTangents != nullptr;
}

/// Along u and v as a mesh itself says, in object space; zero: nothing does.
template <FeatureMask kMask>
GLINT_HD inline Tangents ownTangentsAt(const SceneView& view, const Hit& hit) {
    if (!hasOwnTangents<kMask>(view, hit.instance)) { return {Vec3(0.0f), Vec3(0.0f)}; }
    return MeshShape::ownTangents(view.geometry.meshes[view.geometry.instances[hit.instance].mesh], hit);
}

/// The tangents by which highlights lie, of those that objectTangentsAt() says: a mesh may have smooth ones,
/// or its own.
template <FeatureMask kMask>
GLINT_HD inline Tangents facetTangentsAt(const SceneView& view, const Hit& hit, const Tangents& tangents) {
    const InstanceData& instance = view.geometry.instances[hit.instance];
    if (!isMesh<kMask>(instance)) { return tangents; }
    const Tangents own = ownTangentsAt<kMask>(view, hit);
    return isZero(own.dpdu) ? MeshShape::smoothTangents(view.geometry.meshes[instance.mesh], hit, tangents)
                            : own;
}

/// dp/du and dp/dv in object space at a hit; p: objectPointAt() it.
template <FeatureMask kMask>
GLINT_HD inline Tangents objectTangentsAt(const SceneView& view, const Hit& hit, const Vec3& p) {
    const InstanceData& instance = view.geometry.instances[hit.instance];
    if (isMesh<kMask>(instance)) {
        return MeshShape::tangents(view.geometry.meshes[instance.mesh], hit.primitive);
    }
    if (isRevolved<kMask>(instance)) {
        return RevolvedShape::tangents(profileAt(view.geometry, instance.mesh), hit, p);
    }
    return visitShape<Tangents, kAnalyticOnly<kMask>>(
        instance.shape, [&](auto shape) { return decltype(shape)::tangents(p); });
}

}  // namespace glint
