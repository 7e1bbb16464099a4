// Walking an acceleration structure, of whichever kind the scene was built with. Both levels use it.
//
// Another kind is a value of AcceleratorKind, a header with its layout and its walk, a line in traverse() and
// one in builders/accelerator.cpp.
#pragma once

#include "engine/kernels/bvh_traversal.h"

namespace glint {

/// Visits the leaves that the ray may meet, roughly from near to far. `visitLeaf(first, count, &tMax)`
/// answers whether it found a hit, and lowers tMax to it; with kAnyHit the first hit ends the walk. ray.tMin
/// must not be negative, and the structure not empty.
template <bool kAnyHit, class VisitLeaf>
GLINT_HD inline bool traverse(const AcceleratorView& accelerator, const Ray& ray, VisitLeaf&& visitLeaf) {
    switch (accelerator.kind) {
        case AcceleratorKind::Bvh:
            return traverseBvh<kAnyHit>(accelerator.as<WideNode>(), ray, visitLeaf);
    }
    __builtin_unreachable();
}

}  // namespace glint
