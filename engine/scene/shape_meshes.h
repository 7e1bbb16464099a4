// The canonical shapes as triangles, for programs that lack them. Texture coordinates are the shapes' own.
#pragma once

#include "engine/scene/mesh_data.h"

namespace glint {

/// Half the side of what stands for an endless plane.
constexpr float kEndOfPlaneMesh = 1e4f;

/// Smooth; 256 steps around, 128 from pole to pole.
MeshData sphereMesh();
MeshData discMesh();
MeshData squareMesh();
MeshData planeMesh();

}  // namespace glint
