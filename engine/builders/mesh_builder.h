// One mesh made ready for rays: its triangles with an acceleration structure in object space.
//
// The vertex arrays are shared with the MeshData.
#pragma once

#include <memory>
#include <vector>

#include "engine/builders/accelerator.h"
#include "engine/kernels/triangle_cluster.h"
#include "engine/scene/mesh_data.h"

namespace glint {

struct BuiltMesh {
    std::shared_ptr<const MeshData> data;
    Accelerator accelerator;  ///< empty when the mesh has no triangles or no object places it
    HugeVector<TriangleCluster> clusters;
    std::vector<uint32_t> clusterPrimitives;
    Bounds bounds;  ///< of the vertices that triangles use

    /// Host pointers into this object and its data.
    MeshView view() const;
    /// Whether rays can meet what its data holds.
    bool isReady = true;
    /// Memory of the acceleration structure, without the vertex arrays.
    size_t accelerationBytes() const;
};

/// Deterministic for any number of threads (0: all). Any triangles are accepted: none at all,
/// degenerate, duplicate.
std::shared_ptr<const BuiltMesh> buildMesh(std::shared_ptr<const MeshData> data, int threads,
                                           AcceleratorKind kind = AcceleratorKind::Bvh);

/// `built` with other normals, uvs, colours or tangents: `data` must have the same triangles.
std::shared_ptr<const BuiltMesh> withVertexData(const BuiltMesh& built, std::shared_ptr<const MeshData> data);

/// The data (may be null) without a structure, for meshes that no object places: rays never meet it.
std::shared_ptr<const BuiltMesh> leaveMeshUnbuilt(std::shared_ptr<const MeshData> data);

}  // namespace glint
