// The scene against one ray: nearest hit and any hit, over the two levels of the acceleration structure.
//
// Shapes and cases that the feature mask does not name are left out at compile time.
#pragma once

#include "engine/kernels/cutout.h"

namespace glint {

namespace detail {

/// What of a mask the traversal of meshes depends on.
template <FeatureMask kMask>
constexpr FeatureMask kMeshTraversal = kMask& kFeatureAccelerators;

/// A world-space ray against an instance, or a part of it; stores a hit nearer than ray.tMax.
template <FeatureMask kMask, bool kAnyHit, bool kFrontOnly, class Tests>
GLINT_HD inline bool intersectItemSided(const SceneView& view, const TopItem& item, const Ray& ray, Hit* hit,
                                        Tests tests) {
    const InstanceData& instance = view.geometry.instances[item.instance];
    if (isMesh<kMask>(instance)) {
        const MeshView& mesh = view.geometry.meshes[instance.mesh];
        const bool transformed =
            hasFeature<kMask>(kFeatureTransforms) && !(instance.flags & kInstanceIdentity);
        const Ray local = transformed ? toObjectSpace(instance, ray) : ray;
        if (!MeshShape::intersect<kMeshTraversal<kMask>, kAnyHit, kFrontOnly>(mesh, item.root, local, hit,
                                                                              tests)) {
            return false;
        }
    } else if (isRevolved<kMask>(instance)) {
        const ProfileView profile = profileAt(view.geometry, instance.mesh);
        const Ray local = toObjectSpace(instance, ray);
        if (!RevolvedShape::intersect<kAnyHit, kFrontOnly>(profile, local, hit, tests)) { return false; }
    } else {
        tests.countPrimitives(1);
        const Ray local = toObjectSpace(instance, ray);
        const float t = visitShape<float, kAnalyticOnly<kMask>>(instance.shape, [&](auto shape) {
            return decltype(shape)::template intersect<kFrontOnly>(local);
        });
        if (t < 0.0f) { return false; }
        hit->t = t;
        hit->primitive = 0;
        hit->barycentric = Vec2(0.0f);
    }
    hit->instance = item.instance;
    return true;
}

template <FeatureMask kMask, bool kAnyHit, class Tests>
GLINT_HD inline bool intersectItem(const SceneView& view, const TopItem& item, const Ray& ray, Hit* hit,
                                   Tests tests) {
    if (hasFeature<kMask>(kFeatureFrontOnly) &&
        (view.geometry.instances[item.instance].flags & kInstanceFrontOnly)) {
        return intersectItemSided<kMask, kAnyHit, true>(view, item, ray, hit, tests);
    }
    return intersectItemSided<kMask, kAnyHit, false>(view, item, ray, hit, tests);
}

/// With kFeatureAccelerators in the mask, a scene in other structures than hierarchies of boxes.
template <FeatureMask kMask, bool kAnyHit, class Tests>
GLINT_HD inline bool intersectSceneIn(const SceneView& view, const Ray& worldRay, Hit* hit, Tests tests) {
    Ray ray = worldRay;
    bool found = false;
    if (hasFeature<kMask>(kFeaturePlane)) {
        for (uint32_t i = 0; i < view.geometry.planes.count; ++i) {
            const TopItem plane{view.geometry.planes[i]};
            if (!intersectItem<kMask, kAnyHit>(view, plane, ray, hit, tests)) { continue; }
            found = true;
            if (kAnyHit) { return true; }
            ray.tMax = hit->t;
        }
    }
    if (view.geometry.topLevel.empty()) { return found; }
    if (view.geometry.topItems.count == 1) {
        return intersectItem<kMask, kAnyHit>(view, view.geometry.topItems[0], ray, hit, tests) || found;
    }
    const auto visit = [&](uint32_t first, uint32_t count, float* tMax) {
        bool foundHere = false;
        for (uint32_t i = first; i < first + count; ++i) {
            const TopItem item = view.geometry.topItems[i];
            if (!intersectItem<kMask, kAnyHit>(view, item, ray, hit, tests)) { continue; }
            foundHere = true;
            if (kAnyHit) { break; }
            ray.tMax = hit->t;
        }
        found = found || foundHere;
        *tMax = ray.tMax;
        return foundHere;
    };
    traverse<kMask, kAnyHit>(view.geometry.topLevel, view.geometry.topItems.data, ray, tests, visit);
    return found;
}

template <FeatureMask kMask, bool kAnyHit, class Tests>
GLINT_ONE_PIECE_APART GLINT_HD bool intersectSceneApart(const SceneView& view, const Ray& ray, Hit* hit,
                                                        Tests tests) {
    return intersectSceneIn<kMask, kAnyHit>(view, ray, hit, tests);
}

/// Both levels have the same kind of structure. Others than hierarchies of boxes are apart, so that these are
/// met as fast where there is a choice as where there is none.
template <FeatureMask kMask, bool kAnyHit, class Tests>
GLINT_HD inline bool intersectScene(const SceneView& view, const Ray& ray, Hit* hit, Tests tests) {
    if constexpr (hasFeature<kMask>(kFeatureAccelerators)) {
        if (view.geometry.topLevel.kind != AcceleratorKind::Bvh) {
            return intersectSceneApart<kMask, kAnyHit>(view, ray, hit, tests);
        }
    }
    return intersectSceneIn<kMask & ~FeatureMask{kFeatureAccelerators}, kAnyHit>(view, ray, hit, tests);
}

/// The nearest hit of what is there, behind what the ray passes. One function for rays of both kinds, since
/// each traversal takes much of a device's stack.
template <FeatureMask kMask, class Tests>
GLINT_ONE_PIECE_APART GLINT_HD bool intersectCutouts(const SceneView& view, const Ray& ray, Hit* hit,
                                                     Tests tests) {
    Ray rest = ray;
    while (intersectScene<kMask, false>(view, rest, hit, tests)) {
        if (!isCutOut(view, *hit) || !passesCutout<kMask>(view, ray, *hit)) { return true; }
        // Where t was rounded to tMin, the same hit would be met for ever.
        rest.tMin = hit->t > rest.tMin ? hit->t : nextFloat(rest.tMin, true);
    }
    return false;
}

}  // namespace detail

/// The nearest hit with tMin < t < tMax. False, and *hit unspecified, when there is none. Of primitives that
/// are met at distances within rounding of each other, such as neighbours at their edge, any may be the one.
template <FeatureMask kMask, class Tests = NoTests>
GLINT_HD bool intersect(const SceneView& view, const Ray& ray, Hit* hit, Tests tests = {}) {
    if constexpr (hasFeature<kMask>(kFeatureCutouts)) {
        return detail::intersectCutouts<kMask>(view, ray, hit, tests);
    } else {
        return detail::intersectScene<kMask, false>(view, ray, hit, tests);
    }
}

/// Whether anything lies at tMin < t < tMax.
template <FeatureMask kMask>
GLINT_HD bool occluded(const SceneView& view, const Ray& ray) {
    Hit hit;
    if (!detail::intersectScene<kMask, true>(view, ray, &hit, NoTests{})) { return false; }
    if constexpr (hasFeature<kMask>(kFeatureCutouts)) {
        // Any hit of what is whole will do; otherwise there may be others behind it.
        return !isCutOut(view, hit) || detail::intersectCutouts<kMask>(view, ray, &hit, NoTests{});
    }
    return true;
}

}  // namespace glint
