#include "engine/builders/accelerator.h"

#include "engine/base/check.h"
#include "engine/builders/bvh_builder.h"
#include "engine/builders/kd_builder.h"
#include "engine/kernels/box_list.h"

namespace glint {
namespace {

template <class Node>
Accelerator holding(AcceleratorKind kind, HugeVector<Node> nodes) {
    const auto shared = std::make_shared<const HugeVector<Node>>(std::move(nodes));
    return {shared,
            {reinterpret_cast<const std::byte*>(shared->data()), shared->size() * sizeof(Node), kind}};
}

/// The primitives as they are, each of them or all of them under a box.
HugeVector<BoxedItems> listPrimitives(const HugeVector<BuildPrimitive>& primitives, bool isOne,
                                      const PackLeaves& packLeaves) {
    const auto count = static_cast<uint32_t>(primitives.size());
    std::vector<LeafRange> leaves;
    std::vector<Bounds> boxes;
    for (uint32_t i = 0; i < count; ++i) {
        if (i == 0 || !isOne) {
            leaves.push_back({i, isOne ? count : i + 1});
            boxes.emplace_back();
        }
        boxes.back().grow({primitives[i].lo, -primitives[i].negatedHi});
    }
    const std::vector<LeafRange> items = packLeaves(leaves);
    HugeVector<BoxedItems> list;
    for (size_t i = 0; i < items.size(); ++i) {
        list.push_back({boxes[i], {items[i].begin, items[i].end - items[i].begin}});
    }
    return list;
}

}  // namespace

Accelerator buildAccelerator(AcceleratorKind kind, HugeVector<BuildPrimitive>* primitives,
                             const LeafOptions& options, const PackLeaves& packLeaves) {
    GLINT_CHECK(!primitives->empty());
    switch (kind) {
        case AcceleratorKind::Bvh:
            return holding(kind, buildBvh(primitives, options, packLeaves));
        case AcceleratorKind::KdTree:
            return holding(kind, buildKdTree(primitives, options, packLeaves));
        case AcceleratorKind::Aabb:
            return holding(kind, listPrimitives(*primitives, options.hasOneBox, packLeaves));
        case AcceleratorKind::None:
            return holding(kind, listPrimitives(*primitives, true, packLeaves));
    }
    __builtin_unreachable();
}

}  // namespace glint
