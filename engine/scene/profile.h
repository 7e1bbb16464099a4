// Profiles of surfaces of revolution: what points make a curve, and the boxes around them.
#pragma once

#include <string>
#include <vector>

#include <glm/ext/vector_double2.hpp>

#include "engine/math/bounds.h"
#include "engine/scene/scene.h"

namespace glint {

constexpr int kHighestProfileDegree = 15;

/// Why the object's points make no profile, with what was expected; "" where they do. The points are finite,
/// curves have a degree of at most 15, pieces of Bézier curves use up all points.
std::string profileFault(const Object& object);

/// Curves that a valid profile consists of, and their degree.
struct ProfileCurves {
    size_t count = 0;
    int degree = 0;
};
ProfileCurves profileCurves(const Object& object);
/// The control points of one of them as a Bézier curve, whichever kind the profile is.
std::vector<glm::dvec2> bezierPoints(const Object& object, size_t curve);

/// The box of the turned profile in object space, by its control points. Empty where there are none.
Bounds profileBounds(const std::vector<Vec2>& points);

}  // namespace glint
