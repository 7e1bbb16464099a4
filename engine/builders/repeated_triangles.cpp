#include "engine/builders/repeated_triangles.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace glint {
namespace {

using Corner = std::array<float, 3>;
using Corners = std::array<Corner, 3>;

/// The corners beginning with the least, in their own turn or sorted.
Corners canonicalCorners(const MeshData& mesh, uint32_t triangle, bool bothSides) {
    Corners corners;
    for (size_t i = 0; i < 3; ++i) {
        const Vec3& p = mesh.positions[mesh.indices[3 * size_t{triangle} + i]];
        corners[i] = {p.x, p.y, p.z};
    }
    if (bothSides) {
        std::ranges::sort(corners);
    } else {
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    }
    return corners;
}

}  // namespace

std::vector<uint32_t> firstOfRepeatedTriangles(const MeshData& mesh, bool bothSides) {
    const uint32_t count = mesh.triangleCount();
    std::vector<Corners> corners(count);
    for (uint32_t i = 0; i < count; ++i) {
        corners[i] = canonicalCorners(mesh, i, bothSides);
    }
    std::vector<uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, [&](uint32_t a, uint32_t b) {
        return corners[a] != corners[b] ? corners[a] < corners[b] : a < b;
    });
    std::vector<uint32_t> first(count);
    for (size_t i = 0; i < count; ++i) {
        const bool repeats = i > 0 && corners[order[i]] == corners[order[i - 1]];
        first[order[i]] = repeats ? first[order[i - 1]] : order[i];
    }
    return first;
}

}  // namespace glint
