// Geometry as kernels see it: flat arrays of instances, meshes and acceleration structures. Plain data.
//
// Never points into a SceneDescription.
#pragma once

#include <cstddef>

#include "engine/base/kinds.h"
#include "engine/base/view.h"
#include "engine/math/bounds.h"
#include "engine/math/transform.h"
#include "engine/math/vec.h"

namespace glint {

struct TriangleCluster;  // triangle_cluster.h
struct ProfileData;      // profile_view.h, like the next three
struct ProfileCurve;
struct ProfilePiece;
struct PieceGroup;

constexpr uint32_t kNone = 0xffffffffu;

/// An acceleration structure: which kind it is, and its nodes as one piece of memory, aligned to 64 bytes,
/// that only code for that kind looks into.
struct AcceleratorView {
    const std::byte* data = nullptr;
    size_t bytes = 0;  ///< 0: no ray meets anything
    AcceleratorKind kind = AcceleratorKind::Bvh;

    GLINT_HD bool empty() const { return bytes == 0; }
    template <class Node>
    GLINT_HD const Node* as() const {
        return reinterpret_cast<const Node*>(data);
    }
};

enum InstanceFlag : uint8_t {
    kInstanceFrontOnly = 1u << 0,
    kInstanceIdentity = 1u << 1,  ///< object space is world space: rays need no transform
    kInstanceMirrored = 1u << 2,  ///< the transform turns counter-clockwise into clockwise
};

struct InstanceData {
    Affine objectToWorld;
    Affine worldToObject;
    /// ShapeKind::Mesh: index into GeometryView::meshes; Revolved: into ::profiles
    uint32_t mesh = kNone;
    uint32_t material = 0;  ///< index into SceneView::materials
    /// emissive: index of this instance's first emitter (one per triangle, in order)
    uint32_t firstEmitter = kNone;
    ShapeKind shape = ShapeKind::Sphere;
    uint8_t flags = 0;
};

/// One mesh in object space. Optional arrays are null when the mesh does not have them.
struct MeshView {
    AcceleratorView accelerator;                  ///< over the clusters; empty when there are no triangles
    const TriangleCluster* clusters = nullptr;    ///< leaf contents
    const uint32_t* clusterPrimitives = nullptr;  ///< triangle numbers, cluster by cluster
    const Vec3* positions = nullptr;
    const uint32_t* indices = nullptr;
    const Vec3* normals = nullptr;
    const Vec2* uvs = nullptr;
    const Vec3* colors = nullptr;
    const Vec3* tangents = nullptr;     ///< along u, either way; where some highlight on it has a direction
    const Vec4* ownTangents = nullptr;  ///< as MeshData::tangents
    uint32_t triangleCount = 0;
    uint32_t vertexCount = 0;
    uint32_t clusterCount = 0;
    uint32_t clusterTriangles = 0;  ///< entries of clusterPrimitives: a kd-tree may hold a triangle twice
    Bounds bounds;
};

/// What a leaf of the top level holds: an instance, or the part of a mesh's that begins at a child reference
/// (bvh_nodes.h) of its tree. 0 is all of it.
struct TopItem {
    uint32_t instance;
    uint32_t root = 0;
};

struct GeometryView {
    View<InstanceData> instances;  ///< same indices as SceneDescription::objects
    View<MeshView> meshes;
    View<ProfileData> profiles;
    View<ProfileCurve> curves;  ///< of all profiles, like the next two
    View<ProfilePiece> pieces;
    View<PieceGroup> groups;
    AcceleratorView topLevel;  ///< over all finite instances; its kind is that of all meshes
    View<TopItem> topItems;    ///< leaf contents of topLevel; an instance may be there in parts
    View<uint32_t> planes;     ///< infinite instances, tested one by one
    Bounds bounds;             ///< of the finite instances; a single point at 0 when there are none
};

}  // namespace glint
