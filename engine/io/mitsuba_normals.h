// Normals and triangles as Mitsuba makes them. For the importers of Mitsuba and pbrt scenes.
#pragma once

#include "engine/scene/mesh_data.h"

namespace glint {

/// Each vertex gets the mean of its triangles' normals, weighted by their angles (Thürmer and Wüthrich 1998).
void smoothByVertices(MeshData* mesh);
/// Each corner gets the mean of the normals that turn by at most `angleDeg` from its own triangle's, of the
/// triangles that share its position. Vertices are parted.
void smoothByAngle(float angleDeg, MeshData* mesh);
/// Gives each triangle vertices of its own.
void partTriangles(MeshData* mesh);
/// Turns all triangles and normals over.
void turnOver(MeshData* mesh);
/// Whether some edge has not as many triangles on its one side as on the other.
bool isOpenMesh(const MeshData& mesh);

}  // namespace glint
