// Compressed buffers of glTF files as plain ones, which the rest reads. Internal to the glTF importer.
#pragma once

#include <string>

#include "engine/io/gltf_file.h"

namespace glint {

constexpr const char* kMeshopt = "EXT_meshopt_compression";
constexpr const char* kDraco = "KHR_draco_mesh_compression";

/// The file as tinygltf reads it, which wants bytes in all buffers, also in those that only stand for what
/// kMeshopt unpacks, and a view behind all indices, also behind those that kDraco holds. Other files, and
/// those that are broken, stay as they are.
std::string readableForTinygltf(std::string bytes);

/// EXT_meshopt_compression: the views that have it show buffers of their own. Error: a view makes no sense,
/// is broken, or states more than its bytes can hold.
Status unpackViews(GltfFile* file);

/// KHR_draco_mesh_compression: the primitives that have it get accessors of their own. Error: as above, or
/// an attribute that the compressed mesh does not have.
Status unpackPrimitives(GltfFile* file);

}  // namespace glint
