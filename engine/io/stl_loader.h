// STL, text and binary: triangles without materials, texture coordinates or shared vertices.
//
// Corners in one place become one vertex. The winding decides which side is the front, as in other programs;
// facet normals are not read, for many exporters write zeros or nonsense. What is repaired and what is
// refused stands in engine/io/README.md.
#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/io/mesh_file.h"

namespace glint {

/// Each solid is a part. `path` is used in messages. Error: no facets, a coordinate that is no number, not
/// finite or above 1e18; in texts with line and column.
Result<MeshFile> parseStl(const std::string& bytes, const std::string& path);

/// Whether a file's first bytes (file_kind.h) are a binary STL beyond doubt: as many facets as the file has
/// room for where these are all of it, their coordinates finite and neither huge nor tiny.
bool looksLikeBinaryStl(std::string_view head);
/// Whether they can be a binary STL, though a broken one: it has facets, and most of their coordinates
/// make sense.
bool canBeBinaryStl(std::string_view head);

/// Gives each part the material of a mesh without one.
Status readStlMaterials(const std::string& path, MeshFile* file);

}  // namespace glint
