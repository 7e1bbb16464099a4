// Clustered piers, vaulting shafts and the arches between the piers.
#include <algorithm>

#include "engine/examples/cathedral.h"

namespace glint::examples {
namespace {

using namespace plan;

/// The ground plan of a pier: eight shafts, four of them stronger, around a core.
double lobes(double angle) {
    const double strong = std::pow(std::abs(std::cos(2.0 * angle)), 3.0);
    const double weak = std::pow(std::abs(std::sin(2.0 * angle)), 6.0);
    return 0.78 + 0.22 * strong + 0.14 * weak;
}

struct Course {
    double height, radius;
    double lobed;   ///< how far the plan's lobes show
    double leaves;  ///< how far leaves stick out
};

/// Courses between sharp edges; each list is smooth in itself.
const std::vector<std::vector<Course>>& pierCourses() {
    static const std::vector<std::vector<Course>> kCourses{
        {{0.0, 0.95, 0.0, 0.0}, {0.3, 0.95, 0.0, 0.0}},
        {{0.3, 0.95, 0.0, 0.0}, {0.36, 0.86, 0.3, 0.0}},
        {{0.36, 0.86, 0.3, 0.0}, {0.62, 0.84, 0.5, 0.0}},
        {{0.62, 0.84, 0.5, 0.0},
         {0.68, 0.86, 0.6, 0.0},
         {0.74, 0.82, 0.8, 0.0},
         {0.78, 0.70, 1.0, 0.0},
         {0.84, 0.66, 1.0, 0.0}},
        {{0.84, kPier, 1.0, 0.0}, {kArcadeSpring - 0.86, kPier, 1.0, 0.0}},
        {{kArcadeSpring - 0.86, kPier, 1.0, 0.0},
         {kArcadeSpring - 0.83, 0.67, 1.0, 0.0},
         {kArcadeSpring - 0.78, 0.67, 1.0, 0.0},
         {kArcadeSpring - 0.75, kPier, 1.0, 0.0}},
        {{kArcadeSpring - 0.75, 0.60, 0.9, 0.0},
         {kArcadeSpring - 0.55, 0.66, 0.6, 0.6},
         {kArcadeSpring - 0.40, 0.76, 0.4, 1.0},
         {kArcadeSpring - 0.30, 0.84, 0.3, 0.3},
         {kArcadeSpring - 0.27, 0.78, 0.3, 0.0}},
        {{kArcadeSpring - 0.27, 0.86, 0.2, 0.0},
         {kArcadeSpring - 0.18, 0.88, 0.2, 0.0},
         {kArcadeSpring - 0.08, 0.94, 0.1, 0.0}},
        {{kArcadeSpring - 0.08, 0.94, 0.0, 0.0}, {kArcadeSpring, 0.94, 0.0, 0.0}},
    };
    return kCourses;
}

MeshData course(const std::vector<Course>& list, const Detail& detail) {
    const auto columns = static_cast<uint32_t>(detail.steps(128, 24));
    const bool isLeafy =
        std::any_of(list.begin(), list.end(), [](const Course& c) { return c.leaves > 0.0; });
    const auto rows = static_cast<uint32_t>(isLeafy           ? detail.steps(28, 4)
                                            : list.size() > 2 ? detail.steps(10, 4)
                                                              : 1);
    const double length = list.back().height - list.front().height;
    return sheet(columns, rows, {4.0, length}, [&](double u, double v) {
        const double place = v * static_cast<double>(list.size() - 1);
        const size_t i = std::min(static_cast<size_t>(place), list.size() - 2);
        const double t = place - static_cast<double>(i);
        const Course &a = list[i], &b = list[i + 1];
        const auto between = [t](double from, double to) { return from + (to - from) * t; };
        const double angle = -2.0 * kPiD * u;
        const double leaf =
            std::pow(std::abs(std::cos(8.0 * angle)), 1.5) * 0.14 + 0.05 * std::abs(std::sin(24.0 * angle));
        const double shape = 1.0 + between(a.lobed, b.lobed) * (lobes(angle) - 1.0);
        const double radius = between(a.radius, b.radius) * shape + between(a.leaves, b.leaves) * leaf;
        return Vec3d(radius * std::cos(angle), between(a.height, b.height), radius * std::sin(angle));
    });
}

/// Three shafts up the nave's wall, from a corbel to where the vault springs.
void addVaultingShafts(double z, double side, CathedralMeshes* to) {
    const int corners = to->detail.steps(20, 6);
    const double x = side * (kNave - kWall);
    const double low = kArcadeSpring, high = kVaultSpring;
    for (const double offset : {-0.24, 0.0, 0.24}) {
        const double radius = offset == 0.0 ? 0.15 : 0.11;
        const Pose foot{{x - side * (offset == 0.0 ? 0.14 : 0.06), 0.0, z + offset}};
        const Outline shaft{{{radius + 0.03, low},
                             {radius + 0.03, low + 0.1},
                             {radius, low + 0.16},
                             {radius, high - 0.5},
                             {radius + 0.04, high - 0.46},
                             {radius, high - 0.42},
                             {radius + 0.02, high - 0.3},
                             {radius + 0.13, high - 0.12},
                             {radius + 0.15, high - 0.12},
                             {radius + 0.15, high}}};
        add(&to->stone, lathe(shaft, corners), foot);
    }
}

/// The outline of an arch of three orders, each step with a roll: across the wall (x) and into the
/// opening (y).
Outline archMoulding(double halfDepth) {
    Outline outline{{}, false};
    const auto roll = [&](double x, double y) {  // three quarters of a circle on an edge
        for (int i = 0; i <= 9; ++i) {
            const double angle = kPiD * (i / 6.0 - 0.25);
            outline.points.emplace_back(x + 0.075 * std::cos(angle), y + 0.075 * std::sin(angle));
        }
    };
    outline.points.emplace_back(halfDepth + 0.1, -0.55);
    outline.points.emplace_back(halfDepth + 0.1, -0.42);
    outline.points.emplace_back(halfDepth, -0.34);
    roll(halfDepth - 0.05, -0.24);
    outline.points.emplace_back(halfDepth - 0.16, -0.2);
    outline.points.emplace_back(halfDepth - 0.2, -0.12);
    roll(halfDepth - 0.26, -0.05);
    outline.points.emplace_back(halfDepth - 0.34, 0.0);
    const size_t half = outline.points.size();
    for (size_t i = half; i-- > 0;) {
        outline.points.emplace_back(-outline.points[i].x, outline.points[i].y);
    }
    return outline;
}

}  // namespace

double PointedArch::halfWidthAt(double above) const {
    const double radius = (halfWidth * halfWidth + rise * rise) / (2.0 * halfWidth);
    return std::sqrt(std::max(0.0, radius * radius - above * above)) - (radius - halfWidth);
}

double PointedArch::heightAt(double x) const {
    const double radius = (halfWidth * halfWidth + rise * rise) / (2.0 * halfWidth);
    const double along = std::abs(x) + radius - halfWidth;
    return std::sqrt(std::max(0.0, radius * radius - along * along));
}

std::vector<Vec2d> PointedArch::points(int steps, bool jambs) const {
    const double radius = (halfWidth * halfWidth + rise * rise) / (2.0 * halfWidth);
    const double most = std::asin(std::min(1.0, rise / radius));
    std::vector<Vec2d> left;
    if (jambs) { left.emplace_back(-halfWidth, sill); }
    for (int i = 0; i <= steps; ++i) {
        const double angle = most * i / steps;
        left.emplace_back(radius - halfWidth - radius * std::cos(angle), spring + radius * std::sin(angle));
    }
    left.back() = {0.0, spring + rise};
    std::vector<Vec2d> all = left;
    for (size_t i = left.size() - 1; i-- > 0;) {
        all.emplace_back(-left[i].x, left[i].y);
    }
    return all;
}

std::vector<Pose> archPoses(const std::vector<Vec2d>& points, const Pose& frame) {
    std::vector<Vec3d> places;
    places.reserve(points.size());
    for (const Vec2d& p : points) {
        places.push_back(frame.at({p.x, p.y, 0.0}));
    }
    std::vector<Pose> frames;
    const auto direction = [&](size_t i) { return glm::normalize(places[i + 1] - places[i]); };
    for (size_t i = 0; i < places.size(); ++i) {
        const Vec3d before = direction(i == 0 ? 0 : i - 1), after = direction(std::min(i, places.size() - 2));
        const Vec3d ahead = glm::normalize(before + after);
        // Where the path turns sharply, the outline is stretched so that it keeps its width.
        const double stretch = 1.0 / std::max(0.3, glm::dot(ahead, before));
        const Vec3d inwards = glm::normalize(glm::cross(ahead, frame.z));
        frames.push_back({places[i], frame.z, inwards * stretch, ahead});
    }
    return frames;
}

void addPiers(CathedralMeshes* to) {
    MeshData pier;
    for (const std::vector<Course>& list : pierCourses()) {
        add(&pier, course(list, to->detail));
    }
    for (int i = 0; i <= kBays; ++i) {
        for (const double side : {-1.0, 1.0}) {
            const Vec3d foot(side * kNave, 0.0, -i * kBay);
            addVaried(&to->stone, pier, Pose{foot}, static_cast<uint64_t>(2 * i + (side > 0 ? 1 : 0)));
            addVaultingShafts(foot.z, side, to);
            // Half a pier at the outer wall.
            addVaried(&to->stone, pier, Pose{{side * (kAisle + 0.15), 0.0, foot.z}},
                      static_cast<uint64_t>(100 + 2 * i));
        }
    }
}

void addArcades(CathedralMeshes* to) {
    const PointedArch arch{kBay / 2 - kPier, kArcadeSpring, kArcadeSpring, kArcadeRise};
    const Outline moulding = archMoulding(kWall);
    for (int bay = 0; bay < kBays; ++bay) {
        for (const double side : {-1.0, 1.0}) {
            const Pose middle = turned({side * kNave, 0.0, -(bay + 0.5) * kBay}, 90.0);
            const MeshData part =
                sweep(moulding, archPoses(arch.points(to->detail.steps(28, 6), false), middle));
            addVaried(&to->stone, part, {}, static_cast<uint64_t>(bay));
        }
    }
}

}  // namespace glint::examples
