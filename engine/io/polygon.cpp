// Ear clipping (Meisters 1975, "Polygons have ears"): cut off corners whose triangle holds no other corner.
//
// Only reflex or straight corners can lie in an ear, and cutting an ear changes only its two neighbours, so
// the whole takes n times the number of such corners. Coordinates are double: differences and products of
// floats hardly round.
#include "engine/io/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glint {
namespace {

using Point = glm::dvec2;

/// Twice the signed area of a, b, c; positive when they turn left.
double cross(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon in the plane of its largest projection, turning left; empty when it has no area.
std::vector<Point> projected(const std::vector<Vec3>& corners) {
    glm::dvec3 area(0.0);
    const glm::dvec3 origin(corners[0]);
    for (size_t i = 1; i + 1 < corners.size(); ++i) {
        area += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[i + 1]) - origin);
    }
    int axis = std::fabs(area.x) > std::fabs(area.y) ? 0 : 1;
    axis = std::fabs(area.z) > std::fabs(area[axis]) ? 2 : axis;
    if (area[axis] == 0.0) { return {}; }
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    std::vector<Point> points;
    points.reserve(corners.size());
    for (const Vec3& corner : corners) {
        const Point p(static_cast<double>(corner[u]), static_cast<double>(corner[v]));
        points.push_back(area[axis] > 0.0 ? p : Point(p.y, p.x));
    }
    return points;
}

/// True when every corner turns left and the border goes round once (a pentagram goes round twice), where
/// coordinates may be off by `error`.
bool isConvex(const std::vector<Point>& points, double error) {
    const size_t n = points.size();
    int directionChanges = 0;
    double lastDx = 0.0;
    double firstDx = 0.0;
    for (size_t i = 0; i < n; ++i) {
        const Point& a = points[i];
        const Point& b = points[(i + 1) % n];
        const Point& c = points[(i + 2) % n];
        const double turnError = 2.0 * error * (glm::length(b - a) + glm::length(c - b));
        if (!(cross(a, b, c) > -turnError)) { return false; }
        const double dx = b.x - a.x;
        if (std::fabs(dx) > 2.0 * error) {
            directionChanges += lastDx * dx < 0.0 ? 1 : 0;
            firstDx = firstDx == 0.0 ? dx : firstDx;
            lastDx = dx;
        }
    }
    return directionChanges + (lastDx * firstDx < 0.0 ? 1 : 0) == 2;
}

/// Of coordinates that are the nearest floats.
double roundingError(const std::vector<Point>& points) {
    double largest = 0.0;
    for (const Point& p : points) {
        largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
    }
    return largest * static_cast<double>(std::numeric_limits<float>::epsilon());
}

void appendFan(size_t corners, std::vector<uint32_t>* triangles) {
    for (uint32_t i = 1; i + 1 < corners; ++i) {
        triangles->insert(triangles->end(), {0, i, i + 1});
    }
}

class EarClipper {
  public:
    EarClipper(const std::vector<Point>& points, std::vector<uint32_t>* triangles)
        : points_(points), triangles_(*triangles), remaining_(static_cast<uint32_t>(points.size())) {
        const uint32_t n = remaining_;
        for (uint32_t i = 0; i < n; ++i) {
            previous_.push_back((i + n - 1) % n);
            next_.push_back((i + 1) % n);
            removed_.push_back(false);
        }
        for (uint32_t i = 0; i < n; ++i) {
            if (!turnsLeft(i)) { blockers_.push_back(i); }
        }
    }

    /// False, with some of the triangles: it would take more than kMaxEarTests.
    bool run() {
        if (uint64_t{remaining_} * blockers_.size() > kMaxEarTests) { return false; }
        uint32_t any = queueEars(0);
        for (int rescans = 0; remaining_ > 3;) {
            if (tests_ > kMaxEarTests) { return false; }
            if (!candidates_.empty()) {
                const uint32_t ear = candidates_.back();
                candidates_.pop_back();
                if (!removed_[ear] && isEar(ear)) {
                    any = clip(ear);
                    queueNeighbours(any);
                }
            } else if (++rescans <= kMaxRescans) {
                any = queueEars(any);  // corners in one place can hide an ear until another is cut
            } else {
                any = clip(leftTurnFrom(any));  // it crosses itself: any way to finish is as good
            }
        }
        emit(any);
        return true;
    }

  private:
    static constexpr int kMaxRescans = 8;

    bool turnsLeft(uint32_t i) const {
        return cross(points_[previous_[i]], points_[i], points_[next_[i]]) > 0.0;
    }

    bool isEar(uint32_t i) {
        const Point& a = points_[previous_[i]];
        const Point& b = points_[i];
        const Point& c = points_[next_[i]];
        if (!(cross(a, b, c) > 0.0)) { return false; }
        for (size_t k = 0; k < blockers_.size();) {
            ++tests_;
            const uint32_t blocker = blockers_[k];
            if (removed_[blocker] || turnsLeft(blocker)) {
                blockers_[k] = blockers_.back();  // a corner that turns left once never blocks again
                blockers_.pop_back();
                continue;
            }
            const Point& p = points_[blocker];
            const bool isCorner = p == a || p == b || p == c;
            if (!isCorner && cross(a, b, p) >= 0.0 && cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0) {
                return false;
            }
            ++k;
        }
        return true;
    }

    /// Queues all ears of what is left and returns `start`, a corner that is left.
    uint32_t queueEars(uint32_t start) {
        uint32_t i = start;
        do {
            if (isEar(i)) { candidates_.push_back(i); }
            i = next_[i];
        } while (i != start);
        return start;
    }

    void queueNeighbours(uint32_t after) {
        for (const uint32_t i : {previous_[after], after}) {
            if (isEar(i)) { candidates_.push_back(i); }
        }
    }

    uint32_t leftTurnFrom(uint32_t start) {
        uint32_t i = start;
        do {
            ++tests_;
            if (turnsLeft(i)) { return i; }
            i = next_[i];
        } while (i != start);
        return start;
    }

    /// Cuts corner i off and returns the one after it.
    uint32_t clip(uint32_t i) {
        emit(i);
        removed_[i] = true;
        next_[previous_[i]] = next_[i];
        previous_[next_[i]] = previous_[i];
        --remaining_;
        return next_[i];
    }

    void emit(uint32_t i) { triangles_.insert(triangles_.end(), {previous_[i], i, next_[i]}); }

    const std::vector<Point>& points_;
    std::vector<uint32_t>& triangles_;
    uint32_t remaining_;
    uint64_t tests_ = 0;  ///< so far, of a corner
    std::vector<uint32_t> previous_, next_;
    std::vector<bool> removed_;
    std::vector<uint32_t> blockers_;    ///< corners that may lie in an ear
    std::vector<uint32_t> candidates_;  ///< corners that were ears when queued
};

}  // namespace

bool triangulatePolygon(const std::vector<Vec3>& corners, std::vector<uint32_t>* triangles) {
    if (corners.size() == 3) {
        appendFan(3, triangles);
        return true;
    }
    const std::vector<Point> points = projected(corners);
    if (points.empty() || isConvex(points, 0.0)) {
        appendFan(corners.size(), triangles);
        return true;
    }
    EarClipper clipper(points, triangles);
    const size_t before = triangles->size();
    if (clipper.run()) { return true; }
    triangles->resize(before);
    const bool isRound = isConvex(points, roundingError(points));
    if (isRound) { appendFan(corners.size(), triangles); }
    return isRound;
}

}  // namespace glint
