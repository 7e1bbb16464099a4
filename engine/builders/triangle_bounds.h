// Boxes of a mesh's triangles for acceleration structures, widened so that no ray passes between two boxes
// whose triangles share an edge.
#pragma once

#include "engine/math/bounds.h"
#include "engine/scene/mesh_data.h"

namespace glint {

Bounds triangleBounds(const MeshData& mesh, uint32_t triangle);

/// Of the part of the triangle that lies in the cell, by clipping it (Sutherland and Hodgman 1974). It may
/// reach out of the cell by what it is widened by. Empty where the triangle is out of the cell.
Bounds triangleBoundsIn(const MeshData& mesh, uint32_t triangle, const Bounds& cell);

}  // namespace glint
