// pbrt-v4's equal-area maps of all directions as Glint's maps of longitude and latitude. Internal to the
// pbrt importer.
#pragma once

#include "engine/math/transform.h"
#include "engine/scene/image.h"

namespace glint {

/// A square map of equal areas (math/equal_area.h), laid out anew with `toWorld` turning its directions: up
/// to 4096 columns, each texel the mean of what it covers. Irradiance stays.
ImageF latLongOfEqualArea(const ImageF& map, const Affine& toWorld);
/// pbrt-v3's map: rows from +z down, columns from +x to +y.
ImageF latLongOfPbrt(const ImageF& map, const Affine& toWorld);
/// pbrt-v3's map as a square one of equal areas of the same directions, of as many columns within bounds.
ImageF equalAreaOfPbrt(const ImageF& map);
/// Glint's map, turned by `rotationDeg` about +y (scene/light.h), as a square one of up to 2048 columns.
ImageF equalAreaOfLatLong(const ImageF& map, float rotationDeg);
/// What a surface that faces +z gets of an equal-area map, by luminance.
double illuminanceOfEqualArea(const ImageF& map);

}  // namespace glint
