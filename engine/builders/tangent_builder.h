// Tangents of meshes whose highlights have a direction: smooth ones, so that brushed metal shows
// no triangles.
#pragma once

#include <memory>
#include <vector>

#include "engine/scene/scene.h"

namespace glint {

/// Of one mesh.
struct MeshTangents {
    std::shared_ptr<const MeshData> mesh;
    /// One a vertex: along u, square to the normal, of unit length; zero where the triangles there have none.
    /// Which way along u it points is open, so that texture coordinates may turn over at a vertex.
    std::vector<Vec3> alongU;
};

/// Means of the triangles around each vertex, by their angles there, and over seams of the texture
/// coordinates where both sides lie within 45 degrees. The mesh has normals and texture coordinates.
std::vector<Vec3> smoothTangents(const MeshData& mesh);

/// Those of the meshes that an object places under an anisotropic material and that have normals and texture
/// coordinates, but no tangents of their own, at the meshes' numbers; null: others. What `previous` has of a
/// mesh is taken from there, also where it is not needed any more.
std::vector<std::shared_ptr<const MeshTangents>> buildTangents(
    const SceneDescription& scene, const std::vector<std::shared_ptr<const MeshTangents>>& previous);

}  // namespace glint
