#include "engine/io/bump_scale.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace glint {
namespace {

/// Of the image's width. White is then as high as mortar is deep in a wall of eight courses.
constexpr double kBumpPerWidth = 0.02;

}  // namespace

void ImageWidth::add(const MeshData& mesh, float scale) {
    if (mesh.uvs.empty()) { return; }
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
        const Vec2 u = mesh.uvs[b] - mesh.uvs[a], v = mesh.uvs[c] - mesh.uvs[a];
        const Vec3 normal =
            glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
        area_ += static_cast<double>(scale * scale * glm::length(normal));
        uvArea_ += static_cast<double>(std::fabs(u.x * v.y - u.y * v.x));
    }
}

float ImageWidth::bumpHeight(const Texture& texture) const {
    const double images = uvArea_ * static_cast<double>(std::fabs(texture.scale.x * texture.scale.y));
    return static_cast<float>(kBumpPerWidth * (images > 0.0 ? std::sqrt(area_ / images) : 1.0));
}

}  // namespace glint
