// Latitude-longitude maps as Mitsuba lays them out, as Glint does. Internal to the Mitsuba importer.
//
// Of both, a column's middle lies at (i + 1/2) / width. Rows of Glint are at (j + 1/2) / height; of Mitsuba
// since version 2 the first and the last one lie at the poles. Mitsuba's maps begin at -z, half a turn on.
#pragma once

#include <optional>

#include "engine/math/transform.h"
#include "engine/scene/image.h"

namespace glint {

/// The angle of a rotation about +y in degrees; nothing for other maps.
std::optional<float> turnAboutY(const Affine& map);
/// The map with rows as Glint has them, twice as many.
ImageF withCentredRows(const ImageF& map);
/// The other way: Glint's rows as Mitsuba has them, twice as many and one.
ImageF withRowsAtPoles(const ImageF& map);
/// The map turned by any affine map, of twice the resolution.
ImageF turnedMap(const ImageF& map, const Affine& toWorld, bool hasRowsAtPoles);

}  // namespace glint
