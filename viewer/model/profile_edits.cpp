#include "viewer/model/profile_edits.h"

#include <algorithm>

#include "engine/scene/profile.h"

namespace glint {
namespace {

using Points = std::vector<Vec2>;

bool change(Object* object, Points points) {
    std::swap(object->profile, points);
    if (profileFault(*object).empty()) { return true; }
    std::swap(object->profile, points);
    return false;
}

/// Farin 2002, "Curves and Surfaces for CAGD", equation 6.1.
Points withDegreeRaised(const Points& points) {
    const size_t degree = points.size() - 1;
    Points raised{points.front()};
    for (size_t i = 1; i <= degree; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(degree + 1);
        raised.push_back(share * points[i - 1] + (1.0f - share) * points[i]);
    }
    raised.push_back(points.back());
    return raised;
}

/// De Casteljau's algorithm at a half: the points of both parts, with the one they share once.
Points halved(Points points) {
    Points first{points.front()}, second{points.back()};
    while (points.size() > 1) {
        for (size_t i = 0; i + 1 < points.size(); ++i) {
            points[i] = 0.5f * (points[i] + points[i + 1]);
        }
        points.pop_back();
        first.push_back(points.front());
        second.push_back(points.back());
    }
    first.insert(first.end(), second.rbegin() + 1, second.rend());
    return first;
}

/// The first point of the curve that the point is on, of Bézier curves of one degree.
size_t curveBegin(const Object& object, size_t point) {
    const auto degree = static_cast<size_t>(object.curveDegree);
    const size_t curves = (object.profile.size() - 1) / degree;
    return std::min(point / degree, curves - 1) * degree;
}

std::ptrdiff_t offset(size_t index) { return static_cast<std::ptrdiff_t>(index); }

}  // namespace

bool moveProfilePoint(Object* object, size_t point, Vec2 to) {
    if (point >= object->profile.size()) { return false; }
    Points points = object->profile;
    points[point] = to;
    return change(object, std::move(points));
}

bool addProfilePoints(Object* object, size_t point) {
    Points points = object->profile;
    if (point >= points.size()) { return false; }
    if (object->curve == CurveKind::Bspline) {
        const Vec2 next = point + 1 < points.size() ? points[point + 1] : points[point];
        points.insert(points.begin() + offset(point + 1), 0.5f * (points[point] + next));
    } else if (object->curveDegree == 0) {
        points = withDegreeRaised(points);
    } else {
        const auto begin = points.begin() + offset(curveBegin(*object, point));
        const auto end = begin + object->curveDegree + 1;
        const Points both = halved(Points(begin, end));
        const auto at = points.erase(begin, end);
        points.insert(at, both.begin(), both.end());
    }
    return change(object, std::move(points));
}

bool removeProfilePoints(Object* object, size_t point) {
    Points points = object->profile;
    if (point >= points.size() || points.size() < 3) { return false; }
    if (object->curve == CurveKind::Bspline || object->curveDegree == 0) {
        points.erase(points.begin() + offset(point));
    } else {
        const size_t begin = curveBegin(*object, point);
        const auto first = points.begin() + offset(begin == 0 ? 0 : begin + 1);
        points.erase(first, first + object->curveDegree);
    }
    return change(object, std::move(points));
}

}  // namespace glint
