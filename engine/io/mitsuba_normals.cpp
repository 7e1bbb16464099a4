#include "engine/io/mitsuba_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace glint {
namespace {

struct Triangle {
    Vec3 normal{0.0f};  ///< unit, 0 where it has none
    Vec3 angles{0.0f};  ///< at its corners
};

Triangle triangleOf(const MeshData& mesh, size_t triangle) {
    const uint32_t* corners = &mesh.indices[3 * triangle];
    const Vec3 p[3] = {mesh.positions[corners[0]], mesh.positions[corners[1]], mesh.positions[corners[2]]};
    const auto unit = [](const Vec3& v) {
        const float length = glm::length(v);
        return length > 0.0f && std::isfinite(length) ? v / length : Vec3(0.0f);
    };
    Triangle out;
    out.normal = unit(glm::cross(p[1] - p[0], p[2] - p[0]));
    for (int c = 0; c < 3; ++c) {
        const float cosine = glm::dot(unit(p[(c + 1) % 3] - p[c]), unit(p[(c + 2) % 3] - p[c]));
        out.angles[c] = std::acos(clampf(cosine, -1.0f, 1.0f));
    }
    return out;
}

void normalize(Vec3* sum) {
    const float length = glm::length(*sum);
    *sum = length > 0.0f ? *sum / length : Vec3(0.0f);
}

/// For each vertex the first one of the same position.
std::vector<uint32_t> firstOfPosition(const MeshData& mesh) {
    std::vector<uint32_t> order(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&mesh](uint32_t i) {
        const Vec3& p = mesh.positions[i];
        return std::array{p.x, p.y, p.z};
    };
    std::ranges::stable_sort(order, {}, key);
    std::vector<uint32_t> first(order.size());
    for (size_t i = 0; i < order.size(); ++i) {
        const bool isSame = i > 0 && key(order[i]) == key(order[i - 1]);
        first[order[i]] = isSame ? first[order[i - 1]] : order[i];
    }
    return first;
}

}  // namespace

void smoothByVertices(MeshData* mesh) {
    mesh->normals.assign(mesh->positions.size(), Vec3(0.0f));
    for (size_t t = 0; t < mesh->triangleCount(); ++t) {
        const Triangle triangle = triangleOf(*mesh, t);
        for (int c = 0; c < 3; ++c) {
            mesh->normals[mesh->indices[3 * t + static_cast<size_t>(c)]] +=
                triangle.angles[c] * triangle.normal;
        }
    }
    std::ranges::for_each(mesh->normals, [](Vec3& sum) { normalize(&sum); });
}

void partTriangles(MeshData* mesh) {
    MeshData out;
    const auto part = [mesh](const auto& from, auto* to) {
        for (size_t i = 0; !from.empty() && i < mesh->indices.size(); ++i) {
            to->push_back(from[mesh->indices[i]]);
        }
    };
    part(mesh->positions, &out.positions);
    part(mesh->normals, &out.normals);
    part(mesh->uvs, &out.uvs);
    part(mesh->colors, &out.colors);
    out.indices.resize(mesh->indices.size());
    std::iota(out.indices.begin(), out.indices.end(), 0u);
    *mesh = std::move(out);
}

void smoothByAngle(float angleDeg, MeshData* mesh) {
    constexpr size_t kMostAround = 256;  // beyond, a position's corners cost more than they are worth
    const std::vector<uint32_t> first = firstOfPosition(*mesh);
    std::vector<std::vector<uint32_t>> around(mesh->positions.size());
    std::vector<Triangle> triangles;
    for (size_t t = 0; t < mesh->triangleCount(); ++t) {
        triangles.push_back(triangleOf(*mesh, t));
        for (size_t c = 0; c < 3; ++c) {
            std::vector<uint32_t>& corners = around[first[mesh->indices[3 * t + c]]];
            if (corners.size() < kMostAround) { corners.push_back(static_cast<uint32_t>(3 * t + c)); }
        }
    }
    const float least = std::cos(angleDeg * (kPi / 180.0f));
    std::vector<Vec3> normals(mesh->indices.size());
    for (size_t corner = 0; corner < normals.size(); ++corner) {
        const Vec3& own = triangles[corner / 3].normal;
        Vec3 sum(0.0f);
        for (const uint32_t other : around[first[mesh->indices[corner]]]) {
            const Triangle& triangle = triangles[other / 3];
            if (glm::dot(triangle.normal, own) >= least) {
                sum += triangle.angles[static_cast<int>(other % 3)] * triangle.normal;
            }
        }
        normals[corner] = isZero(sum) ? own : glm::normalize(sum);
    }
    partTriangles(mesh);
    mesh->normals = std::move(normals);
}

void turnOver(MeshData* mesh) {
    for (size_t i = 0; i + 2 < mesh->indices.size(); i += 3) {
        std::swap(mesh->indices[i + 1], mesh->indices[i + 2]);
    }
    for (Vec3& normal : mesh->normals) {
        normal = -normal;
    }
}

bool isOpenMesh(const MeshData& mesh) {
    const std::vector<uint32_t> first = firstOfPosition(mesh);
    std::vector<uint64_t> up, down;
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        const uint64_t a = first[mesh.indices[i]];
        const uint64_t b = first[mesh.indices[i - i % 3 + (i + 1) % 3]];
        if (a < b) { up.push_back(a << 32 | b); }
        if (b < a) { down.push_back(b << 32 | a); }
    }
    std::ranges::sort(up);
    std::ranges::sort(down);
    return up != down;
}

}  // namespace glint
