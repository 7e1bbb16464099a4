// The scene against one ray: nearest hit and any hit, over the two levels of the acceleration structure.
//
// Shapes and cases that the feature mask does not name are left out at compile time.
#pragma once

#include "engine/kernels/cutout.h"

namespace glint {

namespace detail {

/// A world-space ray against one instance; stores a hit nearer than ray.tMax.
template <FeatureMask kMask, bool kAnyHit, bool kFrontOnly>
GLINT_HD inline bool intersectInstanceSided(const SceneView& view, uint32_t index, const Ray& ray, Hit* hit) {
    const InstanceData& instance = view.geometry.instances[index];
    if (isMesh<kMask>(instance)) {
        const MeshView& mesh = view.geometry.meshes[instance.mesh];
        const bool transformed =
            hasFeature<kMask>(kFeatureTransforms) && !(instance.flags & kInstanceIdentity);
        const Ray local = transformed ? toObjectSpace(instance, ray) : ray;
        if (!MeshShape::intersect<kAnyHit, kFrontOnly>(mesh, local, hit)) { return false; }
    } else if (const ProfileCurve* curves = profileOf<kMask>(view.geometry, instance)) {
        const Ray local = toObjectSpace(instance, ray);
        if (!RevolvedShape::intersect<kAnyHit, kFrontOnly>(curves, local, hit)) { return false; }
    } else {
        const Ray local = toObjectSpace(instance, ray);
        const float t = visitShape<float, kAnalyticOnly<kMask>>(instance.shape, [&](auto shape) {
            return decltype(shape)::template intersect<kFrontOnly>(local);
        });
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
    if (view.geometry.topLevel.empty()) { return found; }
    if (view.geometry.topInstances.count == 1) {
        return intersectInstance<kMask, kAnyHit>(view, view.geometry.topInstances[0], ray, hit) || found;
    }
    traverse<kAnyHit>(view.geometry.topLevel, ray, [&](uint32_t first, uint32_t count, float* tMax) {
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

namespace detail {

/// The nearest hit of what is there, behind what the ray passes. One function for rays of both kinds, since
/// each traversal takes much of a device's stack.
template <FeatureMask kMask>
GLINT_ONE_PIECE_APART GLINT_HD bool intersectCutouts(const SceneView& view, const Ray& ray, Hit* hit) {
    Ray rest = ray;
    while (intersectScene<kMask, false>(view, rest, hit)) {
        if (!isCutOut(view, *hit) || !passesCutout<kMask>(view, ray, *hit)) { return true; }
        // Where t was rounded to tMin, the same hit would be met for ever.
        rest.tMin = hit->t > rest.tMin ? hit->t : nextFloat(rest.tMin, true);
    }
    return false;
}

}  // namespace detail

/// The nearest hit with tMin < t < tMax. False, and *hit unspecified, when there is none.
template <FeatureMask kMask>
GLINT_HD bool intersect(const SceneView& view, const Ray& ray, Hit* hit) {
    if constexpr (hasFeature<kMask>(kFeatureCutouts)) {
        return detail::intersectCutouts<kMask>(view, ray, hit);
    } else {
        return detail::intersectScene<kMask, false>(view, ray, hit);
    }
}

/// Whether anything lies at tMin < t < tMax.
template <FeatureMask kMask>
GLINT_HD bool occluded(const SceneView& view, const Ray& ray) {
    Hit hit;
    if (!detail::intersectScene<kMask, true>(view, ray, &hit)) { return false; }
    if constexpr (hasFeature<kMask>(kFeatureCutouts)) {
        // Any hit of what is whole will do; otherwise there may be others behind it.
        return !isCutOut(view, hit) || detail::intersectCutouts<kMask>(view, ray, &hit);
    }
    return true;
}

}  // namespace glint
