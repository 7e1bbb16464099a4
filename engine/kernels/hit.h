// Where a ray meets the scene, and the ray as an instance sees it.
#pragma once

#include <bit>

#include "engine/kernels/geometry_view.h"
#include "engine/math/ray.h"

namespace glint {

/// A distance along a ray that means: it meets nothing.
constexpr float kNoHit = -1.0f;

struct Hit {
    float t;
    uint32_t instance;
    uint32_t primitive;  ///< triangle number within the mesh, curve within the profile; 0 for other shapes
    Vec2 barycentric;  ///< weights of a triangle's second and third vertex; x: a curve's parameter; otherwise
                       ///< 0
};

/// The next float up or down (|x| finite).
GLINT_HD inline float nextFloat(float x, bool up) {
    if (x == 0.0f) { return up ? 0x1p-149f : -0x1p-149f; }
    const uint32_t bits = std::bit_cast<uint32_t>(x);
    return std::bit_cast<float>((x > 0.0f) == up ? bits + 1 : bits - 1);
}

/// A ray in an instance's object space; t keeps its meaning.
GLINT_HD inline Ray toObjectSpace(const InstanceData& instance, const Ray& ray) {
    return {instance.worldToObject.point(ray.origin), instance.worldToObject.vector(ray.direction), ray.tMin,
            ray.tMax};
}

}  // namespace glint
