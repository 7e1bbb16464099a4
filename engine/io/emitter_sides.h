// Which sides of a mesh file's lamps shine. Files with MTL do not say, and windings in the wild cannot
// be trusted.
#pragma once

#include <string>

#include "engine/io/mesh_file.h"

namespace glint {

/// Makes emission one-sided where the other side lights nothing but itself: of closed bodies outwards, and of
/// sheets that have a surface close behind them all over (a lamp under a ceiling) away from it, turning them
/// over if need be. Light that leaves them backwards is hardly seen, and noise: the spot of it on the ceiling
/// is next to singular. Everything else goes on shining on both sides. Notes what it made one-sided. The
/// first 64 parts that shine are looked at, so that time stays linear in the triangles.
void chooseEmitterSides(const std::string& path, MeshFile* file);

}  // namespace glint
