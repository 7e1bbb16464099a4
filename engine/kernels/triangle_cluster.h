// Memory layout of the triangles in a mesh's leaves. Plain data, host and device alike.
#pragma once

#include <cstdint>

namespace glint {

constexpr int kClusterVertices = 8;
constexpr int kClusterTriangles = 8;

/// Up to eight neighbouring triangles that share up to eight vertices: 128 bytes, two cache lines, instead of
/// the 288 that eight separate triangles need. Vertices are exact copies, so that edges stay watertight
/// across clusters. A triangle that is not used has three equal indices: no ray meets it.
struct alignas(64) TriangleCluster {
    float position[3][kClusterVertices];   ///< x, y, z of each vertex
    uint8_t vertex[3][kClusterTriangles];  ///< the three corners of each triangle, in the mesh's order
    uint32_t firstPrimitive;               ///< into MeshView::clusterPrimitives
    uint32_t count;                        ///< triangles in use
};
static_assert(sizeof(TriangleCluster) == 128);

}  // namespace glint
