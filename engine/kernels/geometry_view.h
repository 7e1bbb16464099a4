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
    /// ShapeKind::Mesh: index into GeometryView::meshes; Revolved: the profile's first curve in ::curves
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
    uint32_t triangleCount = 0;
    uint32_t vertexCount = 0;
    uint32_t clusterCount = 0;
    uint32_t clusterTriangles = 0;  ///< entries of clusterPrimitives: a kd-tree may hold a triangle twice
    Bounds bounds;
};

constexpr int kMaxProfileDegree = 15;

/// One Bézier curve of a profile (shapes/revolved.h), with the products that a ray's polynomial is made of.
/// All arrays are Bernstein coefficients, the products' of twice the degree.
struct ProfileCurve {
    double x[kMaxProfileDegree + 1];  ///< distance from the axis, signed
    double y[kMaxProfileDegree + 1];  ///< height
    double xSquared[2 * kMaxProfileDegree + 1];
    double ySquared[2 * kMaxProfileDegree + 1];
    double yRaised[2 * kMaxProfileDegree + 1];  ///< y with its degree raised
    double xPowers[4], yPowers[4];              ///< up to degree 3: coefficients of powers
    double radius, lowest, highest;             ///< of a cylinder around it
    double centerY, size;                       ///< of the whole profile's box: middle, diagonal
    int degree;
    uint32_t count;  ///< curves of the profile
    /// Of the whole surface: its area, and the share of it before each of the curve's equal steps of the
    /// parameter, and at its end.
    static constexpr int kAreaSteps = 16;
    float area;
    float areaBefore[kAreaSteps + 1];
    float front;  ///< 1: the front is where (dy/ds, -dx/ds) points to in the half plane; -1: the other side
};

struct GeometryView {
    View<InstanceData> instances;  ///< same indices as SceneDescription::objects
    View<MeshView> meshes;
    View<ProfileCurve> curves;    ///< of all profiles
    AcceleratorView topLevel;     ///< over all finite instances; its kind is that of all meshes
    View<uint32_t> topInstances;  ///< leaf contents of topLevel: indices into instances
    View<uint32_t> planes;        ///< infinite instances, tested one by one
    Bounds bounds;                ///< of the finite instances; a single point at 0 when there are none
};

}  // namespace glint
