// What acceleration structures are built from: boxes, and leaves that say which of them lie together.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "engine/base/huge_pages.h"
#include "engine/math/bounds.h"

namespace glint {

/// A box to sort into a structure, and whose it is. The upper corner is negated, so that joining boxes is
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

/// Entries [begin, end) of an array.
struct LeafRange {
    uint32_t begin, end;
};

/// From the primitives of each leaf, as ranges of their final order, to what the leaf holds, as ranges of
/// whatever array a walk's visitor reads.
using PackLeaves = std::function<std::vector<LeafRange>(const std::vector<LeafRange>& leaves)>;

/// The box of the part of a primitive, by its index, that lies in a cell; empty where none does.
using ClipPrimitive = std::function<Bounds(uint32_t index, const Bounds& cell)>;

struct LeafOptions {
    uint32_t leafPrimitives = 1;  ///< this many are tested at the cost of one, and stay together in a leaf
    int threads = 0;              ///< 0: all
    bool hasOneBox = false;       ///< AcceleratorKind::Aabb: around all of them, instead of around each
    ClipPrimitive clip{};         ///< AcceleratorKind::KdTree; empty: what a primitive's box has there
};

}  // namespace glint
