#include "engine/scene/mesh_grid.h"

namespace glint {

void addGridTriangles(const MeshGrid& grid, uint32_t firstVertex, MeshData* mesh) {
    for (uint32_t row = 0; row < grid.rows; ++row) {
        for (uint32_t column = 0; column < grid.columns; ++column) {
            const uint32_t a = firstVertex + grid.vertex(column, row);
            const uint32_t b = a + 1;
            const uint32_t c = a + grid.stride();
            const uint32_t d = c + 1;
            const bool atStart = grid.poles && row == 0;
            const bool atEnd = grid.poles && row + 1 == grid.rows;
            if (!atStart) { mesh->indices.insert(mesh->indices.end(), {a, b, d}); }
            if (!atEnd) { mesh->indices.insert(mesh->indices.end(), {a, d, c}); }
        }
    }
}

void addGridNormals(const MeshGrid& grid, MeshData* mesh) {
    std::vector<uint32_t> original(mesh->positions.size());
    for (uint32_t row = 0; row <= grid.rows; ++row) {
        for (uint32_t column = 0; column <= grid.columns; ++column) {
            original[grid.vertex(column, row)] = grid.original(column, row);
        }
    }
    std::vector<Vec3d> sums(mesh->positions.size(), Vec3d(0.0));
    for (size_t i = 0; i < mesh->indices.size(); i += 3) {
        const uint32_t* corner = &mesh->indices[i];
        const Vec3d p0 = mesh->positions[corner[0]];
        const Vec3d n =
            glm::cross(Vec3d(mesh->positions[corner[1]]) - p0, Vec3d(mesh->positions[corner[2]]) - p0);
        for (int k = 0; k < 3; ++k) {
            sums[original[corner[k]]] += n;
        }
    }
    mesh->normals.resize(mesh->positions.size());
    for (size_t v = 0; v < sums.size(); ++v) {
        const Vec3d& n = sums[original[v]];
        const double length = glm::length(n);
        mesh->normals[v] = length > 0.0 ? Vec3(n / length) : Vec3(0.0f);
    }
}

}  // namespace glint
