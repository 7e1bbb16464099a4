// Stanford PLY meshes: ASCII, binary little- and big-endian.
//
// Reads vertex x y z, nx ny nz, u v (s t, texture_u texture_v), red green blue, face vertex_indices, texcoord
// and texnumber, and tristrips; any order, any scalar type. Other elements and properties are skipped. What
// is repaired and what is refused stands in engine/io/README.md.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/io/mesh_file.h"

namespace glint {

/// A part for each image that faces use, whose name (`comment TextureFile`) is the part's materialName; one
/// part where there is none. Colours are decoded (vertex_colors.h). Error: line and column in the header and
/// in ASCII data, the byte offset in binary data; no faces.
/// `path` is used in messages.
Result<MeshFile> parsePly(const std::string& bytes, const std::string& path);

/// Gives parts their materials: diffuse, of their image, their colours or grey.
Status readPlyMaterials(const std::string& path, MeshFile* file);

}  // namespace glint
