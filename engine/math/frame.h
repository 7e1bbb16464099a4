// An orthonormal frame around a unit normal: local z is the normal. Host and device.
#pragma once

#include "engine/math/vec.h"

namespace glint {

struct Frame {
    Vec3 s, t, n;  ///< world-space axes, right-handed: s x t = n

    bool operator==(const Frame&) const = default;

    /// Duff et al. 2017, "Building an Orthonormal Basis, Revisited": continuous but for n.z changing
    /// its sign.
    GLINT_HD static Frame fromNormal(const Vec3& n) {
        const float sign = std::copysign(1.0f, n.z);
        const float a = -1.0f / (sign + n.z);
        const float b = n.x * n.y * a;
        return {Vec3(1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x), Vec3(b, sign + n.y * n.y * a, -n.y),
                n};
    }

    GLINT_HD Vec3 toLocal(const Vec3& w) const { return {glm::dot(w, s), glm::dot(w, t), glm::dot(w, n)}; }
    GLINT_HD Vec3 toWorld(const Vec3& w) const { return s * w.x + t * w.y + n * w.z; }
};

}  // namespace glint
