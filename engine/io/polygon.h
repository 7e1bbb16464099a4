// Splits a polygon into triangles: convex ones as a fan, concave ones by ear clipping. For the mesh loaders.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/math/vec.h"

namespace glint {

/// Ear clipping takes time with corners times corners that are not convex. More than this is not tried: it
/// stands for about a second.
constexpr uint64_t kMaxEarTests = uint64_t{1} << 28;

/// Appends three corner numbers per triangle to `triangles`, keeping the polygon's orientation; n corners
/// give n - 2 triangles. Works in the plane that the polygon's area vector faces most, so slightly bent
/// polygons do. A simple polygon is covered exactly once, also with corners on a straight line or repeated;
/// one that crosses itself is covered somehow. At least 3 corners, all finite and below 1e18. False,
/// and nothing appended: above kMaxEarTests, and not convex even where coordinates may be rounded.
bool triangulatePolygon(const std::vector<Vec3>& corners, std::vector<uint32_t>* triangles);

}  // namespace glint
