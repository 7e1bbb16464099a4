// Stanford PLY meshes: ASCII, binary little- and big-endian.
//
// Reads vertex x y z, nx ny nz, u v (s t, texture_u texture_v), red green blue, and face vertex_indices; any
// order, any scalar type. Other elements and properties are skipped. Left out: triangle strips, per-corner
// texture coordinates.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/scene/mesh_data.h"

namespace glint {

/// Colours stored as integers are sRGB-encoded and become linear; stored as float they are linear already.
/// The mesh is the caller's own. Error: line and column in the header and in ASCII data, the byte offset in
/// binary data.
Result<std::shared_ptr<MeshData>> loadPly(const std::string& path);

/// The same for a file in memory; `path` is used in messages.
Result<std::shared_ptr<MeshData>> parsePly(const std::string& bytes, const std::string& path);

}  // namespace glint
