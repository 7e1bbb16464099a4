// What nodes do to the vertices of their meshes: morph targets and skins.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/gltf_meshes.h"

namespace glint {
namespace {

void follow(const Affine& joint, size_t vertex, MeshData* mesh) {
    mesh->positions[vertex] = joint.point(mesh->positions[vertex]);
    if (!mesh->tangents.empty()) {
        Vec4& tangent = mesh->tangents[vertex];
        tangent = Vec4(joint.vector(Vec3(tangent)), tangent.w);
    }
    if (mesh->normals.empty()) { return; }
    const Mat3& m = joint.linear;  // normals go by its cofactors
    mesh->normals[vertex] =
        Mat3(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])) * mesh->normals[vertex];
}

/// Adds `weight` times the moves; those that leave what is finite are left out but where `anyhow`.
template <class Vector>
void displace(const GltfNumbers& moves, float weight, bool anyhow, std::vector<Vector>* out) {
    for (size_t i = 0; i < std::min(moves.count(), out->size()); ++i) {
        const float* by = moves.at(i);
        Vector& to = (*out)[i];
        const Vec3 moved = Vec3(to) + weight * Vec3(by[0], by[1], by[2]);
        for (int c = 0; c < 3 && (anyhow || isFinite(moved)); ++c) {
            to[c] = moved[c];
        }
    }
}

}  // namespace

Status GltfMeshes::morph(const tinygltf::Primitive& from, const std::vector<double>& weights,
                         const std::string& what, MeshData* mesh) {
    for (size_t target = 0; target < std::min(weights.size(), from.targets.size()); ++target) {
        const auto weight = static_cast<float>(weights[target]);
        if (weight == 0.0f || !std::isfinite(weight)) { continue; }
        for (const char* attribute : {"POSITION", "NORMAL", "TANGENT"}) {
            const auto found = from.targets[target].find(attribute);
            if (found == from.targets[target].end()) { continue; }
            const std::string_view name = attribute;
            if (name == "TANGENT" && mesh->tangents.empty()) { continue; }
            const auto moves = readNumbers(file_, found->second, 3, 3, what + ", morph target");
            if (!moves) { return moves.error(); }
            if (name == "POSITION") { displace(*moves, weight, true, &mesh->positions); }
            if (name == "NORMAL") { displace(*moves, weight, false, &mesh->normals); }
            if (name == "TANGENT") { displace(*moves, weight, false, &mesh->tangents); }
        }
    }
    return {};
}

/// Section 3.7.3.1: each vertex follows the mean of its joints, four of each set.
Status GltfMeshes::bend(const tinygltf::Primitive& from, std::span<const Affine> joints,
                        const std::string& what, MeshData* mesh) {
    struct Set {
        GltfNumbers joints, weights;
    };
    std::vector<Set> sets;
    size_t count = mesh->positions.size();
    constexpr int kMostSets = 8;
    for (int k = 0; k < kMostSets && !joints.empty(); ++k) {
        const int jointsOf = accessorOf(from, fmt::format("JOINTS_{}", k));
        const int weightsOf = accessorOf(from, fmt::format("WEIGHTS_{}", k));
        if (jointsOf < 0 || weightsOf < 0) { break; }
        auto numbers = readNumbers(file_, jointsOf, 4, 4, what + ", joints");
        if (!numbers) { return numbers.error(); }
        auto weights = readNumbers(file_, weightsOf, 4, 4, what + ", weights");
        if (!weights) { return weights.error(); }
        count = std::min({count, numbers->count(), weights->count()});
        sets.push_back({std::move(*numbers), std::move(*weights)});
    }
    if (sets.empty()) { return {}; }
    for (size_t i = 0; i < count; ++i) {
        Affine mean{Mat3(0.0f), Vec3(0.0f)};
        float sum = 0.0f;
        for (size_t k = 0; k < 4 * sets.size(); ++k) {
            const Set& set = sets[k / 4];
            const float joint = set.joints.at(i)[k % 4], weight = set.weights.at(i)[k % 4];
            if (!(joint >= 0.0f && joint < static_cast<float>(joints.size()))) {
                return file_.error(
                    fmt::format("{}: a vertex follows joint {} of {}", what, joint, joints.size()));
            }
            if (!(weight > 0.0f)) { continue; }
            sum += weight;
            mean.linear += weight * joints[static_cast<size_t>(joint)].linear;
            mean.translation += weight * joints[static_cast<size_t>(joint)].translation;
        }
        if (sum > 0.0f) { follow({mean.linear / sum, mean.translation / sum}, i, mesh); }
    }
    return {};
}

}  // namespace glint
