// Profiles as kernels read them: Bézier curves, and the products of their coefficients.
#pragma once

#include <vector>

#include "engine/kernels/geometry_view.h"
#include "engine/scene/scene.h"

namespace glint {

/// The curves of a surface of revolution, from the profile's first point to its last; its points must be
/// valid (profileFault). Neighbours share the bits of their common end.
std::vector<ProfileCurve> buildProfile(const Object& object);

}  // namespace glint
