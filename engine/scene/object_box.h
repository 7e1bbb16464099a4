// Boxes of placed objects, as seen from the description: in float for views, in double for the questions
// where float's steps matter.
#pragma once

#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <glm/ext/vector_double3.hpp>

#include "engine/scene/scene.h"

namespace glint {

/// Axis-aligned; empty until something is added.
struct WideBox {
    glm::dvec3 lo{std::numeric_limits<double>::infinity()};
    glm::dvec3 hi{-std::numeric_limits<double>::infinity()};

    void grow(const glm::dvec3& p) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    void grow(const WideBox& other) {
        lo = glm::min(lo, other.lo);
        hi = glm::max(hi, other.hi);
    }
    bool empty() const { return lo.x > hi.x; }
    /// The longest edge.
    double size() const { return std::max({hi.x - lo.x, hi.y - lo.y, hi.z - lo.z}); }
    /// The largest coordinate.
    double farthest() const {
        const glm::dvec3 a = glm::max(glm::abs(lo), glm::abs(hi));
        return std::max({a.x, a.y, a.z});
    }
    /// Of the origin from the box, along the axis where it is largest; 0 inside.
    double distanceFromOrigin() const {
        const glm::dvec3 outside = glm::max(glm::max(lo, -hi), glm::dvec3(0.0));
        return std::max({outside.x, outside.y, outside.z});
    }
    glm::dvec3 center() const { return 0.5 * (lo + hi); }
};

/// Of all finite objects, meshes by all of their vertices; empty when there is none. Meshes that have not
/// been read, and indices out of range, are passed over.
Bounds sceneBounds(const SceneDescription& scene);

/// Of the vertices that triangles use; every `step`-th of their corners only.
WideBox meshBox(const MeshData& mesh, size_t step = 1);

/// What the object's transform makes of its shape's box in object space, which is `meshBox` for meshes; empty
/// for shapes without an end and for empty meshes.
WideBox placedBox(const Object& object, const WideBox& meshBox);

}  // namespace glint
