// Procedural meshes for scenes, tests and benchmarks, so that large inputs need no files.
#pragma once

#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/mesh_data.h"

namespace glint {

/// Error: unknown generator (naming the nearest) or a count out of range.
Status checkMeshGenerator(const MeshGenerator& generator);

/// Builds the mesh. Deterministic in (name, triangles, seed); the count is met within a few percent. All have
/// normals and uvs. Error: as checkMeshGenerator().
Result<std::shared_ptr<MeshData>> generateMesh(const MeshGenerator& generator);

/// Known generators in alphabetical order.
std::vector<std::string_view> meshGeneratorNames();

}  // namespace glint
