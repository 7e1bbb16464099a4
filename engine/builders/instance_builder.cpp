// Objects to instances with both transforms, and a tree over the boxes of the finite ones.
#include "engine/builders/instance_builder.h"

#include <algorithm>

#include "engine/builders/opened_meshes.h"
#include "engine/kernels/shapes/shape_facts.h"
#include "engine/scene/profile.h"

namespace glint {
namespace {

/// An instance with its world-space box, widened by the rounding of its transform and of the rays into
/// its space.
TopEntry topEntry(const Object& object, const Bounds& own, uint32_t instance) {
    const Bounds b = worldBounds(object.shape, object.objectToWorld, own);
    const Vec3 pad = 0x1p-20f * (glm::max(absVec(b.lo), absVec(b.hi)) + Vec3(maxComponent(b.extent())));
    return {{b.lo - pad, b.hi + pad}, pad, {instance}};
}

InstanceData makeInstance(const Object& object, uint32_t firstEmitter) {
    InstanceData instance;
    instance.objectToWorld = object.objectToWorld;
    instance.worldToObject = inverse(object.objectToWorld);
    if (object.shape == ShapeKind::Mesh) { instance.mesh = static_cast<uint32_t>(object.mesh); }
    instance.material = static_cast<uint32_t>(object.material);
    instance.firstEmitter = firstEmitter;
    instance.shape = object.shape;
    if (object.frontOnly) { instance.flags |= kInstanceFrontOnly; }
    if (object.objectToWorld == Affine{}) { instance.flags |= kInstanceIdentity; }
    if (object.objectToWorld.determinant() < 0.0f) { instance.flags |= kInstanceMirrored; }
    return instance;
}

void buildTopLevel(const SceneDescription& scene, std::vector<TopEntry>* entries, InstanceTable* table) {
    const AcceleratorKind kind = scene.options.accelerator;
    table->topLevel.view.kind = kind;
    if (entries->empty()) {
        table->bounds = {Vec3(0.0f), Vec3(0.0f)};
        return;
    }
    if (kind == AcceleratorKind::Bvh) { openOverlappingMeshes(scene.objects, table->meshes, entries); }
    HugeVector<BuildPrimitive> boxes;
    boxes.reserve(entries->size());
    for (uint32_t i = 0; i < entries->size(); ++i) {
        boxes.push_back(makeBuildPrimitive((*entries)[i].box, i));
    }
    table->topLevel =
        buildAccelerator(kind, &boxes, {}, [](const std::vector<LeafRange>& leaves) { return leaves; });
    table->topItems.reserve(boxes.size());
    for (const BuildPrimitive& box : boxes) {
        table->topItems.push_back((*entries)[box.index].item);
    }
}

}  // namespace

GeometryView InstanceTable::view() const {
    return {viewOf(instances),
            viewOf(meshes),
            viewOf(profiles.profiles),
            viewOf(profiles.curves),
            viewOf(profiles.pieces),
            viewOf(profiles.groups),
            topLevel.view,
            viewOf(topItems),
            viewOf(planes),
            bounds};
}

size_t InstanceTable::bytes() const {
    return instances.size() * sizeof(InstanceData) + meshes.size() * sizeof(MeshView) + profiles.bytes() +
           topLevel.view.bytes + topItems.size() * sizeof(TopItem) + planes.size() * sizeof(uint32_t);
}

std::shared_ptr<const InstanceTable> buildInstances(
    const SceneDescription& scene, const std::vector<std::shared_ptr<const BuiltMesh>>& meshes,
    const std::vector<uint32_t>& firstEmitter,
    const std::vector<std::shared_ptr<const MeshTangents>>& tangents) {
    auto table = std::make_shared<InstanceTable>();
    table->meshes.reserve(meshes.size());
    table->instances.reserve(scene.objects.size());
    for (const auto& mesh : meshes) {
        table->meshes.push_back(mesh->view());
    }
    for (size_t i = 0; i < tangents.size(); ++i) {
        if (tangents[i]) { table->meshes[i].tangents = tangents[i]->alongU.data(); }
    }
    std::vector<TopEntry> entries;
    entries.reserve(scene.objects.size());
    for (uint32_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        table->instances.push_back(makeInstance(object, firstEmitter.empty() ? kNone : firstEmitter[i]));
        if (object.shape == ShapeKind::Revolved) {
            table->instances.back().mesh = addProfile(object, &table->profiles);
        }
        if (!isFiniteShape(object.shape)) {
            table->planes.push_back(i);
            continue;
        }
        const bool isMesh = object.shape == ShapeKind::Mesh;
        if (isMesh && table->meshes[static_cast<size_t>(object.mesh)].triangleCount == 0) { continue; }
        const Bounds own =
            isMesh ? table->meshes[static_cast<size_t>(object.mesh)].bounds : profileBounds(object.profile);
        entries.push_back(topEntry(object, own, i));
        table->bounds.grow(entries.back().box);
    }
    buildTopLevel(scene, &entries, table.get());
    return table;
}

}  // namespace glint
