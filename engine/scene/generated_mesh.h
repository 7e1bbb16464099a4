// Procedural meshes for scenes, tests and benchmarks, so that large inputs need no files.
#pragma once

#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/mesh_data.h"

namespace glint {

/// Error: unknown generator (naming the nearest) or a count out of range.
Status checkMeshGenerator(const MeshSource& source);

/// Builds the mesh a MeshSource with a generator names. Deterministic in (generator, triangles, seed); the
/// count is met within a few percent. All have normals and uvs. Error: as checkMeshGenerator().
Result<std::shared_ptr<MeshData>> generateMesh(const MeshSource& source);

/// Known generators in alphabetical order.
std::vector<std::string_view> meshGeneratorNames();

}  // namespace glint
