// A closed mesh for the tests of compressed files.
#pragma once

#include <cmath>
#include <numbers>

#include "engine/scene/mesh_grid.h"

namespace glint::test {

/// With normals and texture coordinates.
inline const MeshData& torus() {
    static const MeshData kTorus = bendGrid({48, 32, true, true, false}, [](double u, double v) {
        const double around = 2.0 * u * std::numbers::pi, across = 2.0 * v * std::numbers::pi;
        const double ring = 1.0 + 0.4 * std::cos(across);
        return Vec3d(ring * std::cos(around), ring * std::sin(around), 0.4 * std::sin(across));
    });
    return kTorus;
}

}  // namespace glint::test
