// Trees over boxes: complete, bounding, the same on any number of threads, and never too deep for
// the traversal.
#include "engine/builders/bvh_builder.h"

#include <cstring>
#include <span>

#include <gtest/gtest.h>

#include "tests/support/geometry_scene.h"

namespace glint {
namespace {

using namespace testing_support;

std::span<const WideNode> nodesOf(const BuiltMesh& mesh) {
    const AcceleratorView& view = mesh.accelerator.view;
    return {view.as<WideNode>(), view.bytes / sizeof(WideNode)};
}

void checkSubtree(const BuiltMesh& mesh, uint32_t index, const Bounds& outer, std::vector<int>* seen) {
    const WideNode& node = nodesOf(mesh)[index];
    for (int i = 0; i < kNodeWidth; ++i) {
        if (node.bounds[0][i] > node.bounds[1][i]) { continue; }
        const Bounds box{Vec3(node.bounds[0][i], node.bounds[2][i], node.bounds[4][i]),
                         Vec3(node.bounds[1][i], node.bounds[3][i], node.bounds[5][i])};
        Bounds joined = outer;
        joined.grow(box);
        EXPECT_TRUE(joined.lo == outer.lo && joined.hi == outer.hi);
        if (!isLeaf(node.child[i])) {
            checkSubtree(mesh, node.child[i], box, seen);
            continue;
        }
        for (uint32_t k = 0; k < leafCount(node.child[i]); ++k) {
            const TriangleCluster& cluster = mesh.clusters[leafFirst(node.child[i]) + k];
            for (uint32_t lane = 0; lane < cluster.count; ++lane) {
                const uint32_t primitive = mesh.clusterPrimitives[cluster.firstPrimitive + lane];
                ++(*seen)[primitive];
                for (int corner = 0; corner < 3; ++corner) {
                    const Vec3& p = mesh.data->positions[mesh.data->indices[3 * primitive + corner]];
                    const int slot = cluster.vertex[corner][lane];
                    EXPECT_EQ(p, Vec3(cluster.position[0][slot], cluster.position[1][slot],
                                      cluster.position[2][slot]));
                    EXPECT_TRUE(glm::all(glm::lessThanEqual(box.lo, p)) &&
                                glm::all(glm::lessThanEqual(p, box.hi)));
                }
            }
        }
    }
}

void checkMesh(const BuiltMesh& mesh) {
    std::vector<int> seen(mesh.data->triangleCount(), 0);
    checkSubtree(mesh, 0, {Vec3(-kInfinity), Vec3(kInfinity)}, &seen);
    for (int count : seen) {
        ASSERT_EQ(count, 1);
    }
    const std::span<const WideNode> nodes = nodesOf(mesh);
    EXPECT_LE(traversalStackNeed({nodes.begin(), nodes.end()}), uint32_t{kTraversalStackSize});
}

template <class Vector>
bool sameBytes(const Vector& a, const Vector& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

TEST(BvhBuilder, EveryTriangleIsInExactlyOneLeafWithinItsBoxes) {
    for (const char* name : {"blob", "cube", "terrain", "torus-knot"}) {
        checkMesh(*buildMesh(generated(name, 20'000), 2));
    }
    checkMesh(*buildMesh(generated("cube", 12), 2));
}

TEST(BvhBuilder, TheResultDoesNotDependOnTheThreads) {
    const auto data = generated("blob", 100'000);
    const auto one = buildMesh(data, 1);
    for (int threads : {2, 3, 5}) {
        const auto more = buildMesh(data, threads);
        EXPECT_TRUE(sameBytes(nodesOf(*one), nodesOf(*more))) << threads;
        EXPECT_TRUE(sameBytes(one->clusters, more->clusters)) << threads;
        EXPECT_EQ(one->clusterPrimitives, more->clusterPrimitives) << threads;
    }
}

TEST(BvhBuilder, SoupsWithoutSharedVerticesFit) {
    Random random(41);
    auto data = std::make_shared<MeshData>();
    for (uint32_t i = 0; i < 9000; ++i) {
        const Vec3 center = random.box(1.0f);
        for (int k = 0; k < 3; ++k) {
            data->indices.push_back(static_cast<uint32_t>(data->positions.size()));
            data->positions.push_back(center + random.box(0.02f));
        }
    }
    checkMesh(*buildMesh(data, 2));
}

TEST(BvhBuilder, IdenticalPointsAndExtremeCoordinatesEnd) {
    for (const float size : {0.0f, 1e-30f, 1e30f, 3e38f}) {
        Random random(42);
        auto data = std::make_shared<MeshData>();
        for (uint32_t i = 0; i < 6000; ++i) {
            data->indices.push_back(i);
            data->positions.push_back(random.box(1.0f) * size);
        }
        checkMesh(*buildMesh(data, 2));
    }
}

TEST(BvhBuilder, TriangleSizesInGeometricProgressionStayWithinTheStack) {
    auto data = std::make_shared<MeshData>();
    for (uint32_t i = 0; i < 120; ++i) {
        for (uint32_t copy = 0; copy < 9; ++copy) {
            const float x = std::ldexp(1.0f, static_cast<int>(i) - 60);
            const uint32_t v = static_cast<uint32_t>(data->positions.size());
            data->positions.insert(data->positions.end(), {Vec3(x, 0, 0), Vec3(0, x, 0), Vec3(0, 0, x)});
            data->indices.insert(data->indices.end(), {v, v + 1, v + 2});
        }
    }
    checkMesh(*buildMesh(data, 2));
}

}  // namespace
}  // namespace glint
