// Meshes that share their space are opened at the top level: completely, within the bound, and only they.
#include "engine/builders/opened_meshes.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/geometry_scene.h"

namespace glint {
namespace {

using namespace testing_support;

/// Every `count`-th triangle of the mesh, from `first` on: such parts all have the whole mesh's box.
std::shared_ptr<const MeshData> everyNth(const MeshData& mesh, uint32_t first, uint32_t count) {
    auto part = std::make_shared<MeshData>(mesh);
    part->indices.clear();
    for (uint32_t triangle = first; triangle < mesh.triangleCount(); triangle += count) {
        const auto corner = mesh.indices.begin() + 3 * static_cast<ptrdiff_t>(triangle);
        part->indices.insert(part->indices.end(), corner, corner + 3);
    }
    return part;
}

/// The mesh as `count` objects, as a file of each material has it.
GeometryScene inParts(const MeshData& mesh, uint32_t count, const Affine& place = {}) {
    std::vector<Object> objects;
    std::vector<std::shared_ptr<const MeshData>> meshes;
    for (uint32_t i = 0; i < count; ++i) {
        objects.push_back(makeObject(ShapeKind::Mesh, place, static_cast<int>(i)));
        meshes.push_back(everyNth(mesh, i, count));
    }
    return makeScene(objects, meshes);
}

void countTriangles(const BuiltMesh& mesh, uint32_t root, std::vector<int>* times) {
    if (!isLeaf(root)) {
        const WideNode& node = mesh.accelerator.view.as<WideNode>()[root];
        for (int slot = 0; slot < kNodeWidth; ++slot) {
            if (hasChild(node, slot)) { countTriangles(mesh, node.child[slot], times); }
        }
        return;
    }
    for (uint32_t i = leafFirst(root); i < leafFirst(root) + leafCount(root); ++i) {
        const TriangleCluster& cluster = mesh.clusters[i];
        for (uint32_t lane = 0; lane < cluster.count; ++lane) {
            ++(*times)[mesh.clusterPrimitives[cluster.firstPrimitive + lane]];
        }
    }
}

TEST(OpenedMeshes, EachTriangleIsInOneItem) {
    for (const uint32_t triangles : {60u, 3000u, 60'000u}) {
        SCOPED_TRACE(triangles);
        const GeometryScene scene = inParts(*generated("blob", triangles), 5);
        const std::vector<TopItem>& items = scene.instances->topItems;
        EXPECT_GT(items.size(), 5u);
        EXPECT_LE(items.size(), 5u + kOpenedEntries);
        for (uint32_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
            std::vector<int> times(scene.meshes[mesh]->data->triangleCount(), 0);
            for (const TopItem& item : items) {
                if (item.instance == mesh) { countTriangles(*scene.meshes[mesh], item.root, &times); }
            }
            EXPECT_EQ(std::ranges::count(times, 1), static_cast<ptrdiff_t>(times.size()));
        }
    }
}

/// Boxes tested by rays through the mesh as twelve objects, for each box of it as one.
double boxesInParts(const Affine& place) {
    const auto whole = generated("blob", 20'000);
    const GeometryScene one = makeScene({makeObject(ShapeKind::Mesh, place, 0)}, {whole});
    const GeometryScene parts = inParts(*whole, 12, place);
    Random random(1);
    TestCounts ofOne, ofParts;
    for (int i = 0; i < 20'000; ++i) {
        const Ray ray{random.box(3.0f), random.direction()};
        Hit a{}, b{};
        const bool isHit = intersect<kAllFeatures>(one.view, ray, &a, CountTests{&ofOne});
        EXPECT_EQ(isHit, intersect<kAllFeatures>(parts.view, ray, &b, CountTests{&ofParts}));
        if (isHit) { EXPECT_EQ(a.t, b.t); }
    }
    return static_cast<double>(ofParts.boxes) / static_cast<double>(ofOne.boxes);
}

/// They are 2.5 and 6.0 times as many; 5.7 and 10.4 where no mesh is opened.
TEST(OpenedMeshes, RaysTestFewMoreBoxesThanInOneMesh) {
    EXPECT_LT(boxesInParts({}), 3.0);
    // The world's boxes around turned ones are larger.
    EXPECT_LT(boxesInParts(rotate({0.6f, 0.0f, 0.8f}, 0.5f) * scale(Vec3(-1.5f, 1.0f, 2.0f))), 7.0);
}

TEST(OpenedMeshes, NeighboursStayWhole) {
    const auto cube = generated("cube", 3000);
    std::vector<Object> objects;
    for (int i = 0; i < 9; ++i) {
        // They touch each other, and stand on a floor.
        objects.push_back(makeObject(
            ShapeKind::Mesh,
            translate({2.0f * static_cast<float>(i % 3), 0.0f, 2.0f * static_cast<float>(i / 3)}), 0));
    }
    objects.push_back(makeObject(ShapeKind::Rectangle,
                                 translate({0, -1, 0}) * rotate({1, 0, 0}, 1.5707963f) * scale(Vec3(20.0f))));
    EXPECT_EQ(makeScene(objects, {cube}).instances->topItems.size(), objects.size());
}

TEST(OpenedMeshes, ARoomIsOpenedAndWhatStandsInItIsNot) {
    const std::vector<Object> objects = {
        makeObject(ShapeKind::Mesh, scale(Vec3(10.0f)), 0),
        makeObject(ShapeKind::Mesh, translate({3, -5, 0}), 1),
        makeObject(ShapeKind::Sphere, translate({-4, 2, 1})),
    };
    const GeometryScene scene = makeScene(objects, {generated("cube", 12), generated("blob", 5000)});
    const auto itemsOf = [&](uint32_t instance) {
        return std::ranges::count(scene.instances->topItems, instance, &TopItem::instance);
    };
    EXPECT_GT(itemsOf(0), 1);
    EXPECT_EQ(itemsOf(1), 1);
    EXPECT_EQ(itemsOf(2), 1);
}

TEST(OpenedMeshes, VeryManyObjectsStayWhole) {
    Random random(2);
    std::vector<Object> objects;
    for (size_t i = 0; i < kOpenedObjects; ++i) {
        objects.push_back(makeObject(ShapeKind::Mesh, translate(random.box(3.0f)), 0));
    }
    const auto blob = generated("blob", 600);
    EXPECT_GT(makeScene(objects, {blob}).instances->topItems.size(), objects.size());
    objects.push_back(objects.front());
    EXPECT_EQ(makeScene(objects, {blob}).instances->topItems.size(), objects.size());
}

}  // namespace
}  // namespace glint
