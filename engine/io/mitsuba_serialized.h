// Mitsuba's serialized meshes.
#pragma once

#include <memory>
#include <string>

#include "engine/base/result.h"
#include "engine/scene/mesh_data.h"

namespace glint {

struct SerializedMesh {
    std::shared_ptr<MeshData> mesh;  ///< colours linear, as stored
    bool hasFaceNormals = false;     ///< the file wants facets
};

/// The n-th mesh of a file of version 3 or 4, each compressed by itself. Error: not such a file, cut off,
/// broken, more than 2^26 vertices or triangles, positions that are not finite or above 1e18, vertex numbers
/// beyond the end, no triangles, no mesh of that number.
Result<SerializedMesh> parseSerialized(const std::string& bytes, const std::string& path, int number);

}  // namespace glint
