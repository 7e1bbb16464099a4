// Grids that procedural meshes are bent from. Closed ones are watertight: vertices where a grid meets itself
// are exact copies, kept apart only for their texture coordinates.
#pragma once

#include <cstdint>

#include "engine/scene/mesh_data.h"

namespace glint {

using Vec3d = glm::dvec3;

/// A grid of `columns` x `rows` cells. Wrapped sides and the ends of a sphere meet themselves.
struct MeshGrid {
    uint32_t columns;
    uint32_t rows;
    bool wrapColumns;
    bool wrapRows;
    bool poles;  ///< the first and the last row shrink to a point each

    uint32_t stride() const { return columns + 1; }
    uint32_t vertex(uint32_t column, uint32_t row) const { return row * stride() + column; }
    /// The vertex whose position this one shares.
    uint32_t original(uint32_t column, uint32_t row) const {
        if (poles && (row == 0 || row == rows)) { return vertex(0, row); }
        return vertex(wrapColumns ? column % columns : column, wrapRows ? row % rows : row);
    }
};

/// Two triangles a cell, one where a pole leaves no more. `firstVertex` is the grid's vertex(0, 0) in
/// the mesh.
void addGridTriangles(const MeshGrid& grid, uint32_t firstVertex, MeshData* mesh);

/// Normals of all faces around each position, weighted by area; seams get one normal.
void addGridNormals(const MeshGrid& grid, MeshData* mesh);

/// Bends a grid: `position(u, v)` with u and v in [0, 1], evaluated once for each place.
template <class Position>
MeshData bendGrid(const MeshGrid& grid, const Position& position) {
    MeshData mesh;
    const size_t vertices = static_cast<size_t>(grid.stride()) * (grid.rows + 1);
    mesh.positions.resize(vertices);
    mesh.uvs.resize(vertices);
    for (uint32_t row = 0; row <= grid.rows; ++row) {
        for (uint32_t column = 0; column <= grid.columns; ++column) {
            const uint32_t vertex = grid.vertex(column, row);
            const double u = static_cast<double>(column) / grid.columns;
            const double v = static_cast<double>(row) / grid.rows;
            mesh.uvs[vertex] = Vec2(u, v);
            if (grid.original(column, row) == vertex) { mesh.positions[vertex] = Vec3(position(u, v)); }
        }
    }
    for (uint32_t row = 0; row <= grid.rows; ++row) {
        for (uint32_t column = 0; column <= grid.columns; ++column) {
            mesh.positions[grid.vertex(column, row)] = mesh.positions[grid.original(column, row)];
        }
    }
    addGridTriangles(grid, 0, &mesh);
    addGridNormals(grid, &mesh);
    return mesh;
}

}  // namespace glint
