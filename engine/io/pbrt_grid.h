// pbrt's curved shapes as triangles: quadrics in part or inside out, tubes around curves, Loop's subdivision.
// Internal to the pbrt importer.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "engine/scene/mesh_data.h"

namespace glint {

/// A point of a surface, whose front its normal points to.
struct GridPoint {
    Vec3 position{0.0f};
    Vec3 normal{0.0f};
};

/// The surface over u and v from 0 to 1 as `columns` x `rows` quadrilaterals with these texture coordinates.
/// Those that are flattened to a point or a line are left out.
std::shared_ptr<MeshData> gridMesh(int columns, int rows,
                                   const std::function<GridPoint(float u, float v)>& surface);

/// Loop's subdivision (Loop 1987) with Warren's weights, `levels` times or until there are 8 million
/// triangles, its vertices then where the limit surface is; smooth normals. `indices` are below the number
/// of positions.
std::shared_ptr<MeshData> loopSubdivided(std::vector<Vec3> positions, std::vector<uint32_t> indices,
                                         int levels);

/// Appends a tube around a cubic Bézier curve, as wide in the mean over all directions as a round one whose
/// diameter goes from `width0` to `width1`. u runs along it from `u0` to `u1`, v around.
void appendTube(std::span<const Vec3, 4> curve, float width0, float width1, float u0, float u1,
                MeshData* mesh);

}  // namespace glint
