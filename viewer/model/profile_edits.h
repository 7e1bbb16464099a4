// Edits of a profile's control points that leave a profile. Each returns false, and changes nothing, where
// they cannot.
#pragma once

#include "engine/scene/scene.h"

namespace glint {

bool moveProfilePoint(Object* object, size_t point, Vec2 to);

/// More points to shape the curve with. Bézier curves stay as they are: one of all points gets a higher
/// degree, and of several the one that the point is on is halved. Of B-splines the point is doubled half way
/// to the next.
bool addProfilePoints(Object* object, size_t point);

/// Takes a point away, or the whole curve that it is on; others keep their points.
bool removeProfilePoints(Object* object, size_t point);

}  // namespace glint
