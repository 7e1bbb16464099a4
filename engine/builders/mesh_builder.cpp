// Triangles to boxes, boxes to a tree, leaves to clusters of triangles that share vertices.
#include "engine/builders/mesh_builder.h"

#include <algorithm>
#include <limits>

#include "engine/base/check.h"
#include "engine/base/parallel.h"
#include "engine/builders/triangle_bounds.h"

namespace glint {
namespace {

/// Packs triangles into clusters, one after the other.
class ClusterPacker {
  public:
    ClusterPacker(const MeshData& data, const HugeVector<BuildPrimitive>& primitives)
        : data_(data), primitives_(primitives) {}

    /// Appends the leaf's clusters to `clusters` and returns how many they are.
    uint32_t pack(const LeafRange& leaf, std::vector<TriangleCluster>* clusters) const {
        uint32_t vertices = 0;
        uint32_t count = 0;
        for (uint32_t i = leaf.begin; i < leaf.end; ++i) {
            if (count > 0 && tryAdd(primitives_[i].index, &clusters->back(), &vertices)) { continue; }
            TriangleCluster cluster{};
            cluster.firstPrimitive = i;
            clusters->push_back(cluster);
            ++count;
            vertices = 0;
            tryAdd(primitives_[i].index, &clusters->back(), &vertices);
        }
        return count;
    }

  private:
    bool tryAdd(uint32_t triangle, TriangleCluster* cluster, uint32_t* usedVertices) const {
        if (cluster->count == kClusterTriangles) { return false; }
        uint32_t vertices = *usedVertices;
        uint8_t slot[3];
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3& p = data_.positions[data_.indices[3 * size_t{triangle} + corner]];
            uint32_t v = 0;
            while (v < vertices && !(cluster->position[0][v] == p.x && cluster->position[1][v] == p.y &&
                                     cluster->position[2][v] == p.z)) {
                ++v;
            }
            if (v == kClusterVertices) { return false; }
            if (v == vertices) {
                for (int axis = 0; axis < 3; ++axis) {
                    cluster->position[axis][v] = p[axis];
                }
                ++vertices;
            }
            slot[corner] = static_cast<uint8_t>(v);
        }
        *usedVertices = vertices;
        for (int corner = 0; corner < 3; ++corner) {
            cluster->vertex[corner][cluster->count] = slot[corner];
        }
        ++cluster->count;
        return true;
    }

    const MeshData& data_;
    const HugeVector<BuildPrimitive>& primitives_;
};

/// Fills mesh->clusters from the leaves, in their order, and returns each leaf's clusters.
std::vector<LeafRange> packLeaves(const std::vector<LeafRange>& leaves,
                                  const HugeVector<BuildPrimitive>& primitives, int threads,
                                  BuiltMesh* mesh) {
    constexpr size_t kChunk = 2048;
    const size_t chunks = (leaves.size() + kChunk - 1) / kChunk;
    const ClusterPacker packer(*mesh->data, primitives);
    std::vector<std::vector<TriangleCluster>> packed(chunks);
    std::vector<LeafRange> contents(leaves.size());  // at first counted from 0
    parallelChunks(static_cast<int64_t>(chunks), 1, threads, [&](int64_t chunk, int64_t) {
        const size_t c = static_cast<size_t>(chunk);
        const size_t end = std::min(leaves.size(), (c + 1) * kChunk);
        packed[c].reserve((end - c * kChunk) * 5 / 4);
        for (size_t i = c * kChunk; i < end; ++i) {
            contents[i] = {0, packer.pack(leaves[i], &packed[c])};
        }
    });
    std::vector<size_t> first(chunks + 1, 0);
    for (size_t c = 0; c < chunks; ++c) {
        first[c + 1] = first[c] + packed[c].size();
    }
    GLINT_CHECK_OP(first[chunks], <=, size_t{std::numeric_limits<uint32_t>::max()});
    mesh->clusters.resize(first[chunks]);
    parallelChunks(static_cast<int64_t>(chunks), 1, threads, [&](int64_t chunk, int64_t) {
        const size_t c = static_cast<size_t>(chunk);
        std::copy(packed[c].begin(), packed[c].end(),
                  mesh->clusters.begin() + static_cast<ptrdiff_t>(first[c]));
        uint32_t next = static_cast<uint32_t>(first[c]);
        for (size_t i = c * kChunk; i < std::min(leaves.size(), (c + 1) * kChunk); ++i) {
            contents[i] = {next, next + contents[i].end};
            next = contents[i].end;
        }
    });
    return contents;
}

HugeVector<BuildPrimitive> trianglePrimitives(const MeshData& data, int threads) {
    HugeVector<BuildPrimitive> primitives(data.triangleCount());
    parallelChunks(data.triangleCount(), 1 << 16, threads, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            const uint32_t triangle = static_cast<uint32_t>(i);
            primitives[triangle] = makeBuildPrimitive(triangleBounds(data, triangle), triangle);
        }
    });
    return primitives;
}

/// How many neighbouring triangles usually share kClusterVertices vertices: fewer where hardly any
/// are shared.
uint32_t leafTriangles(const MeshData& data) {
    const bool shared = data.positions.size() < size_t{2} * data.triangleCount();
    return shared ? 6 : 2;
}

}  // namespace

MeshView BuiltMesh::view() const {
    MeshView v;
    v.accelerator = accelerator.view;
    v.clusters = clusters.data();
    v.clusterPrimitives = clusterPrimitives.data();
    v.positions = data->positions.data();
    v.indices = data->indices.data();
    v.normals = data->normals.empty() ? nullptr : data->normals.data();
    v.uvs = data->uvs.empty() ? nullptr : data->uvs.data();
    v.colors = data->colors.empty() ? nullptr : data->colors.data();
    v.ownTangents = data->tangents.empty() ? nullptr : data->tangents.data();
    v.triangleCount = data->triangleCount();
    v.vertexCount = static_cast<uint32_t>(data->positions.size());
    v.clusterCount = static_cast<uint32_t>(clusters.size());
    v.clusterTriangles = static_cast<uint32_t>(clusterPrimitives.size());
    v.bounds = bounds;
    return v;
}

size_t BuiltMesh::accelerationBytes() const {
    return accelerator.view.bytes + clusters.size() * sizeof(TriangleCluster) +
           clusterPrimitives.size() * sizeof(uint32_t);
}

std::shared_ptr<const BuiltMesh> buildMesh(std::shared_ptr<const MeshData> data, int threads,
                                           AcceleratorKind kind) {
    auto mesh = std::make_shared<BuiltMesh>();
    mesh->data = std::move(data);
    mesh->accelerator.view.kind = kind;
    HugeVector<BuildPrimitive> primitives = trianglePrimitives(*mesh->data, threads);
    if (primitives.empty()) { return mesh; }
    for (uint32_t index : mesh->data->indices) {
        mesh->bounds.grow(mesh->data->positions[index]);
    }

    const LeafOptions options{.leafPrimitives = leafTriangles(*mesh->data),
                              .threads = threads,
                              .hasOneBox = true,
                              .clip = [&](uint32_t triangle, const Bounds& cell) {
                                  return triangleBoundsIn(*mesh->data, triangle, cell);
                              }};
    mesh->accelerator =
        buildAccelerator(kind, &primitives, options, [&](const std::vector<LeafRange>& leaves) {
            return packLeaves(leaves, primitives, threads, mesh.get());
        });
    mesh->clusterPrimitives.resize(primitives.size());
    for (size_t i = 0; i < primitives.size(); ++i) {
        mesh->clusterPrimitives[i] = primitives[i].index;
    }
    return mesh;
}

std::shared_ptr<const BuiltMesh> withVertexData(const BuiltMesh& built,
                                                std::shared_ptr<const MeshData> data) {
    auto mesh = std::make_shared<BuiltMesh>(built);
    mesh->data = std::move(data);
    return mesh;
}

std::shared_ptr<const BuiltMesh> leaveMeshUnbuilt(std::shared_ptr<const MeshData> data) {
    auto mesh = std::make_shared<BuiltMesh>();
    mesh->data = data ? std::move(data) : std::make_shared<const MeshData>();
    mesh->isReady = false;
    return mesh;
}

}  // namespace glint
