// kd-trees (kernels/kd_tree.h) by the surface area heuristic. Knows boxes and numbers only. The result does
// not depend on the number of threads.
#pragma once

#include "engine/builders/build_primitive.h"

namespace glint {

/// A tree over `primitives`, of which there must be one at least, as its memory. They are replaced by those
/// of the leaves, one leaf after the other: what lies in several leaves is there several times.
HugeVector<std::byte> buildKdTree(HugeVector<BuildPrimitive>* primitives, const LeafOptions& options,
                                  const PackLeaves& packLeaves);

}  // namespace glint
