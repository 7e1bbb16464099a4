#include "engine/builders/accelerator.h"

#include "engine/base/check.h"
#include "engine/builders/bvh_builder.h"

namespace glint {
namespace {

template <class Node>
Accelerator holding(AcceleratorKind kind, HugeVector<Node> nodes) {
    const auto shared = std::make_shared<const HugeVector<Node>>(std::move(nodes));
    return {shared,
            {reinterpret_cast<const std::byte*>(shared->data()), shared->size() * sizeof(Node), kind}};
}

}  // namespace

Accelerator buildAccelerator(AcceleratorKind kind, HugeVector<BuildPrimitive>* primitives,
                             const LeafOptions& options, const PackLeaves& packLeaves) {
    GLINT_CHECK(!primitives->empty());
    switch (kind) {
        case AcceleratorKind::Bvh:
            return holding(kind, buildBvh(primitives, options, packLeaves));
    }
    __builtin_unreachable();
}

}  // namespace glint
