#include "engine/scene/shape_meshes.h"

#include <cmath>
#include <numbers>

#include "engine/scene/mesh_grid.h"

namespace glint {
namespace {

constexpr uint32_t kStepsAround = 256, kStepsUp = 128;

}  // namespace

MeshData sphereMesh() {
    MeshData mesh = bendGrid({kStepsAround, kStepsUp, true, false, true}, [](double u, double v) {
        const double around = (2.0 * u - 1.0) * std::numbers::pi, up = (v - 0.5) * std::numbers::pi;
        return Vec3d(std::sin(around) * std::cos(up), std::sin(up), std::cos(around) * std::cos(up));
    });
    mesh.normals = mesh.positions;
    return mesh;
}

MeshData squareMesh() {
    MeshData mesh;
    for (const Vec2 corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
        mesh.positions.emplace_back(corner, 0.0f);
        mesh.uvs.push_back(0.5f * corner + Vec2(0.5f));
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

MeshData discMesh() {
    MeshData mesh;
    mesh.positions.emplace_back(0.0f);
    for (uint32_t i = 0; i < kStepsAround; ++i) {
        const float angle = kTwoPi * static_cast<float>(i) / kStepsAround;
        mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0f);
        mesh.indices.insert(mesh.indices.end(), {0, i + 1, (i + 1) % kStepsAround + 1});
    }
    for (const Vec3& position : mesh.positions) {
        mesh.uvs.push_back(0.5f * Vec2(position) + Vec2(0.5f));
    }
    return mesh;
}

MeshData planeMesh() {
    MeshData mesh = squareMesh();
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.positions[i] *= kEndOfPlaneMesh;
        mesh.uvs[i] = Vec2(mesh.positions[i]);
        mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
    }
    return mesh;
}

}  // namespace glint
