// Walls with their openings, and the vaults.
#include <algorithm>

#include "engine/examples/cathedral.h"

namespace glint::examples {
namespace {

using namespace plan;

/// A flat piece in the plane of x and y between two curves of u, facing z.
template <class Lower, class Upper>
MeshData between(int columns, const Lower& lower, const Upper& upper) {
    MeshData part =
        bendGrid(MeshGrid{static_cast<uint32_t>(columns), 1, false, false, false}, [&](double u, double v) {
            const Vec2d a = lower(u), b = upper(u);
            return Vec3d(a + (b - a) * v, 0.0);
        });
    for (size_t i = 0; i < part.uvs.size(); ++i) {
        part.uvs[i] = Vec2(part.positions[i]);
    }
    return part;
}

MeshData panel(double x0, double x1, double y0, double y1) {
    return between(
        1, [&](double u) { return Vec2d(x0 + (x1 - x0) * u, y0); },
        [&](double u) { return Vec2d(x0 + (x1 - x0) * u, y1); });
}

/// A wall around an opening in the middle of `frame`'s plane, from x0 to x1 and y0 to y1.
void addWallAround(const PointedArch& arch, double x0, double x1, double y0, double y1, const Pose& frame,
                   CathedralMeshes* to) {
    const auto put = [&](const MeshData& part) { add(&to->walls, part, frame); };
    if (arch.sill > y0) { put(panel(x0, x1, y0, arch.sill)); }
    if (arch.spring > arch.sill) {
        put(panel(x0, -arch.halfWidth, arch.sill, arch.spring));
        put(panel(arch.halfWidth, x1, arch.sill, arch.spring));
    }
    put(panel(x0, -arch.halfWidth, arch.spring, y1));
    put(panel(arch.halfWidth, x1, arch.spring, y1));
    const std::vector<Vec2d> curve = arch.points(to->detail.steps(24, 6), false);
    const auto at = [&](double u) {
        return curve[static_cast<size_t>(std::lround(u * static_cast<double>(curve.size() - 1)))];
    };
    put(between(static_cast<int>(curve.size()) - 1, at, [&](double u) { return Vec2d(at(u).x, y1); }));
}

/// A blind arcade under the windows: three niches, each with a colonnette at its sides.
void addTriforium(const Pose& frame, CathedralMeshes* to) {
    const PointedArch niche{0.56, 8.95, 9.6, 0.62};
    const Outline moulding{
        {{0.04, -0.14}, {0.06, -0.1}, {0.06, -0.02}, {0.0, 0.02}, {-0.1, 0.02}, {-0.35, 0.02}}, false};
    const MeshData frameOfNiche =
        sweep(moulding, archPoses(niche.points(to->detail.steps(14, 4), true), Pose{}));
    const MeshData shaft = lathe(
        {{{0.1, 8.88}, {0.1, 8.94}, {0.06, 9.0}, {0.055, 9.42}, {0.08, 9.5}, {0.11, 9.58}, {0.11, 9.64}}},
        to->detail.steps(14, 6));
    for (int i = -1; i <= 1; ++i) {
        const Pose place = frame * Pose{{i * 1.5, 0.0, 0.0}};
        addWallAround(niche, i < 0 ? -1.25 : -0.75, i > 0 ? 1.25 : 0.75, kStringCourse,
                      kClerestory.sill - 0.25, place, to);
        add(&to->walls, panel(-0.7, 0.7, 8.8, 10.4), place * Pose{{0.0, 0.0, -0.34}});
        add(&to->stone, frameOfNiche, place);
        add(&to->stone, shaft, place * Pose{{-0.68, 0.0, 0.05}});
        add(&to->stone, shaft, place * Pose{{0.68, 0.0, 0.05}});
    }
}

/// String courses run the whole length.
void addStringCourse(double x, double y, double size, CathedralMeshes* to) {
    const double side = x > 0 ? 1.0 : -1.0;
    const Outline outline{{{size, -size},
                           {size, 0.0},
                           {0.7 * size, 0.3 * size},
                           {-size, 0.6 * size},
                           {-size, -1.6 * size},
                           {0.0, -1.6 * size},
                           {0.3 * size, -1.1 * size},
                           {0.8 * size, -1.2 * size}},
                          true};
    const Vec3d west(x, y, 0.5), east(x, y, -kEast);
    const Vec3d out(-side, 0.0, 0.0), up(0.0, 1.0, 0.0), ahead = glm::cross(out, up);
    const std::vector<Pose> path{{side > 0 ? west : east, out, up, ahead},
                                 {side > 0 ? east : west, out, up, ahead}};
    add(&to->stone, sweep(outline, path));
}

void addBayWalls(int bay, double side, CathedralMeshes* to) {
    const double z = -(bay + 0.5) * kBay, half = kBay / 2.0;
    const double turn = side > 0 ? -90.0 : 90.0;  // the frame's z points into the nave
    const Pose nave = turned({side * (kNave - kWall), 0.0, z}, turn);
    const PointedArch arcade{kBay / 2 - kPier + 0.45, kArcadeSpring, kArcadeSpring, kArcadeRise + 0.45};
    addWallAround(arcade, -half, half, kArcadeSpring, kStringCourse, nave, to);
    addTriforium(nave, to);
    addWallAround(kClerestory, -half, half, kClerestory.sill - 0.25, kNaveTop, nave, to);
    addWindow(kClerestory, nave, to);
    const Pose aisleSide = turned({side * (kNave + kWall), 0.0, z}, -turn);
    addWallAround(arcade, -half, half, kArcadeSpring, kAisleTop, aisleSide, to);
    const Pose outer = turned({side * kAisle, 0.0, z}, turn);
    addWallAround(kAisleWindow, -half, half, 0.0, kAisleTop, outer, to);
    addWindow(kAisleWindow, outer, to);
}

/// The east wall around the rose: rays from its middle to the wall's edges.
void addRoseWall(const Pose& frame, CathedralMeshes* to) {
    const double low = kStringCourse - kRoseHeight, high = kNaveTop - kRoseHeight, half = kNave;
    const int columns = to->detail.steps(96, 24) / 8 * 8;
    const auto direction = [](double u) {
        return Vec2d(std::cos(-2.0 * kPiD * u), std::sin(-2.0 * kPiD * u));
    };
    const auto edge = [&](double u) {
        const Vec2d d = direction(u);
        const double toSide = half / std::max(1e-9, std::abs(d.x));
        const double toEnd = (d.y > 0 ? high : -low) / std::max(1e-9, std::abs(d.y));
        // A little too far is behind the vault and the walls.
        return d * std::min({toSide * 1.1, toEnd * 1.1});
    };
    add(&to->walls,
        between(
            columns, [&](double u) { return direction(u) * (kRoseRadius + 0.1); }, edge),
        frame * Pose{{0.0, kRoseHeight, 0.0}});
}

void addEastWall(CathedralMeshes* to) {
    const Pose east{{0.0, 0.0, -kEast}};
    addRoseWall(east, to);
    for (int i = -1; i <= 1; ++i) {
        const Pose place = east * Pose{{i * 2.1, 0.0, 0.0}};
        addWallAround(kLancet, i < 0 ? -2.4 : -1.05, i > 0 ? 2.4 : 1.05, 0.0, kStringCourse + 0.6, place, to);
        addWindow(kLancet, place, to);
    }
    for (const double side : {-1.0, 1.0}) {
        const Pose place = east * Pose{{side * (kNave + kAisle) / 2.0, 0.0, 0.0}};
        addWallAround(kAisleEnd, -2.4, 2.4, 0.0, kAisleTop, place, to);
        addWindow(kAisleEnd, place, to);
    }
    add(&to->walls, panel(-9.6, 9.6, 0.0, kNaveTop), turned({0.0, 0.0, 0.6}, 180.0));
}

/// An eighth of a bay's web: from the middle out to the wall (or to the next bay), beside its ridge.
MeshData web(const PointedArch& arch, double halfX, double halfZ, bool toWall, int steps) {
    MeshData part = bendGrid(
        MeshGrid{static_cast<uint32_t>(steps), static_cast<uint32_t>(steps), false, false, false},
        [&](double w, double v) {
            const double q = 0.02 + 0.98 * v;
            const double height = arch.heightAt(arch.halfWidth * w * q);
            return toWall ? Vec3d(halfX * q, height, halfZ * w * q) : Vec3d(halfX * w * q, height, halfZ * q);
        });
    for (size_t i = 0; i < part.uvs.size(); ++i) {
        const Vec3& p = part.positions[i];
        const float across = toWall ? p.z : p.x;
        // Courses run along the ridge; towards the springing the web is steeper than its plan is long.
        part.uvs[i] = {toWall ? p.x : p.z, across + 0.8f * (static_cast<float>(arch.rise) - p.y)};
    }
    return part;
}

/// Ribs along a curve from springing to springing.
void addRib(const PointedArch& arch, double halfLength, double size, const Pose& frame, CathedralMeshes* to) {
    Outline outline{{{0.9, -0.6}, {0.9, 0.3}, {0.55, 0.5}, {0.45, 0.75}}, false};
    for (int i = 0; i <= 8; ++i) {
        const double angle = kPiD * (i / 6.0 - 1.0 / 6.0);
        outline.points.emplace_back(0.5 * std::cos(angle), 1.15 + 0.5 * std::sin(angle));
    }
    for (size_t i = 4; i-- > 0;) {
        outline.points.emplace_back(-outline.points[i].x, outline.points[i].y);
    }
    for (Vec2d& p : outline.points) {
        p *= size;
    }
    std::vector<Vec2d> curve = arch.points(to->detail.steps(26, 6), false);
    for (Vec2d& p : curve) {
        p.x *= halfLength / arch.halfWidth;
    }
    addVaried(&to->stone, sweep(outline, archPoses(curve, frame)), {},
              static_cast<uint64_t>(-frame.origin.z * 4.0));
}

void addVaultBay(const PointedArch& arch, double x, double z, double halfX, CathedralMeshes* to) {
    const double halfZ = kBay / 2.0;
    const int steps = to->detail.steps(18, 4);
    for (const double sx : {-1.0, 1.0}) {
        for (const double sz : {-1.0, 1.0}) {
            const Pose corner{{x, arch.spring, z}, {sx, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, sz}};
            add(&to->vaults, web(arch, halfX, halfZ, true, steps), corner);
            add(&to->vaults, web(arch, halfX, halfZ, false, steps), corner);
        }
    }
    const double diagonal = std::sqrt(halfX * halfX + halfZ * halfZ);
    const double degrees = std::atan2(halfZ, halfX) * 180.0 / kPiD;
    const double size = 0.05 + 0.025 * halfX / kNave * 2.0;
    addRib(arch, diagonal, size, turned({x, 0.0, z}, degrees), to);
    addRib(arch, diagonal, size, turned({x, 0.0, z}, -degrees), to);
    addRib(arch, halfX, 1.6 * size, Pose{{x, 0.0, z + halfZ}}, to);
    if (z - halfZ < 0.5 - kEast) { addRib(arch, halfX, 1.6 * size, Pose{{x, 0.0, z - halfZ}}, to); }
    const double wall = halfX - (halfX == kNave ? kWall : 0.0);
    for (const double side : {-1.0, 1.0}) {
        addRib(arch, halfZ, size, turned({x + side * wall, 0.0, z}, 90.0), to);
    }
    const Outline boss{
        {{0.02, -0.34}, {0.16, -0.32}, {0.24, -0.24}, {0.3, -0.22}, {0.34, -0.14}, {0.3, 0.1}}, false, 50.0};
    add(&to->gold, lathe(boss, to->detail.steps(40, 8)), Pose{{x, arch.spring + arch.rise, z}});
}

}  // namespace

void addWalls(CathedralMeshes* to) {
    for (int bay = 0; bay < kBays; ++bay) {
        addBayWalls(bay, -1.0, to);
        addBayWalls(bay, 1.0, to);
    }
    for (const double side : {-1.0, 1.0}) {
        addStringCourse(side * (kNave - kWall), kStringCourse, 0.1, to);
        addStringCourse(side * (kNave - kWall), kClerestory.sill - 0.3, 0.12, to);
        addStringCourse(side * kAisle, kAisleWindow.sill - 0.3, 0.09, to);
        addStringCourse(side * kAisle, 0.45, 0.07, to);
    }
    addEastWall(to);
    MeshData floor = panel(-9.6, 9.6, -0.6, kEast + 0.1);
    add(&to->floor, floor, Pose{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}});
}

void addVaults(CathedralMeshes* to) {
    const PointedArch nave{kNave, kVaultSpring, kVaultSpring, kVaultRise};
    const PointedArch aisle{(kAisle - kNave) / 2.0, kArcadeSpring, kArcadeSpring, kArcadeRise};
    for (int bay = 0; bay < kBays; ++bay) {
        const double z = -(bay + 0.5) * kBay;
        addVaultBay(nave, 0.0, z, kNave, to);
        addVaultBay(aisle, -(kNave + kAisle) / 2.0, z, aisle.halfWidth, to);
        addVaultBay(aisle, (kNave + kAisle) / 2.0, z, aisle.halfWidth, to);
    }
}

}  // namespace glint::examples
