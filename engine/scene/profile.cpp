#include "engine/scene/profile.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace glint {
namespace {

int degreeOf(const Object& object) {
    if (object.curve == CurveKind::Bspline) { return 3; }
    return object.curveDegree > 0 ? object.curveDegree : static_cast<int>(object.profile.size()) - 1;
}

}  // namespace

std::string profileFault(const Object& object) {
    const auto count = static_cast<int>(object.profile.size());
    const int degree = degreeOf(object);
    if (!std::ranges::all_of(object.profile,
                             [](const Vec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); })) {
        return "the profile has points that are not finite";
    }
    if (object.curve == CurveKind::Bspline) {
        return count >= 4 ? "" : fmt::format("the profile has {} points; a B-spline needs at least 4", count);
    }
    if (count < 2) { return fmt::format("the profile has {} points; a curve needs at least 2", count); }
    if (degree > kHighestProfileDegree) {
        return fmt::format(
            "the profile's Bézier curve has {} points, so degree {}; expected at most {} points, or a "
            "degree of its pieces",
            count, degree, kHighestProfileDegree + 1);
    }
    if ((count - 1) % degree != 0) {
        return fmt::format("the profile has {} points; pieces of degree {} need k * {} + 1 of them", count,
                           degree, degree);
    }
    return "";
}

ProfileCurves profileCurves(const Object& object) {
    const int degree = degreeOf(object);
    const size_t points = object.profile.size();
    if (object.curve == CurveKind::Bspline) { return {points - 3, degree}; }
    return {(points - 1) / static_cast<size_t>(degree), degree};
}

std::vector<glm::dvec2> bezierPoints(const Object& object, size_t curve) {
    using Point = glm::dvec2;
    if (object.curve == CurveKind::Bspline) {
        const Vec2* p = &object.profile[curve];  // of the span of a uniform cubic B-spline
        const auto knot = [&](int i) {
            return (Point(p[i]) + 4.0 * Point(p[i + 1]) + Point(p[i + 2])) / 6.0;
        };
        return {knot(0), (2.0 * Point(p[1]) + Point(p[2])) / 3.0, (Point(p[1]) + 2.0 * Point(p[2])) / 3.0,
                knot(1)};
    }
    const auto degree = static_cast<std::ptrdiff_t>(profileCurves(object).degree);
    const auto first = object.profile.begin() + static_cast<std::ptrdiff_t>(curve) * degree;
    return {first, first + degree + 1};
}

Bounds profileBounds(const std::vector<Vec2>& points) {
    Bounds box;
    for (const Vec2& p : points) {
        box.grow(Vec3(-std::fabs(p.x), p.y, -std::fabs(p.x)));
        box.grow(Vec3(std::fabs(p.x), p.y, std::fabs(p.x)));
    }
    return box;
}

}  // namespace glint
