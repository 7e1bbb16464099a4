#include "engine/builders/tangent_builder.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "engine/kernels/shapes/object_point.h"

namespace glint {
namespace {

/// The direction of u on a triangle, and 0 where its texture coordinates span nothing.
Vec3 directionOfU(const MeshData& mesh, const uint32_t* corner) {
    const Vec3 p0 = mesh.positions[corner[0]];
    const Vec3 edge1 = mesh.positions[corner[1]] - p0, edge2 = mesh.positions[corner[2]] - p0;
    const Vec2 a = mesh.uvs[corner[1]] - mesh.uvs[corner[0]], b = mesh.uvs[corner[2]] - mesh.uvs[corner[0]];
    const double determinant = static_cast<double>(a.x) * static_cast<double>(b.y) -
                               static_cast<double>(a.y) * static_cast<double>(b.x);
    if (determinant == 0.0 || !std::isfinite(determinant)) { return Vec3(0.0f); }
    const Vec3 u = normalizeOr(b.y * edge1 - a.y * edge2, Vec3(0.0f));
    return determinant < 0.0 ? -u : u;
}

float angleAt(const MeshData& mesh, const uint32_t* corner, int which) {
    const Vec3 p = mesh.positions[corner[which]];
    const Vec3 a = normalizeOr(mesh.positions[corner[(which + 1) % 3]] - p, Vec3(0.0f));
    const Vec3 b = normalizeOr(mesh.positions[corner[(which + 2) % 3]] - p, Vec3(0.0f));
    return std::acos(clampf(glm::dot(a, b), -1.0f, 1.0f));
}

/// Runs of vertices in one place and with one normal, which texture coordinates alone tell apart.
template <class Visit>
void forEachSeam(const MeshData& mesh, const Visit& visit) {
    const auto placeOf = [&](uint32_t vertex) {
        const Vec3 &p = mesh.positions[vertex], &n = mesh.normals[vertex];
        return std::tuple(p.x, p.y, p.z, n.x, n.y, n.z);
    };
    std::vector<uint32_t> order(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, placeOf);
    for (auto begin = order.begin(); begin != order.end();) {
        const auto end = std::find_if(begin, order.end(),
                                      [&](uint32_t vertex) { return placeOf(vertex) != placeOf(*begin); });
        if (end - begin > 1) { visit(std::vector<uint32_t>(begin, end)); }
        begin = end;
    }
}

/// Goes on over seams where both sides have about one direction.
void joinSeams(const MeshData& mesh, std::vector<Vec3>* sums) {
    constexpr float kLeastCosine = 0.7f;
    forEachSeam(mesh, [&](const std::vector<uint32_t>& seam) {
        std::vector<Vec3> own;
        own.reserve(seam.size());
        for (const uint32_t vertex : seam) {
            own.push_back((*sums)[vertex]);
        }
        for (size_t i = 0; i < seam.size(); ++i) {
            for (size_t j = 0; j < seam.size(); ++j) {
                const float cosine =
                    glm::dot(normalizeOr(own[i], Vec3(0.0f)), normalizeOr(own[j], Vec3(0.0f)));
                if (i == j || !(std::fabs(cosine) > kLeastCosine)) { continue; }
                (*sums)[seam[i]] += cosine < 0.0f ? -own[j] : own[j];
            }
        }
    });
}

std::vector<bool> meshesWithDirection(const SceneDescription& scene) {
    std::vector<bool> wanted(scene.meshes.size(), false);
    for (const Object& object : scene.objects) {
        if (object.shape != ShapeKind::Mesh ||
            !isAnisotropic(scene.materials[static_cast<size_t>(object.material)])) {
            continue;
        }
        const auto mesh = static_cast<size_t>(object.mesh);
        const auto& data = scene.meshes[mesh].data;
        wanted[mesh] = data && !data->normals.empty() && !data->uvs.empty() && data->tangents.empty();
    }
    return wanted;
}

}  // namespace

std::vector<Vec3> smoothTangents(const MeshData& mesh) {
    std::vector<Vec3> sums(mesh.positions.size(), Vec3(0.0f));
    for (size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        const uint32_t* corner = &mesh.indices[first];
        const Vec3 u = directionOfU(mesh, corner);
        if (isZero(u)) { continue; }
        for (int i = 0; i < 3; ++i) {
            const Vec3 n = normalizeOr(mesh.normals[corner[i]], Vec3(0.0f));
            const Vec3 along = normalizeOr(u - glm::dot(u, n) * n, Vec3(0.0f));
            const float weight = angleAt(mesh, corner, i);
            Vec3& sum = sums[corner[i]];
            sum += glm::dot(sum, along) < 0.0f ? -weight * along : weight * along;
        }
    }
    joinSeams(mesh, &sums);
    for (Vec3& sum : sums) {
        sum = normalizeOr(sum, Vec3(0.0f));
    }
    return sums;
}

std::vector<std::shared_ptr<const MeshTangents>> buildTangents(
    const SceneDescription& scene, const std::vector<std::shared_ptr<const MeshTangents>>& previous) {
    std::unordered_map<const MeshData*, std::shared_ptr<const MeshTangents>> known;
    for (const auto& tangents : previous) {
        if (tangents) { known[tangents->mesh.get()] = tangents; }
    }
    const std::vector<bool> wanted = meshesWithDirection(scene);
    std::vector<std::shared_ptr<const MeshTangents>> all(scene.meshes.size());
    for (size_t i = 0; i < all.size(); ++i) {
        const auto& data = scene.meshes[i].data;
        const auto found = known.find(data.get());
        if (found != known.end()) {
            all[i] = found->second;
        } else if (wanted[i]) {
            all[i] = std::make_shared<const MeshTangents>(MeshTangents{data, smoothTangents(*data)});
            known[data.get()] = all[i];
        }
    }
    return all;
}

}  // namespace glint
