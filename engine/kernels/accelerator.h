// Walking an acceleration structure, of whichever kind the scene was built with. Both levels use it.
//
// Another kind is a value of AcceleratorKind, a header with its layout and its walk from leaf
// to leaf, a line in traverseOther() and one in builders/accelerator.cpp.
#pragma once

#include "engine/kernels/box_list.h"
#include "engine/kernels/bvh_traversal.h"
#include "engine/kernels/features.h"
#include "engine/kernels/kd_tree.h"
#include "engine/kernels/ray_tests.h"

namespace glint {
namespace detail {

/// All kinds but hierarchies of boxes. The visitor is called in one place, since it may be large.
template <bool kAnyHit, class Tests, class VisitLeaf>
GLINT_HD inline bool traverseOther(const AcceleratorView& accelerator, const Ray& ray, Tests tests,
                                   const VisitLeaf& visitLeaf) {
    const BoxRay box = makeBoxRay(ray);
    const bool isTree = accelerator.kind == AcceleratorKind::KdTree;
    float tMax = ray.tMax;
    ListWalk list(accelerator);
    KdWalk tree;
    if (isTree) { tree.begin(accelerator.as<KdHeader>(), box, ray.tMin, tMax, tests); }
    bool found = false;
    LeafItems items{};
    while (isTree ? tree.next(box, tMax, tests, &items) : list.next(box, ray.tMin, tMax, tests, &items)) {
        if (!visitLeaf(items.first, items.count, &tMax)) { continue; }
        found = true;
        if (kAnyHit) { return true; }
    }
    return found;
}

}  // namespace detail

/// Visits the leaves that the ray may meet, roughly from near to far. `visitLeaf(first, count, &tMax)`
/// answers whether it found a hit, and lowers tMax to it; with kAnyHit the first hit ends the walk. What the
/// leaf holds is leafItems[first] and on. ray.tMin must not be negative, and the structure not empty. It is a
/// hierarchy of boxes, of which the part from `root` on is walked, or, with kFeatureAccelerators in the mask,
/// any other.
template <FeatureMask kMask, bool kAnyHit, class Item, class Tests, class VisitLeaf>
GLINT_HD inline bool traverse(const AcceleratorView& accelerator, const Item* leafItems, const Ray& ray,
                              Tests tests, VisitLeaf&& visitLeaf, uint32_t root = 0) {
    if constexpr (hasFeature<kMask>(kFeatureAccelerators)) {
        return detail::traverseOther<kAnyHit>(accelerator, ray, tests, visitLeaf);
    } else {
        return traverseBvh<kAnyHit>(accelerator.as<WideNode>(), root, leafItems, ray, tests, visitLeaf);
    }
}

}  // namespace glint
