// Memory layout of bounding volume hierarchies: wide nodes. Plain data, host and device alike.
#pragma once

#include <cstdint>

#include "engine/base/host_device.h"
#include "engine/math/bounds.h"

namespace glint {

constexpr int kNodeWidth = 8;

/// Entries a traversal stack must hold; builders guarantee that no tree needs more.
constexpr int kTraversalStackSize = 192;

/// Row of WideNode::bounds for an axis (0..2): the lower bounds of all children; the upper ones are in the
/// next row.
constexpr int lowerRow(int axis) { return 2 * axis; }

/// Up to eight children with their boxes. Unused children have lower = +inf, upper = -inf: no ray meets them.
struct alignas(64) WideNode {
    float bounds[6][kNodeWidth];
    uint32_t child[kNodeWidth];
    uint32_t unused[kNodeWidth];
};
static_assert(sizeof(WideNode) == 256);

inline bool hasChild(const WideNode& node, int slot) { return node.bounds[0][slot] <= node.bounds[1][slot]; }

inline Bounds childBounds(const WideNode& node, int slot) {
    Bounds b;
    for (int axis = 0; axis < 3; ++axis) {
        b.lo[axis] = node.bounds[lowerRow(axis)][slot];
        b.hi[axis] = node.bounds[lowerRow(axis) + 1][slot];
    }
    return b;
}

// A child reference is the index of an inner node, or a leaf: `count` (1..16) items from index `first` (<
// 2^27) on.
constexpr uint32_t kLeafBit = 0x80000000u;
constexpr uint32_t kMaxLeafItems = 16;
constexpr uint32_t kMaxLeafFirst = (1u << 27) - 1;

GLINT_HD constexpr uint32_t makeLeaf(uint32_t first, uint32_t count) {
    return kLeafBit | ((count - 1) << 27) | first;
}
GLINT_HD constexpr bool isLeaf(uint32_t child) { return (child & kLeafBit) != 0; }
GLINT_HD constexpr uint32_t leafFirst(uint32_t child) { return child & kMaxLeafFirst; }
GLINT_HD constexpr uint32_t leafCount(uint32_t child) { return ((child >> 27) & 15u) + 1; }

}  // namespace glint
