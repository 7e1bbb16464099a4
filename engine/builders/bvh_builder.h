// Bounding volume hierarchies: from boxes to a binary tree (binned surface area heuristic), and from that to
// wide nodes. Knows boxes and numbers only. The result does not depend on the number of threads.
#pragma once

#include "engine/builders/build_primitive.h"
#include "engine/kernels/bvh_nodes.h"

namespace glint {

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

struct BvhOptions : LeafOptions {
    /// split in the middle of the order instead of by cost: depth at most log2(count)
    bool balanced = false;
};

/// Reorders `primitives` so that every node's are neighbours. Needs at least one.
BinaryTree buildBinaryTree(HugeVector<BuildPrimitive>* primitives, const BvhOptions& options);

/// Collapses the tree to wide nodes in depth-first order; node 0 is the root.
HugeVector<WideNode> collapseTree(const BinaryTree& tree, const PackLeaves& packLeaves);

/// The most entries a traversal of the nodes can have on its stack.
uint32_t traversalStackNeed(const HugeVector<WideNode>& nodes);

/// Wide nodes over `primitives`, which it reorders, never too deep for a traversal's stack. Needs at
/// least one.
HugeVector<WideNode> buildBvh(HugeVector<BuildPrimitive>* primitives, const LeafOptions& options,
                              const PackLeaves& packLeaves);

}  // namespace glint
