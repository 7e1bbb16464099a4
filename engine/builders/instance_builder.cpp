// Objects to instances with both transforms, and a tree over the boxes of the finite ones.
#include "engine/builders/instance_builder.h"

#include "engine/base/check.h"
#include "engine/builders/bvh_builder.h"

namespace glint {
namespace {

/// Half extents of an affine image of the unit sphere (or, without z, of the unit disc): the lengths of
/// the rows.
Vec3 ellipsoidExtent(const Mat3& linear, bool withZ) {
    Vec3 extent;
    for (int row = 0; row < 3; ++row) {
        const Vec3 r(linear[0][row], linear[1][row], withZ ? linear[2][row] : 0.0f);
        extent[row] = glm::length(r);
    }
    return extent;
}

/// The world-space box of an instance, widened by the rounding of its transform and of the rays into
/// its space.
Bounds worldBounds(const Object& object, const Bounds& meshBounds) {
    const Affine& m = object.objectToWorld;
    Bounds b;
    if (object.shape == ShapeKind::Mesh) {
        b = transformBounds(m, meshBounds);
    } else if (object.shape == ShapeKind::Rectangle) {
        b = transformBounds(m, {Vec3(-1.0f, -1.0f, 0.0f), Vec3(1.0f, 1.0f, 0.0f)});
    } else {
        const Vec3 extent = ellipsoidExtent(m.linear, object.shape == ShapeKind::Sphere);
        b = {m.translation - extent, m.translation + extent};
    }
    const Vec3 pad = 0x1p-20f * (glm::max(absVec(b.lo), absVec(b.hi)) + Vec3(maxComponent(b.extent())));
    return {b.lo - pad, b.hi + pad};
}

InstanceData makeInstance(const Object& object, uint32_t firstEmitter) {
    InstanceData instance;
    instance.objectToWorld = object.objectToWorld;
    instance.worldToObject = inverse(object.objectToWorld);
    instance.mesh = object.shape == ShapeKind::Mesh ? static_cast<uint32_t>(object.mesh) : kNone;
    instance.material = static_cast<uint32_t>(object.material);
    instance.firstEmitter = firstEmitter;
    instance.shape = object.shape;
    if (object.frontOnly) { instance.flags |= kInstanceFrontOnly; }
    if (object.objectToWorld == Affine{}) { instance.flags |= kInstanceIdentity; }
    if (object.objectToWorld.determinant() < 0.0f) { instance.flags |= kInstanceMirrored; }
    return instance;
}

void buildTopLevel(InstanceTable* table, HugeVector<BuildPrimitive>* boxes, bool balanced) {
    BvhOptions options;
    options.balanced = balanced;
    const BinaryTree tree = buildBinaryTree(boxes, options);
    table->topInstances.clear();
    table->topNodes = collapseTree(tree, [&](const BinaryNode& leaf) {
        const uint32_t first = static_cast<uint32_t>(table->topInstances.size());
        for (uint32_t i = leaf.begin; i < leaf.end; ++i) {
            table->topInstances.push_back((*boxes)[i].index);
        }
        return makeLeaf(first, leaf.end - leaf.begin);
    });
}

}  // namespace

GeometryView InstanceTable::view() const {
    return {viewOf(instances),    viewOf(meshes), viewOf(topNodes),
            viewOf(topInstances), viewOf(planes), bounds};
}

size_t InstanceTable::bytes() const {
    return instances.size() * sizeof(InstanceData) + meshes.size() * sizeof(MeshView) +
           topNodes.size() * sizeof(WideNode) + (topInstances.size() + planes.size()) * sizeof(uint32_t);
}

std::shared_ptr<const InstanceTable> buildInstances(
    const SceneDescription& scene, const std::vector<std::shared_ptr<const BuiltMesh>>& meshes,
    const std::vector<uint32_t>& firstEmitter) {
    auto table = std::make_shared<InstanceTable>();
    for (const auto& mesh : meshes) {
        table->meshes.push_back(mesh->view());
    }
    HugeVector<BuildPrimitive> boxes;
    for (uint32_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        table->instances.push_back(makeInstance(object, firstEmitter.empty() ? kNone : firstEmitter[i]));
        if (object.shape == ShapeKind::Plane) {
            table->planes.push_back(i);
            continue;
        }
        const bool isMesh = object.shape == ShapeKind::Mesh;
        if (isMesh && table->meshes[static_cast<size_t>(object.mesh)].triangleCount == 0) { continue; }
        const Bounds meshBounds = isMesh ? table->meshes[static_cast<size_t>(object.mesh)].bounds : Bounds{};
        const Bounds box = worldBounds(object, meshBounds);
        boxes.push_back(makeBuildPrimitive(box, i));
        table->bounds.grow(box);
    }
    if (boxes.empty()) {
        table->bounds = {Vec3(0.0f), Vec3(0.0f)};
        return table;
    }
    buildTopLevel(table.get(), &boxes, false);
    if (traversalStackNeed(table->topNodes) > kTraversalStackSize) {
        buildTopLevel(table.get(), &boxes, true);
    }
    GLINT_CHECK_OP(traversalStackNeed(table->topNodes), <=, uint32_t{kTraversalStackSize});
    return table;
}

}  // namespace glint
