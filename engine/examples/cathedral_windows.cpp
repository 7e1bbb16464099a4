// Windows: splayed mouldings, tracery and glass.
#include "engine/examples/cathedral.h"

namespace glint::examples {
namespace {

using namespace plan;

constexpr double kDepth = 0.32;  ///< of the glass behind the wall's face

/// A pointed pane in the plane of x and y, its image stretched over all of it.
MeshData pointedPane(const PointedArch& arch) {
    constexpr uint32_t kRows = 6;  // the lowest up to the springing, the others above it
    const double height = arch.spring + arch.rise - arch.sill;
    MeshData part = bendGrid(MeshGrid{1, kRows, false, false, false}, [&](double u, double v) {
        const double above = (v * kRows - 1.0) / (kRows - 1.0) * 0.998 * arch.rise;
        const double y = above < 0.0 ? arch.sill : arch.spring + above;
        return Vec3d((2.0 * u - 1.0) * arch.halfWidthAt(std::max(0.0, above)), y, 0.0);
    });
    for (size_t i = 0; i < part.uvs.size(); ++i) {
        const Vec3d p(part.positions[i]);
        part.uvs[i] = Vec2(Vec2d(0.5 + 0.5 * p.x / arch.halfWidth, (p.y - arch.sill) / height));
    }
    return part;
}

/// A bar of tracery along points in the plane of x and y.
void addBar(const std::vector<Vec2d>& points, double width, const Pose& frame, CathedralMeshes* to,
            bool closed = false) {
    std::vector<Vec3d> places;
    places.reserve(points.size());
    for (const Vec2d& p : points) {
        places.emplace_back(p, 0.0);
    }
    const Outline outline = bevelled(width, 1.7 * width, 0.32 * width);
    add(&to->stone, sweep(outline, along(places, {0.0, 0.0, 1.0}, closed), closed), frame);
}

std::vector<Vec2d> circle(const Vec2d& middle, double radius, int corners) {
    std::vector<Vec2d> points = ellipse(radius, radius, corners).points;
    for (Vec2d& p : points) {
        p += middle;
    }
    return points;
}

}  // namespace

void addWindow(const PointedArch& arch, const Pose& frame, CathedralMeshes* to) {
    const Pose pane = frame * Pose{{0.0, 0.0, -kDepth}};
    add(&to->glass, pointedPane(arch), pane);
    const int steps = to->detail.steps(18, 5);
    const Outline moulding{{{0.02, -0.22},
                            {0.08, -0.2},
                            {0.08, -0.12},
                            {0.0, -0.06},
                            {-0.02, -0.02},
                            {-0.06, 0.02},
                            {-0.08, 0.06},
                            {-0.14, 0.04},
                            {-0.24, 0.08},
                            {-kDepth - 0.02, 0.1}},
                           false};
    std::vector<Vec2d> around = arch.points(steps, true);
    add(&to->stone, sweep(moulding, archPoses(around, frame)));
    const double hw = arch.halfWidth;
    add(&to->stone, roundedBox({2.0 * hw + 0.5, 0.14, kDepth + 0.2}, 0.03),
        frame * Pose{{0.0, arch.sill, -0.12}});
    // Two lights and a circle.
    const double spring = arch.spring - 0.12 * arch.rise;
    const PointedArch light{0.5 * hw, arch.sill, spring, 0.62 * arch.rise};
    for (const double side : {-0.5, 0.5}) {
        addBar(light.points(steps, true), 0.075, pane * Pose{{side * hw, 0.0, 0.05}}, to);
    }
    const Vec2d middle(0.0, arch.spring + 0.45 * arch.rise);
    addBar(circle(middle, 0.38 * hw, 2 * steps), 0.07, pane * Pose{{0.0, 0.0, 0.05}}, to, true);
    for (int i = 0; i < 4; ++i) {
        const double angle = kPiD * (0.25 + 0.5 * i);
        const Vec2d leaf = middle + 0.19 * hw * Vec2d(std::cos(angle), std::sin(angle));
        addBar(circle(leaf, 0.14 * hw, steps), 0.035, pane * Pose{{0.0, 0.0, 0.05}}, to, true);
    }
}

void addRoseWindow(CathedralMeshes* to) {
    const Pose wall{{0.0, kRoseHeight, -kEast}};
    const Pose pane = wall * Pose{{0.0, 0.0, -kDepth}};
    const int steps = to->detail.steps(22, 6);
    MeshData disc = bendGrid(MeshGrid{96, 1, false, false, false}, [&](double u, double v) {
        const double radius = (kRoseRadius + 0.05) * (1.0 - 0.999 * v);
        return Vec3d(radius * std::cos(2.0 * kPiD * u), radius * std::sin(2.0 * kPiD * u), 0.0);
    });
    for (size_t i = 0; i < disc.uvs.size(); ++i) {
        disc.uvs[i] = Vec2(disc.positions[i]) / static_cast<float>(2.0 * kRoseRadius) + 0.5f;
    }
    add(&to->rose, disc, pane);
    const auto ring = [&](double radius, double width, double depth) {
        addBar(circle({0.0, 0.0}, radius, 6 * steps), width, pane * Pose{{0.0, 0.0, depth}}, to, true);
    };
    ring(kRoseRadius, 0.14, 0.1);
    ring(kRoseRadius + 0.12, 0.2, 0.24);
    ring(kRoseRadius + 0.28, 0.12, 0.34);
    ring(0.52, 0.1, 0.07);
    ring(0.34, 0.05, 0.07);
    for (int i = 0; i < 12; ++i) {
        const double angle = kPiD / 6.0 * i;
        const Pose spoke = pane * Pose{{0.0, 0.0, 0.07},
                                       {std::cos(angle), std::sin(angle), 0.0},
                                       {-std::sin(angle), std::cos(angle), 0.0},
                                       {0.0, 0.0, 1.0}};
        addBar({{0.55, 0.0}, {1.2, 0.0}, {1.9, 0.0}}, 0.075, spoke, to);
        addBar(circle({1.9, 0.0}, 0.07, steps), 0.06, spoke, to, true);
        std::vector<Vec2d> arc;  // from this spoke to the next one, outwards
        for (int k = 0; k <= steps; ++k) {
            const double t = static_cast<double>(k) / steps, a = kPiD / 6.0 * t;
            const double radius = 1.9 + 0.42 * std::sin(kPiD * t);
            arc.emplace_back(radius * std::cos(a), radius * std::sin(a));
        }
        addBar(arc, 0.07, spoke, to);
        const double between = kPiD / 12.0;
        addBar(circle({2.62 * std::cos(0.0), 0.0}, 0.34, 2 * steps), 0.06, spoke, to, true);
        addBar({{2.3 * std::cos(between), 2.3 * std::sin(between)},
                {2.98 * std::cos(between), 2.98 * std::sin(between)}},
               0.06, spoke, to);
        for (int leaf = 0; leaf < 4; ++leaf) {
            const double turn = kPiD * (0.25 + 0.5 * leaf);
            addBar(circle({2.62 + 0.16 * std::cos(turn), 0.16 * std::sin(turn)}, 0.12, steps), 0.03, spoke,
                   to, true);
        }
    }
}

}  // namespace glint::examples
