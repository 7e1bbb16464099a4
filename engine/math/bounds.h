// Axis-aligned boxes. Host and device. An empty box has lo > hi and joins as the neutral element.
#pragma once

#include "engine/math/vec.h"

namespace glint {

struct Bounds {
    Vec3 lo{kInfinity};
    Vec3 hi{-kInfinity};

    GLINT_HD bool empty() const { return lo.x > hi.x || lo.y > hi.y || lo.z > hi.z; }
    GLINT_HD Vec3 center() const { return 0.5f * lo + 0.5f * hi; }
    GLINT_HD Vec3 extent() const { return hi - lo; }
    GLINT_HD float halfArea() const {
        const Vec3 e = extent();
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }
    GLINT_HD void grow(const Vec3& p) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    GLINT_HD void grow(const Bounds& b) {
        lo = glm::min(lo, b.lo);
        hi = glm::max(hi, b.hi);
    }
};

}  // namespace glint
