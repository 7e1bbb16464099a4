// Meshes to PLY files.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/scene/mesh_data.h"

namespace glint {

/// Saves positions, and normals and texture coordinates where the mesh has them, in binary (little-endian),
/// atomically (atomic_file.h). Error: the file cannot be written.
Status savePly(const std::string& path, const MeshData& mesh);

}  // namespace glint
