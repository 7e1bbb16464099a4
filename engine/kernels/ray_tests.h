// Counts what a ray is tested against, for the pictures that show it. Kernels that need no counts pass
// NoTests, which costs nothing.
#pragma once

#include <cstdint>

#include "engine/base/host_device.h"

namespace glint {

struct NoTests {
    GLINT_HD void countBoxes(uint32_t) const {}
    GLINT_HD void countPrimitives(uint32_t) const {}
    GLINT_HD void countNewtonSteps(uint32_t) const {}
};

struct TestCounts {
    uint32_t boxes = 0;  ///< of acceleration structures; planes of kd-trees
    /// triangles, pieces of turned profiles and other shapes, each as often as it was tested
    uint32_t primitives = 0;
    uint32_t newtonSteps = 0;  ///< evaluations of turned profiles
};

struct CountTests {
    TestCounts* counts;

    GLINT_HD void countBoxes(uint32_t boxes) const { counts->boxes += boxes; }
    GLINT_HD void countPrimitives(uint32_t primitives) const { counts->primitives += primitives; }
    GLINT_HD void countNewtonSteps(uint32_t steps) const { counts->newtonSteps += steps; }
};

}  // namespace glint
