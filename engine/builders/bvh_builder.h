// Bounding volume hierarchies: from boxes to a binary tree (binned surface area heuristic), and from that to
// wide nodes.
//
// Called by mesh_builder (triangles) and instance_builder (instances). Knows boxes and numbers only. The
// result does not depend on the number of threads.
#pragma once

#include <cstdint>
#include <functional>

#include "engine/base/huge_pages.h"
#include "engine/kernels/bvh_nodes.h"
#include "engine/math/bounds.h"

namespace glint {

/// A box to sort into the tree, and whose it is. The upper corner is negated, so that joining boxes is
/// one minimum.
struct alignas(32) BuildPrimitive {
    Vec3 lo;  ///< finite, not above the upper corner
    uint32_t index;
    Vec3 negatedHi;
    uint32_t unused;
};

inline BuildPrimitive makeBuildPrimitive(const Bounds& bounds, uint32_t index) {
    return {bounds.lo, index, -bounds.hi, 0};
}

/// A node over primitives [begin, end), without default values: trees leave room for slots that they never
/// use. An inner node's children are nodes `children` and `children` + 1.
struct BinaryNode {
    Vec3 lo, hi;
    uint32_t begin, end;
    uint32_t children;  ///< 0: a leaf

    bool leaf() const { return children == 0; }
    Bounds bounds() const { return {lo, hi}; }
};

struct BinaryTree {
    /// nodes[0] is the root; the order varies with the threads, the tree does not
    HugeVector<BinaryNode> nodes;
    uint32_t count = 0;  ///< nodes in use
};

struct BvhOptions {
    uint32_t leafPrimitives = 1;  ///< this many are tested at the cost of one, and stay together in a leaf
    /// split in the middle of the order instead of by cost: depth at most log2(count)
    bool balanced = false;
    int threads = 0;
};

/// Reorders `primitives` so that every node's are neighbours. Needs at least one.
BinaryTree buildBinaryTree(HugeVector<BuildPrimitive>* primitives, const BvhOptions& options);

/// Turns leaf contents into a child reference (makeLeaf); called in depth-first order.
using EmitLeaf = std::function<uint32_t(const BinaryNode& leaf)>;

/// Collapses the tree to wide nodes in depth-first order; node 0 is the root.
HugeVector<WideNode> collapseTree(const BinaryTree& tree, const EmitLeaf& emitLeaf);

/// The most entries a traversal of the nodes can have on its stack.
uint32_t traversalStackNeed(const HugeVector<WideNode>& nodes);

}  // namespace glint
