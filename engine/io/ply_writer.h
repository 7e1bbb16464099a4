// Meshes to PLY files.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/scene/mesh_data.h"

namespace glint {

/// A binary (little-endian) file of positions, and of normals, texture coordinates and colours where the
/// mesh has them. Colours stay linear, and so are called color_0 to color_2: Glint takes red, green and blue
/// for sRGB.
std::string encodePly(const MeshData& mesh);
/// Saves it atomically (atomic_file.h). Error: the file cannot be written.
Status savePly(const std::string& path, const MeshData& mesh);

}  // namespace glint
