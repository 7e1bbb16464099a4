#include "engine/builders/triangle_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint {
namespace {

/// Boxes are widened by this part of their triangle's extent: more than the triangle test's shear can move
/// an edge.
constexpr float kBoxPadding = 0x1p-21f;

/// What is left of a triangle: each of six planes adds a corner, or two where rounding has bent an edge.
struct Polygon {
    std::array<glm::dvec3, 16> corners;
    int count = 0;

    void add(const glm::dvec3& p) { corners[static_cast<size_t>(count++)] = p; }
};

/// The part of the polygon where sign * (x - plane) <= 0.
Polygon clipped(const Polygon& polygon, int axis, double plane, double sign) {
    Polygon kept;
    for (int i = 0; i < polygon.count; ++i) {
        const glm::dvec3& a = polygon.corners[static_cast<size_t>(i)];
        const glm::dvec3& b = polygon.corners[static_cast<size_t>((i + 1) % polygon.count)];
        const double beyondA = sign * (a[axis] - plane);
        const double beyondB = sign * (b[axis] - plane);
        if (beyondA <= 0.0) { kept.add(a); }
        if ((beyondA < 0.0 && beyondB > 0.0) || (beyondA > 0.0 && beyondB < 0.0)) {
            glm::dvec3 crossing = a + (b - a) * (beyondA / (beyondA - beyondB));
            crossing[axis] = plane;
            kept.add(crossing);
        }
    }
    return kept;
}

Bounds cornerBounds(const MeshData& mesh, uint32_t triangle) {
    Bounds b;
    for (int corner = 0; corner < 3; ++corner) {
        b.grow(mesh.positions[mesh.indices[3 * size_t{triangle} + static_cast<size_t>(corner)]]);
    }
    return b;
}

Vec3 padding(const Bounds& triangle) { return Vec3(maxComponent(triangle.extent()) * kBoxPadding); }

}  // namespace

Bounds triangleBounds(const MeshData& mesh, uint32_t triangle) {
    const Bounds b = cornerBounds(mesh, triangle);
    const Vec3 pad = padding(b);
    return {b.lo - pad, b.hi + pad};
}

Bounds triangleBoundsIn(const MeshData& mesh, uint32_t triangle, const Bounds& cell) {
    const Vec3 pad = padding(cornerBounds(mesh, triangle));
    Polygon polygon;
    for (int corner = 0; corner < 3; ++corner) {
        polygon.add(mesh.positions[mesh.indices[3 * size_t{triangle} + static_cast<size_t>(corner)]]);
    }
    for (int axis = 0; axis < 3; ++axis) {
        // A widened triangle that reaches into the cell may have its corners outside.
        polygon =
            clipped(polygon, axis, static_cast<double>(cell.hi[axis]) + static_cast<double>(pad[axis]), 1.0);
        polygon =
            clipped(polygon, axis, static_cast<double>(cell.lo[axis]) - static_cast<double>(pad[axis]), -1.0);
    }
    Bounds b;
    for (int i = 0; i < polygon.count; ++i) {
        const Vec3 p(polygon.corners[static_cast<size_t>(i)]);
        for (int axis = 0; axis < 3; ++axis) {
            b.lo[axis] = std::min(b.lo[axis], std::nextafter(p[axis], -kInfinity));
            b.hi[axis] = std::max(b.hi[axis], std::nextafter(p[axis], kInfinity));
        }
    }
    return {b.lo - pad, b.hi + pad};
}

}  // namespace glint
