// Acceleration structures over boxes, of whichever kind. The result does not depend on the number of threads.
#pragma once

#include <memory>

#include "engine/builders/build_primitive.h"
#include "engine/kernels/geometry_view.h"

namespace glint {

/// Immutable; copies share their nodes.
struct Accelerator {
    std::shared_ptr<const void> nodes;  ///< keeps what `view` points to
    AcceleratorView view;
};

/// Builds a structure over `primitives`, of which there must be one at least, and puts them in the order of
/// its leaves. A kd-tree repeats those that lie in several.
Accelerator buildAccelerator(AcceleratorKind kind, HugeVector<BuildPrimitive>* primitives,
                             const LeafOptions& options, const PackLeaves& packLeaves);

}  // namespace glint
