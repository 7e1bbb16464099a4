#include "engine/io/pbrt_grid.h"

#include <algorithm>
#include <cmath>

#include "engine/math/frame.h"

namespace glint {
namespace {

/// A corner triangle, unless two of its corners are one point.
void addTriangle(uint32_t a, uint32_t b, uint32_t c, MeshData* mesh) {
    const auto& p = mesh->positions;
    if (p[a] != p[b] && p[b] != p[c] && p[c] != p[a]) {
        mesh->indices.insert(mesh->indices.end(), {a, b, c});
    }
}

Vec3 bezierPoint(std::span<const Vec3, 4> c, float t) {
    const Vec3 ab = glm::mix(c[0], c[1], t), bc = glm::mix(c[1], c[2], t), cd = glm::mix(c[2], c[3], t);
    return glm::mix(glm::mix(ab, bc, t), glm::mix(bc, cd, t), t);
}

Vec3 bezierTangent(std::span<const Vec3, 4> c, float t) {
    const Vec3 a = glm::mix(c[1] - c[0], c[2] - c[1], t), b = glm::mix(c[2] - c[1], c[3] - c[2], t);
    return glm::mix(a, b, t);
}

Vec3 unitOr(const Vec3& v, const Vec3& otherwise) {
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length) ? v / length : otherwise;
}

/// By how much the control polygon turns, in all, in radians.
float turnOf(std::span<const Vec3, 4> c) {
    float turn = 0.0f;
    for (size_t i = 0; i < 2; ++i) {
        const Vec3 a = unitOr(c[i + 1] - c[i], Vec3(0.0f)), b = unitOr(c[i + 2] - c[i + 1], Vec3(0.0f));
        turn += isZero(a) || isZero(b) ? 0.0f : std::acos(clampf(glm::dot(a, b), -1.0f, 1.0f));
    }
    return turn;
}

}  // namespace

std::shared_ptr<MeshData> gridMesh(int columns, int rows,
                                   const std::function<GridPoint(float u, float v)>& surface) {
    auto mesh = std::make_shared<MeshData>();
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            const Vec2 uv(static_cast<float>(i) / static_cast<float>(columns),
                          static_cast<float>(j) / static_cast<float>(rows));
            const GridPoint point = surface(uv.x, uv.y);
            mesh->positions.push_back(point.position);
            mesh->normals.push_back(point.normal);
            mesh->uvs.push_back(uv);
        }
    }
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const auto a = static_cast<uint32_t>(j * (columns + 1) + i);
            const uint32_t b = a + 1, d = a + static_cast<uint32_t>(columns) + 1, c = d + 1;
            addTriangle(a, b, c, mesh.get());
            addTriangle(a, c, d, mesh.get());
        }
    }
    return mesh;
}

void appendTube(std::span<const Vec3, 4> curve, float width0, float width1, float u0, float u1,
                MeshData* mesh) {
    constexpr uint32_t kSides = 4;
    constexpr float kTurnPerStep = 0.4f;
    // A convex outline is as wide in the mean as its length over pi.
    const float perWidth =
        kPi / (2.0f * static_cast<float>(kSides) * std::sin(kPi / static_cast<float>(kSides)));
    const int steps = std::clamp(static_cast<int>(std::ceil(turnOf(curve) / kTurnPerStep)), 1, 8);
    Vec3 along = unitOr(curve[3] - curve[0], Vec3(0.0f, 0.0f, 1.0f));
    Vec3 across(0.0f);
    for (int step = 0; step <= steps; ++step) {
        const float t = static_cast<float>(step) / static_cast<float>(steps);
        along = unitOr(bezierTangent(curve, t), along);
        // Each ring is turned as little as can be from the one before.
        across = unitOr(across - glm::dot(across, along) * along, Frame::fromNormal(along).s);
        const Vec3 side = glm::cross(along, across), middle = bezierPoint(curve, t);
        const float radius = perWidth * glm::mix(width0, width1, t);
        const auto first = static_cast<uint32_t>(mesh->positions.size());
        for (uint32_t k = 0; k <= kSides; ++k) {
            const float v = static_cast<float>(k) / static_cast<float>(kSides);
            const Vec3 out = std::cos(kTwoPi * v) * across + std::sin(kTwoPi * v) * side;
            mesh->positions.push_back(middle + radius * out);
            mesh->normals.push_back(out);
            mesh->uvs.emplace_back(glm::mix(u0, u1, t), v);
        }
        for (uint32_t k = 0; step > 0 && k < kSides; ++k) {
            const uint32_t c = first + k, a = c - kSides - 1;
            addTriangle(a, a + 1, c + 1, mesh);
            addTriangle(a, c + 1, c, mesh);
        }
    }
}

}  // namespace glint
