// Walking a tree of wide nodes from near to far, for one ray, with an explicit stack. Knows nothing of what
// leaves hold.
#pragma once

#include <bit>

#include "engine/base/bits.h"
#include "engine/kernels/box_test.h"
#include "engine/kernels/bvh_nodes.h"
#include "engine/kernels/prefetch.h"

namespace glint {

/// A child still to visit: its entry distance in the high half, so that keys order by distance
/// (never negative).
using StackEntry = uint64_t;

GLINT_HD inline uint32_t floatBits(float x) { return std::bit_cast<uint32_t>(x); }

GLINT_HD inline StackEntry* pushSortedScalar(const WideNode& node, uint32_t mask, const float* distance,
                                             StackEntry* top) {
    StackEntry* const base = top;
    for (; mask != 0; mask &= mask - 1) {
        const uint32_t i = lowestBit(mask);
        const StackEntry entry = (StackEntry{floatBits(distance[i])} << 32) | node.child[i];
        StackEntry* slot = top++;
        while (slot > base && slot[-1] < entry) {
            slot[0] = slot[-1];
            --slot;
        }
        *slot = entry;
    }
    return top;
}

#if GLINT_HAS_AVX512
// The masked forms spare GCC 12 a false warning of uninitialised vectors.
/// Each entry's place is the number of nearer ones: no branch depends on the order.
inline StackEntry* pushSortedSimd(const WideNode& node, uint32_t mask, const float* distance,
                                  StackEntry* top) {
    const __m512i far =
        _mm512_maskz_cvtepu32_epi64(0xff, _mm256_load_si256(reinterpret_cast<const __m256i*>(distance)));
    const __m512i child =
        _mm512_maskz_cvtepu32_epi64(0xff, _mm256_load_si256(reinterpret_cast<const __m256i*>(node.child)));
    const __m512i entries = _mm512_or_si512(_mm512_maskz_slli_epi64(0xff, far, 32), child);
    alignas(64) StackEntry entry[kNodeWidth];
    _mm512_store_si512(entry, entries);
    const uint32_t count = static_cast<uint32_t>(__builtin_popcount(mask));
    const __mmask8 hits = static_cast<__mmask8>(mask);
    for (; mask != 0; mask &= mask - 1) {
        const StackEntry e = entry[lowestBit(mask)];
        const __mmask8 farther =
            _mm512_mask_cmpgt_epu64_mask(hits, entries, _mm512_set1_epi64(static_cast<long long>(e)));
        top[__builtin_popcount(farther)] = e;
    }
    return top + count;
}
#endif

/// Pushes the children of `mask`, farthest first, so that the nearest is on top. `distance` is aligned to
/// 32 bytes.
GLINT_HD inline StackEntry* pushSorted(const WideNode& node, uint32_t mask, const float* distance,
                                       StackEntry* top) {
#if GLINT_HAS_AVX512
    return pushSortedSimd(node, mask, distance, top);
#else
    return pushSortedScalar(node, mask, distance, top);
#endif
}

/// Most children of a node that a ray meets are visited, one after the other: what they refer to comes from
/// memory at once.
template <class Item>
GLINT_HD inline void prefetchChildren(const WideNode* nodes, const Item* leafItems, const WideNode& node,
                                      uint32_t mask) {
#if !GLINT_ON_DEVICE
    for (; mask != 0; mask &= mask - 1) {
        const uint32_t child = node.child[lowestBit(mask)];
        if (isLeaf(child)) {
            prefetch(leafItems + leafFirst(child));
        } else {
            prefetch(nodes + child);
        }
    }
#endif
}

/// traverse() (accelerator.h) of the wide nodes, or the leaf, that the child reference `root` begins.
template <bool kAnyHit, class Item, class Tests, class VisitLeaf>
GLINT_HD inline bool traverseBvh(const WideNode* nodes, uint32_t root, const Item* leafItems, const Ray& ray,
                                 Tests tests, VisitLeaf&& visitLeaf) {
    const BoxRay box = makeBoxRay(ray);
    float tMax = ray.tMax;
    bool found = false;
    StackEntry stack[kTraversalStackSize];
    StackEntry* top = stack;
    alignas(32) float distance[kNodeWidth];
    uint32_t current = root;
    while (true) {
        if (isLeaf(current)) {
            if (visitLeaf(leafFirst(current), leafCount(current), &tMax)) {
                found = true;
                if (kAnyHit) { return true; }
            }
        } else {
            const WideNode& node = nodes[current];
            tests.countBoxes(kNodeWidth);
            const uint32_t mask = boxHits(node, box, ray.tMin, tMax, distance);
            if (mask != 0 && (mask & (mask - 1)) == 0) {
                current = node.child[lowestBit(mask)];
                continue;
            }
            prefetchChildren(nodes, leafItems, node, mask);
            top = pushSorted(node, mask, distance, top);
        }
        const uint64_t limit = uint64_t{floatBits(tMax)} << 32;
        do {
            if (top == stack) { return found; }
            --top;
        } while (*top > limit);
        current = static_cast<uint32_t>(*top);
    }
}

}  // namespace glint
