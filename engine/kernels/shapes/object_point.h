// A surface point in object space, as the shapes answer it.
#pragma once

#include "engine/math/vec.h"

namespace glint {

struct ObjectPoint {
    Vec3 p{0.0f};
    Vec3 error{0.0f};  ///< the true point of the surface lies within p +- error, per axis
    Vec3 ng{0.0f};     ///< on the front side, of any length
    Vec3 ns{0.0f};     ///< of any length; zero: like ng
    Vec2 uv{0.0f};     ///< set where the mask has textures
};

/// The derivatives of a surface's position by its texture coordinates.
struct Tangents {
    Vec3 dpdu;
    Vec3 dpdv;
};

/// v / |v| without overflow or underflow; `fallback` for zero and non-finite vectors.
GLINT_HD inline Vec3 normalizeOr(const Vec3& v, const Vec3& fallback) {
    const float largest = maxComponent(absVec(v));
    if (!(largest > 0.0f && largest < kInfinity)) { return fallback; }
    return glm::normalize(v / largest);
}

}  // namespace glint
