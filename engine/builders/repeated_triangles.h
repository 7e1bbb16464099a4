// Triangles that a mesh holds more than once, as exporters leave them. A lamp of such triangles would be
// sampled as often as it is there, and shine too bright.
//
// It is for emissive meshes only: others render alike with or without.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/scene/mesh_data.h"

namespace glint {

/// For each triangle the first one with the same corners in the same turn, itself where there is none before
/// it. `bothSides`: in either turn. Triangles of other indices but equal positions are the same.
std::vector<uint32_t> firstOfRepeatedTriangles(const MeshData& mesh, bool bothSides);

}  // namespace glint
