// Bounding volume hierarchies: from boxes to a binary tree (binned surface area heuristic), and from that to
// wide nodes.
//
// Called by mesh_builder (triangles) and instance_builder (instances). Knows boxes and numbers only. The
// result does not depend on the number of threads.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "engine/kernels/bvh_nodes.h"
#include "engine/math/bounds.h"

namespace glint {

/// A box to sort into the tree, and whose it is.
struct BuildPrimitive {
    Bounds bounds;  ///< finite, not empty
    uint32_t index = 0;
};

/// A node over primitives [begin, end). An inner node's left child is the next node, the right one `right`.
struct BinaryNode {
    Bounds bounds;
    uint32_t begin = 0;
    uint32_t end = 0;
    uint32_t right = 0;  ///< 0: a leaf

    bool leaf() const { return right == 0; }
};

struct BinaryTree {
    std::vector<BinaryNode> nodes;  ///< nodes[0] is the root; sparse: subtrees keep room for their worst case
};

struct BvhOptions {
    uint32_t maxLeafPrimitives = 1;
    float traversalCost = 1.0f;  ///< of one box against the cost of one primitive
    bool balanced =
        false;  ///< split in the middle of the order instead of by cost: depth at most log2(count)
    int threads = 0;
};

/// Reorders `primitives` so that every node's are neighbours. Needs at least one.
BinaryTree buildBinaryTree(std::vector<BuildPrimitive>* primitives, const BvhOptions& options);

/// Turns leaf contents into a child reference (makeLeaf); called in depth-first order.
using EmitLeaf = std::function<uint32_t(const BinaryNode& leaf)>;

/// Collapses the tree to wide nodes in depth-first order; node 0 is the root.
std::vector<WideNode> collapseTree(const BinaryTree& tree, const EmitLeaf& emitLeaf);

/// The most entries a traversal of the nodes can have on its stack.
uint32_t traversalStackNeed(const std::vector<WideNode>& nodes);

}  // namespace glint
