// Geometry as kernels see it: flat arrays of instances, meshes and acceleration structures. Plain data.
//
// Filled by engine/build, read by intersect.h and surface.h. Never points into a SceneDescription.
#pragma once

#include "engine/base/kinds.h"
#include "engine/base/view.h"
#include "engine/math/bounds.h"
#include "engine/math/transform.h"
#include "engine/math/vec.h"

namespace glint {

struct WideNode;         // bvh_nodes.h
struct TriangleCluster;  // bvh_nodes.h

constexpr uint32_t kNone = 0xffffffffu;

enum InstanceFlag : uint8_t {
    kInstanceFrontOnly = 1u << 0,
    kInstanceIdentity = 1u << 1,  ///< object space is world space: rays need no transform
    kInstanceMirrored = 1u << 2,  ///< the transform turns counter-clockwise into clockwise
};

struct InstanceData {
    Affine objectToWorld;
    Affine worldToObject;
    uint32_t mesh = kNone;  ///< ShapeKind::Mesh: index into GeometryView::meshes
    uint32_t material = 0;  ///< index into SceneView::materials
    /// emissive: index of this instance's first emitter (one per triangle, in order)
    uint32_t firstEmitter = kNone;
    ShapeKind shape = ShapeKind::Sphere;
    uint8_t flags = 0;
};

/// One mesh in object space. Optional arrays are null when the mesh does not have them.
struct MeshView {
    const WideNode* nodes = nullptr;            ///< nodes[0] is the root; none when the mesh has no triangles
    const TriangleCluster* clusters = nullptr;  ///< leaf contents
    const uint32_t* clusterPrimitives = nullptr;  ///< triangle numbers, cluster by cluster
    const Vec3* positions = nullptr;
    const uint32_t* indices = nullptr;
    const Vec3* normals = nullptr;
    const Vec2* uvs = nullptr;
    const Vec3* colors = nullptr;
    uint32_t triangleCount = 0;
    uint32_t vertexCount = 0;
    uint32_t nodeCount = 0;
    uint32_t clusterCount = 0;
    Bounds bounds;
};

struct GeometryView {
    View<InstanceData> instances;  ///< same indices as SceneDescription::objects
    View<MeshView> meshes;
    View<WideNode> topNodes;      ///< over all finite instances
    View<uint32_t> topInstances;  ///< leaf contents of topNodes: indices into instances
    View<uint32_t> planes;        ///< infinite instances, tested one by one
    Bounds bounds;                ///< of the finite instances; a single point at 0 when there are none
};

}  // namespace glint
