// The normals of a mesh file: which side of a triangle they say is its front, and smooth ones where the file
// has none.
#pragma once

#include <cstdint>
#include <string>

#include "engine/io/mesh_file.h"

namespace glint {

/// Neighbours whose faces turn by more than this meet in an edge, where a file says nothing of smoothing.
constexpr float kCreaseAngleDeg = 40.0f;

/// Turns over triangles whose winding the sum of their vertex normals opposes, and says how many: as other
/// renderers have it, normals decide which side is the front.
uint64_t turnByNormals(MeshData* mesh);

/// Gives normals to triangles that have none, and says how many get other ones than their face's: at each
/// corner the mean, weighted by angles (Thürmer and Wüthrich 1998, "Computing Vertex Normals from Polygonal
/// Facets"), over the fan of faces around it up to the first edge that is none to be smoothed. Smooth are
/// edges of two faces of one smoothing group, and, where the file has no groups, below kCreaseAngleDeg.
/// Positions that are equal are one, also across parts. Vertices where fans meet are parted. Nothing changes
/// where no triangle gets another normal. Time and memory grow linearly with the triangles.
uint64_t addSmoothNormals(std::vector<MeshPart>* parts);

/// Both, with a warning and a note; only the first where the triangles are to stay flat.
void completeNormals(const std::string& path, MeshFile* file, bool isFaceted = false);

}  // namespace glint
