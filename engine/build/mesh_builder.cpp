// Triangles to boxes, boxes to a tree, leaves to clusters of triangles that share vertices.
#include "engine/build/mesh_builder.h"

#include <algorithm>

#include "engine/base/check.h"
#include "engine/base/parallel.h"
#include "engine/build/bvh_builder.h"

namespace glint {
namespace {

/// Boxes are widened by this part of their triangle's extent: more than the triangle test's shear can move an
/// edge, so that a ray never passes between two boxes whose triangles share that edge.
constexpr float kBoxPadding = 0x1p-21f;

Bounds paddedBounds(const MeshData& mesh, uint32_t triangle) {
    Bounds b;
    for (int corner = 0; corner < 3; ++corner)
        b.grow(mesh.positions[mesh.indices[3 * size_t{triangle} + corner]]);
    const Vec3 pad(maxComponent(b.extent()) * kBoxPadding);
    return {b.lo - pad, b.hi + pad};
}

/// Packs the triangles of leaves into clusters.
class ClusterWriter {
  public:
    explicit ClusterWriter(BuiltMesh* mesh) : mesh_(*mesh), data_(*mesh->data) {}

    /// Appends clusters for the given triangles and returns the reference to them.
    uint32_t write(const BuildPrimitive* begin, const BuildPrimitive* end) {
        const uint32_t first = static_cast<uint32_t>(mesh_.clusters.size());
        for (const BuildPrimitive* p = begin; p != end; ++p) {
            if (p == begin || !tryAdd(p->index)) {
                startCluster();
                tryAdd(p->index);
            }
        }
        const uint32_t count = static_cast<uint32_t>(mesh_.clusters.size()) - first;
        GLINT_CHECK_OP(first, <=, kMaxLeafFirst);
        GLINT_CHECK_OP(count, <=, kMaxLeafItems);
        return makeLeaf(first, count);
    }

  private:
    void startCluster() {
        TriangleCluster cluster{};
        cluster.firstPrimitive = static_cast<uint32_t>(mesh_.clusterPrimitives.size());
        mesh_.clusters.push_back(cluster);
        vertices_ = 0;
    }

    bool tryAdd(uint32_t triangle) {
        TriangleCluster& cluster = mesh_.clusters.back();
        if (cluster.count == kClusterTriangles) return false;
        uint32_t vertices = vertices_;
        uint8_t slot[3];
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3& p = data_.positions[data_.indices[3 * size_t{triangle} + corner]];
            uint32_t v = 0;
            while (v < vertices && !(cluster.position[0][v] == p.x && cluster.position[1][v] == p.y &&
                                     cluster.position[2][v] == p.z)) {
                ++v;
            }
            if (v == kClusterVertices) return false;
            if (v == vertices) {
                for (int axis = 0; axis < 3; ++axis) cluster.position[axis][v] = p[axis];
                ++vertices;
            }
            slot[corner] = static_cast<uint8_t>(v);
        }
        vertices_ = vertices;
        for (int corner = 0; corner < 3; ++corner) cluster.vertex[corner][cluster.count] = slot[corner];
        ++cluster.count;
        mesh_.clusterPrimitives.push_back(triangle);
        return true;
    }

    BuiltMesh& mesh_;
    const MeshData& data_;
    uint32_t vertices_ = 0;
};

HugeVector<BuildPrimitive> trianglePrimitives(const MeshData& data, int threads) {
    HugeVector<BuildPrimitive> primitives(data.triangleCount());
    parallelChunks(data.triangleCount(), 1 << 16, threads, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            const uint32_t triangle = static_cast<uint32_t>(i);
            primitives[triangle] = makeBuildPrimitive(paddedBounds(data, triangle), triangle);
        }
    });
    return primitives;
}

/// How many neighbouring triangles usually share kClusterVertices vertices: fewer where hardly any are
/// shared.
uint32_t leafTriangles(const MeshData& data) {
    const bool shared = data.positions.size() < size_t{2} * data.triangleCount();
    return shared ? 6 : 2;
}

void buildAcceleration(BuiltMesh* mesh, HugeVector<BuildPrimitive>* primitives, const BvhOptions& options) {
    mesh->clusters.clear();
    mesh->clusterPrimitives.clear();
    const BinaryTree tree = buildBinaryTree(primitives, options);
    mesh->clusters.reserve(primitives->size() / 2);
    mesh->clusterPrimitives.reserve(primitives->size());
    ClusterWriter writer(mesh);
    mesh->nodes = collapseTree(tree, [&](const BinaryNode& leaf) {
        return writer.write(primitives->data() + leaf.begin, primitives->data() + leaf.end);
    });
}

}  // namespace

MeshView BuiltMesh::view() const {
    MeshView v;
    v.nodes = nodes.data();
    v.clusters = clusters.data();
    v.clusterPrimitives = clusterPrimitives.data();
    v.positions = data->positions.data();
    v.indices = data->indices.data();
    v.normals = data->normals.empty() ? nullptr : data->normals.data();
    v.uvs = data->uvs.empty() ? nullptr : data->uvs.data();
    v.colors = data->colors.empty() ? nullptr : data->colors.data();
    v.triangleCount = data->triangleCount();
    v.vertexCount = static_cast<uint32_t>(data->positions.size());
    v.nodeCount = static_cast<uint32_t>(nodes.size());
    v.clusterCount = static_cast<uint32_t>(clusters.size());
    v.bounds = bounds;
    return v;
}

size_t BuiltMesh::accelerationBytes() const {
    return nodes.size() * sizeof(WideNode) + clusters.size() * sizeof(TriangleCluster) +
           clusterPrimitives.size() * sizeof(uint32_t);
}

std::shared_ptr<const BuiltMesh> buildMesh(std::shared_ptr<const MeshData> data, int threads) {
    auto mesh = std::make_shared<BuiltMesh>();
    mesh->data = std::move(data);
    HugeVector<BuildPrimitive> primitives = trianglePrimitives(*mesh->data, threads);
    if (primitives.empty()) return mesh;
    for (uint32_t index : mesh->data->indices) mesh->bounds.grow(mesh->data->positions[index]);

    BvhOptions options;
    options.leafPrimitives = leafTriangles(*mesh->data);
    options.threads = threads;
    buildAcceleration(mesh.get(), &primitives, options);
    if (traversalStackNeed(mesh->nodes) > kTraversalStackSize) {
        options.balanced = true;
        buildAcceleration(mesh.get(), &primitives, options);
    }
    GLINT_CHECK_OP(traversalStackNeed(mesh->nodes), <=, uint32_t{kTraversalStackSize});
    return mesh;
}

}  // namespace glint
