// kd-trees: their memory layout, and the walk from near to far for one ray. Host and device. Knows nothing of
// what leaves hold; an item may lie in several.
//
// A cell's part of the ray is widened by what rounding can do to it, so that a leaf is never passed over that
// the exact ray touches. A hit beyond the cell's end is kept, but the walk goes on until it comes to a cell
// that begins behind it: the hit may be one of a part of the item in a later cell.
#pragma once

#include <bit>

#include "engine/kernels/box_list.h"

namespace glint {

/// A tree is at most so deep, and leaves at most so many cells to come back to.
constexpr int kKdStackSize = 64;

/// The beginning of a tree's memory; its nodes follow, the root first.
struct alignas(64) KdHeader {
    Bounds bounds;  ///< of the root's cell
};

/// An inner node's lower child is the next node.
struct KdNode {
    static constexpr uint32_t kLeaf = 3;

    uint32_t data;  ///< inner node: bits of the plane's coordinate; leaf: its first item
    uint32_t link;  ///< axis, or kLeaf, and four times: the upper child's index, or the number of items

    GLINT_HD uint32_t axis() const { return link & 3u; }
    GLINT_HD bool isLeaf() const { return axis() == kLeaf; }
    GLINT_HD float plane() const { return std::bit_cast<float>(data); }
    GLINT_HD uint32_t upperChild() const { return link >> 2; }
    GLINT_HD uint32_t itemCount() const { return link >> 2; }
};

/// A node, and the part of the ray within its cell.
struct KdCell {
    uint32_t node;
    float tEnter, tLeave;
};

/// The child of cell->node that the ray meets first becomes the cell. True where it meets the other one, too,
/// which is then *later.
GLINT_HD inline bool enterChild(const KdNode& node, const BoxRay& ray, KdCell* cell, KdCell* later) {
    const uint32_t axis = node.axis();
    const float plane = node.plane();
    const float origin = ray.origin[axis];
    const bool isBackwards = ray.nearRow[axis] != lowerRow(static_cast<int>(axis));
    const bool lowerFirst = origin < plane || (origin == plane && isBackwards);
    const uint32_t lower = cell->node + 1;
    const uint32_t nearer = lowerFirst ? lower : node.upperChild();
    const uint32_t farther = lowerFirst ? node.upperChild() : lower;
    // NaN for a ray within the plane: the comparisons fail, and both sides are visited.
    const float t = (plane - origin) * ray.inverseDirection[axis];
    const float least = t * (2.0f - kSlabWidening);
    const float most = t * kSlabWidening;
    cell->node = nearer;
    if (t <= 0.0f || least > cell->tLeave) { return false; }
    if (most < cell->tEnter) {
        cell->node = farther;
        return false;
    }
    *later = {farther, least > cell->tEnter ? least : cell->tEnter, cell->tLeave};
    cell->tLeave = most < cell->tLeave ? most : cell->tLeave;
    return true;
}

/// From leaf to leaf, near to far.
class KdWalk {
  public:
    template <class Tests>
    GLINT_HD void begin(const KdHeader* tree, const BoxRay& ray, float tMin, float tMax, Tests tests) {
        nodes_ = reinterpret_cast<const KdNode*>(tree + 1);
        tests.countBoxes(1);
        KdCell& root = cells_[0];
        root.node = 0;
        count_ = boxHit(tree->bounds, ray, tMin, tMax, &root.tEnter, &root.tLeave) ? 1 : 0;
    }

    /// The items of the next leaf with any that the ray meets before tMax; false: there is none.
    template <class Tests>
    GLINT_HD bool next(const BoxRay& ray, float tMax, Tests tests, LeafItems* items) {
        while (count_ > 0) {
            KdCell cell = cells_[--count_];
            if (cell.tEnter > tMax) { return false; }
            while (!nodes_[cell.node].isLeaf()) {
                tests.countBoxes(1);
                count_ += enterChild(nodes_[cell.node], ray, &cell, &cells_[count_]) ? 1 : 0;
            }
            const KdNode leaf = nodes_[cell.node];
            *items = {leaf.data, leaf.itemCount()};
            if (items->count > 0) { return true; }
        }
        return false;
    }

  private:
    const KdNode* nodes_ = nullptr;
    KdCell cells_[kKdStackSize];  ///< still to visit, the nearest last
    int count_ = 0;
};

}  // namespace glint
