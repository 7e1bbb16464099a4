// An object's transform as the three vectors that people edit.
#pragma once

#include "engine/math/transform.h"

namespace glint {

/// linear = rotation * stretch, where the columns of `stretch` have these lengths along the axes.
struct PlacementNumbers {
    Vec3 position{0.0f};
    Vec3 rotationDeg{0.0f};  ///< about x, then y, then z
    Vec3 scale{1.0f};        ///< x is negative where the transform mirrors
};

/// Columns of unit length at right angles, right-handed: the axes of the object.
Mat3 rotationOf(const Affine& placed);
Mat3 rotationFromDegrees(const Vec3& degrees);
PlacementNumbers numbersOf(const Affine& placed);
/// Moves, turns and stretches `placed`, which may be sheared and stays so, from one set of numbers
/// to another.
Affine withNumbers(const Affine& placed, const PlacementNumbers& from, const PlacementNumbers& to);

}  // namespace glint
