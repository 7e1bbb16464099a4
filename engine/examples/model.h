// What example scenes are modelled with: parts swept, turned, bent and boxed, added to one mesh for
// each material.
//
// Lengths are in metres and y is up; texture coordinates are lengths on the surface in metres, so that an
// image's `scale` in the scene says how large it is. Fronts are outside.
#pragma once

#include <cmath>
#include <vector>

#include "engine/math/rng.h"
#include "engine/scene/mesh_grid.h"

namespace glint::examples {

using Vec2d = glm::dvec2;

/// Where a part stands: the world's place of its origin and of its three axes.
struct Pose {
    Vec3d origin{0.0};
    Vec3d x{1.0, 0.0, 0.0};
    Vec3d y{0.0, 1.0, 0.0};
    Vec3d z{0.0, 0.0, 1.0};

    Vec3d at(const Vec3d& p) const { return origin + p.x * x + p.y * y + p.z * z; }
};

/// Standing at `origin`, turned counter-clockwise from above.
Pose turned(const Vec3d& origin, double degrees);
/// Lying at `origin`: the z of what is placed points up.
Pose lying(const Vec3d& origin);
/// `inner` within `outer`.
Pose operator*(const Pose& outer, const Pose& inner);

/// A curve of points in a plane, to be swept or turned. Corners sharper than `creaseDeg` stay sharp.
struct Outline {
    std::vector<Vec2d> points;
    bool closed = false;
    double creaseDeg = 35.0;
};

/// A circle's or ellipse's outline, counter-clockwise.
Outline ellipse(double radiusX, double radiusY, int corners);
/// A rectangle's, about the origin, with bevelled corners.
Outline bevelled(double width, double height, double bevel);

/// Moves an outline (in x and y, counter-clockwise around what is solid) along frames, each ahead of the one
/// before along its z.
MeshData sweep(const Outline& outline, const std::vector<Pose>& path, bool closedPath = false);
/// Turns an outline of (radius, height), listed upwards along the outside, about y.
MeshData lathe(const Outline& outline, int steps);
/// A solid between two copies of a convex closed outline, `depth` along z from the origin.
MeshData prism(const Outline& outline, double depth);
/// About the origin, edges rounded in `steps` each.
MeshData roundedBox(const Vec3d& size, double radius, int steps = 1);

/// Frames along points: y is as near `up` as can be.
std::vector<Pose> along(const std::vector<Vec3d>& points, const Vec3d& up, bool closed = false);
/// A round tube through points.
MeshData tube(const std::vector<Vec3d>& points, double radius, int corners, bool closed = false);

/// Bends a grid as bendGrid() does; u and v, from 0 to 1, become `lengths`.
template <class Position>
MeshData sheet(uint32_t columns, uint32_t rows, const Vec2d& lengths, const Position& position) {
    MeshData part = bendGrid(MeshGrid{columns, rows, false, false, false}, position);
    for (Vec2& uv : part.uvs) {
        uv = Vec2(Vec2d(uv) * lengths);
    }
    return part;
}

/// Adds a part to a mesh.
void add(MeshData* mesh, const MeshData& part, const Pose& frame = {});
/// Adds a part whose texture begins elsewhere, so that no two look alike.
void addVaried(MeshData* mesh, MeshData part, const Pose& frame, uint64_t number);

/// Numbers in [0, 1) that follow from a seed.
class Dice {
  public:
    explicit Dice(uint64_t seed) : seed_(seed) {}
    double next() { return static_cast<double>(hashCounter(seed_, count_++) >> 11) * 0x1p-53; }
    double between(double least, double most) { return least + (most - least) * next(); }

  private:
    uint64_t seed_;
    uint64_t count_ = 0;
};

/// How finely an example is modelled: 1 as meant, less for quick tests.
struct Detail {
    double level = 1.0;

    /// A number of steps along one side of a grid, which has the square of it in cells.
    int steps(int full, int least = 2) const {
        return std::max(least, static_cast<int>(std::lround(full * std::sqrt(level))));
    }
    /// A number of things.
    int count(int full, int least = 1) const {
        return std::max(least, static_cast<int>(std::lround(full * level)));
    }
};

}  // namespace glint::examples
