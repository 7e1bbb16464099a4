// The cathedral's plan, and the parts that build it: a nave of seven bays between two aisles, vaulted.
//
// x runs to the south, y up, and z to the west: the nave begins at z = 0 and ends at the east wall, at
// -kEast.
#pragma once

#include "engine/examples/example_folder.h"
#include "engine/examples/model.h"

namespace glint::examples {

namespace plan {
constexpr int kBays = 7;
constexpr double kBay = 5.5;  ///< length of one along the nave
constexpr double kEast = kBays * kBay;
constexpr double kNave = 4.5;   ///< from the middle to the axes of the piers
constexpr double kAisle = 9.0;  ///< from the middle to the outer walls
constexpr double kWall = 0.45;  ///< half the thickness of the nave's walls
constexpr double kPier = 0.62;

constexpr double kArcadeSpring = 4.6, kArcadeRise = 3.0;
constexpr double kStringCourse = 8.4;
constexpr double kVaultSpring = 11.2, kVaultRise = 6.0;
constexpr double kAisleTop = 8.2, kNaveTop = 17.4;
constexpr double kRoseHeight = 11.9, kRoseRadius = 3.0;
}  // namespace plan

/// A pointed opening: jambs up to `spring`, two arcs that meet `rise` above it.
struct PointedArch {
    double halfWidth, sill, spring, rise;

    /// Half width at a height above the springing, from halfWidth to 0.
    double halfWidthAt(double above) const;
    /// Height above the springing at a distance from the middle.
    double heightAt(double x) const;
    /// Points from the left springing over the top to the right one; `jambs`: from sill to sill.
    std::vector<Vec2d> points(int steps, bool jambs) const;
};

constexpr PointedArch kClerestory{1.25, 10.9, 13.2, 2.0};
constexpr PointedArch kAisleWindow{1.0, 2.2, 4.5, 1.7};
constexpr PointedArch kLancet{0.72, 3.6, 6.6, 1.3};
constexpr PointedArch kAisleEnd{1.15, 2.0, 4.4, 1.9};

/// One mesh for each material.
struct CathedralMeshes {
    Detail detail;
    MeshData walls, vaults, stone, floor, wood, carpet, iron, gold, cloth, wax, glass, rose;
    std::vector<Vec3d> globes, lamps, flames;  ///< their middles
};

/// Frames of an arch in the plane of `frame` (its x and y), from left to right: their x is the plane's z, and
/// their y points into the opening.
std::vector<Pose> archPoses(const std::vector<Vec2d>& points, const Pose& frame);

void addPiers(CathedralMeshes* to);
void addArcades(CathedralMeshes* to);
void addWalls(CathedralMeshes* to);
void addVaults(CathedralMeshes* to);
/// Mouldings, mullions and glass of a window in the plane of `frame`, whose z points into the church.
void addWindow(const PointedArch& arch, const Pose& frame, CathedralMeshes* to);
void addRoseWindow(CathedralMeshes* to);
void addFurniture(CathedralMeshes* to);
void addChandeliers(CathedralMeshes* to);
void addAltar(CathedralMeshes* to);

void paintCathedral(ExampleFolder* folder);
/// The whole example: see example_scenes.h.
void writeCathedral(const Detail& detail, ExampleFolder* folder);

}  // namespace glint::examples
