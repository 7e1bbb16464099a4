// The living room's plan, and the parts that build it.
//
// x runs along the wall behind the sofa, y up, and z towards the viewer; the window is in the wall at -x.
#pragma once

#include "engine/examples/example_folder.h"
#include "engine/examples/model.h"

namespace glint::examples {

namespace room {
constexpr double kHalfX = 3.2, kHalfZ = 2.6, kHeight = 2.75;
constexpr double kWindowFrom = -1.25, kWindowTo = 1.05;  ///< in z
constexpr double kWindowLow = 0.45, kWindowHigh = 2.3;
}  // namespace room

/// One mesh for each material; books and cushions have several.
struct RoomMeshes {
    Detail detail;
    MeshData walls, ceiling, trim, planks, sofa, curtain, rug, leather, oak, walnut, brass, iron, paper,
        porcelain, marble;
    MeshData leaf, pot, soil, shade, shadeInside, copper, painting, sketch, photo, fruit, wax, view;
    std::vector<Vec3d> bulbs;  ///< their middles
    MeshData pillows[2];
    MeshData books[5];
};

/// Two bulged sheets with a piping along their seam: `size` is (width, height, thickness), thickness along z.
MeshData cushion(const Vec3d& size, const Detail& detail, uint64_t number);

void addShell(RoomMeshes* to);
void addWindowAndCurtains(RoomMeshes* to);
void addRug(RoomMeshes* to);
void addSofa(const Pose& frame, RoomMeshes* to);
void addArmchair(const Pose& frame, RoomMeshes* to);
void addShelves(const Pose& frame, RoomMeshes* to);
void addCoffeeTable(const Pose& frame, RoomMeshes* to);
void addDiningTable(const Pose& frame, RoomMeshes* to);
void addPlant(const Pose& frame, RoomMeshes* to);
void addLamps(RoomMeshes* to);
void addImages(RoomMeshes* to);

void paintLivingRoom(ExampleFolder* folder);
/// The whole example: see example_scenes.h.
void writeLivingRoom(const Detail& detail, ExampleFolder* folder);

}  // namespace glint::examples
