// The scene against one ray: nearest hit and any hit, over the two levels of the acceleration structure.
//
// Called by the path kernels, the light sampling and the tests. Ordered traversal of wide nodes with an
// explicit stack; shapes and cases that the feature mask does not name are left out at compile time.
#pragma once

#include "engine/base/inlining.h"
#include "engine/kernels/box_test.h"
#include "engine/kernels/features.h"
#include "engine/kernels/quadric.h"
#include "engine/kernels/scene_view.h"
#include "engine/kernels/traversal.h"
#include "engine/kernels/triangle.h"

namespace glint {

/// Where a ray meets the scene. Barycentric weights of a triangle's second and third vertex; 0 for
/// other shapes.
struct Hit {
    float t;
    uint32_t instance;
    uint32_t primitive;  ///< triangle number within the mesh; 0 for other shapes
    Vec2 barycentric;
};

/// Whether the instance is a mesh; known beforehand where a mask has no other shapes, or no meshes.
template <FeatureMask kMask>
GLINT_HD inline bool isMesh(const InstanceData& instance) {
    constexpr FeatureMask kOthers = kFeatureSphere | kFeaturePlane | kFeatureFlat;
    if constexpr (!hasFeature<kMask>(kFeatureMesh)) { return false; }
    if constexpr ((kMask & kOthers) == 0) { return true; }
    return instance.shape == ShapeKind::Mesh;
}

namespace detail {

/// A ray in an instance's object space; t keeps its meaning.
GLINT_HD inline Ray toObjectSpace(const InstanceData& instance, const Ray& ray) {
    return {instance.worldToObject.point(ray.origin), instance.worldToObject.vector(ray.direction), ray.tMin,
            ray.tMax};
}

/// A ray against one mesh in object space. On a hit nearer than ray.tMax stores it; its primitive is the
/// triangle number.
template <bool kAnyHit, bool kFrontOnly>
GLINT_ONE_PIECE GLINT_HD inline bool intersectMesh(const MeshView& mesh, const Ray& ray, Hit* hit) {
    if (mesh.nodeCount == 0) { return false; }
    const ShearRay shear = makeShearRay(ray);
    TriangleHit nearest{ray.tMax, 0.0f, 0.0f, kNone};
    traverse<kAnyHit>(mesh.nodes, ray, [&](uint32_t first, uint32_t count, float* tMax) {
        bool found = false;
        for (uint32_t i = first; i < first + count; ++i) {
            found =
                intersectCluster<kAnyHit, kFrontOnly>(mesh.clusters[i], shear, ray.tMin, &nearest) || found;
        }
        *tMax = nearest.t;
        return found;
    });
    if (nearest.primitive == kNone) { return false; }
    hit->t = nearest.t;
    hit->primitive = mesh.clusterPrimitives[nearest.primitive];
    hit->barycentric = Vec2(nearest.b1, nearest.b2);
    return true;
}

template <FeatureMask kMask, bool kFrontOnly>
GLINT_HD inline float intersectAnalytic(ShapeKind shape, const Ray& local) {
    if (hasFeature<kMask>(kFeatureSphere) && shape == ShapeKind::Sphere) {
        return intersectUnitSphere<kFrontOnly>(local);
    }
    if (hasFeature<kMask>(kFeaturePlane) && shape == ShapeKind::Plane) {
        return intersectPlane<kFrontOnly>(local);
    }
    if (hasFeature<kMask>(kFeatureFlat) && shape == ShapeKind::Rectangle) {
        return intersectRectangle<kFrontOnly>(local);
    }
    if (hasFeature<kMask>(kFeatureFlat) && shape == ShapeKind::Disc) {
        return intersectDisc<kFrontOnly>(local);
    }
    return kNoHit;
}

/// A world-space ray against one instance; stores a hit nearer than ray.tMax.
template <FeatureMask kMask, bool kAnyHit, bool kFrontOnly>
GLINT_HD inline bool intersectInstanceSided(const SceneView& view, uint32_t index, const Ray& ray, Hit* hit) {
    const InstanceData& instance = view.geometry.instances[index];
    if (isMesh<kMask>(instance)) {
        const MeshView& mesh = view.geometry.meshes[instance.mesh];
        const bool transformed =
            hasFeature<kMask>(kFeatureTransforms) && !(instance.flags & kInstanceIdentity);
        const Ray local = transformed ? toObjectSpace(instance, ray) : ray;
        if (!intersectMesh<kAnyHit, kFrontOnly>(mesh, local, hit)) { return false; }
    } else {
        const float t = intersectAnalytic<kMask, kFrontOnly>(instance.shape, toObjectSpace(instance, ray));
        if (t < 0.0f) { return false; }
        hit->t = t;
        hit->primitive = 0;
        hit->barycentric = Vec2(0.0f);
    }
    hit->instance = index;
    return true;
}

template <FeatureMask kMask, bool kAnyHit>
GLINT_HD inline bool intersectInstance(const SceneView& view, uint32_t index, const Ray& ray, Hit* hit) {
    if (hasFeature<kMask>(kFeatureFrontOnly) && (view.geometry.instances[index].flags & kInstanceFrontOnly)) {
        return intersectInstanceSided<kMask, kAnyHit, true>(view, index, ray, hit);
    }
    return intersectInstanceSided<kMask, kAnyHit, false>(view, index, ray, hit);
}

template <FeatureMask kMask, bool kAnyHit>
GLINT_HD inline bool intersectScene(const SceneView& view, const Ray& worldRay, Hit* hit) {
    Ray ray = worldRay;
    bool found = false;
    if (hasFeature<kMask>(kFeaturePlane)) {
        for (uint32_t i = 0; i < view.geometry.planes.count; ++i) {
            if (!intersectInstance<kMask, kAnyHit>(view, view.geometry.planes[i], ray, hit)) { continue; }
            found = true;
            if (kAnyHit) { return true; }
            ray.tMax = hit->t;
        }
    }
    if (view.geometry.topNodes.empty()) { return found; }
    if (view.geometry.topInstances.count == 1) {
        return intersectInstance<kMask, kAnyHit>(view, view.geometry.topInstances[0], ray, hit) || found;
    }
    traverse<kAnyHit>(view.geometry.topNodes.data, ray, [&](uint32_t first, uint32_t count, float* tMax) {
        bool foundHere = false;
        for (uint32_t i = first; i < first + count; ++i) {
            if (!intersectInstance<kMask, kAnyHit>(view, view.geometry.topInstances[i], ray, hit)) {
                continue;
            }
            foundHere = true;
            if (kAnyHit) { break; }
            ray.tMax = hit->t;
        }
        found = found || foundHere;
        *tMax = ray.tMax;
        return foundHere;
    });
    return found;
}

}  // namespace detail

/// The nearest hit with tMin < t < tMax. False, and *hit unspecified, when there is none.
template <FeatureMask kMask>
GLINT_HD bool intersect(const SceneView& view, const Ray& ray, Hit* hit) {
    return detail::intersectScene<kMask, false>(view, ray, hit);
}

/// Whether anything lies at tMin < t < tMax.
template <FeatureMask kMask>
GLINT_HD bool occluded(const SceneView& view, const Ray& ray) {
    Hit hit;
    return detail::intersectScene<kMask, true>(view, ray, &hit);
}

}  // namespace glint
