#include "engine/io/gltf_meshes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/gltf_accessor.h"

namespace glint {
namespace {

constexpr uint64_t kMaxPosedVertices = uint64_t{1}
                                       << 26;  ///< a file may bend one mesh for each of many nodes

/// Corner numbers of triangles, strips and fans as those of triangles (section 3.7.2.1).
std::vector<uint32_t> asTriangles(const std::vector<uint32_t>& corners, int mode) {
    if (mode == TINYGLTF_MODE_TRIANGLES || mode == -1) {
        return {corners.begin(), corners.end() - static_cast<std::ptrdiff_t>(corners.size() % 3)};
    }
    std::vector<uint32_t> out;
    for (size_t i = 2; i < corners.size(); ++i) {
        const bool isFan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
        const size_t odd = isFan ? 0 : i % 2;
        out.push_back(isFan ? corners[0] : corners[i - 2 + odd]);
        out.push_back(isFan ? corners[i - 1] : corners[i - 1 - odd]);
        out.push_back(corners[i]);
    }
    return out;
}

/// What decides a mesh that has no pose of its own. `same`: of each accessor, the first one that says
/// the same.
std::string recipeOf(const tinygltf::Primitive& from, const GltfMaterial& material,
                     const std::vector<int>& same) {
    const auto firstOf = [&](int accessor) {
        const auto place = static_cast<size_t>(accessor);
        return place < same.size() ? same[place] : accessor;
    };
    const Vec3& factor = material.vertexFactor;
    const bool hasTangents = material.usesTangents && accessorOf(from, "TANGENT") >= 0;
    std::string recipe = fmt::format("{} {} {} {} {} {} {}", firstOf(from.indices), from.mode, material.uvSet,
                                     factor.x, factor.y, factor.z, hasTangents);
    for (const auto& [attribute, accessor] : from.attributes) {
        recipe += fmt::format(" {} {}", attribute, firstOf(accessor));
    }
    return recipe;
}

/// Primitives may share the vertices of a whole model: each keeps those of its own triangles.
void dropUnusedVertices(MeshData* mesh) {
    constexpr uint32_t kUnused = UINT32_MAX;
    std::vector<uint32_t> numbers(mesh->positions.size(), kUnused);
    uint32_t count = 0;
    for (const uint32_t corner : mesh->indices) {
        numbers[corner] = 0;
    }
    for (uint32_t& number : numbers) {
        if (number != kUnused) { number = count++; }
    }
    if (count == numbers.size()) { return; }
    const auto keep = [&](auto* values) {
        if (values->empty()) { return; }
        for (size_t i = 0; i < numbers.size(); ++i) {
            if (numbers[i] != kUnused) { (*values)[numbers[i]] = (*values)[i]; }
        }
        values->resize(count);
        values->shrink_to_fit();
    };
    keep(&mesh->positions);
    keep(&mesh->normals);
    keep(&mesh->uvs);
    keep(&mesh->colors);
    keep(&mesh->tangents);
    for (uint32_t& corner : mesh->indices) {
        corner = numbers[corner];
    }
}

template <class Vector>
void copyFinite(const GltfNumbers& numbers, int width, std::vector<Vector>* out) {
    for (size_t i = 0; i < numbers.count(); ++i) {
        Vector value(0.0f);
        for (int c = 0; c < width; ++c) {
            value[c] = std::isfinite(numbers.at(i)[c]) ? numbers.at(i)[c] : 0.0f;
        }
        out->push_back(value);
    }
}

bool hasAlpha(const GltfNumbers& colors) {
    bool has = false;
    for (size_t i = 0; colors.components == 4 && i < colors.count(); ++i) {
        has |= colors.at(i)[3] < 1.0f;
    }
    return has;
}

}  // namespace

Status GltfMeshes::readTriangles(const tinygltf::Primitive& from, const std::string& what, MeshData* mesh) {
    const auto positions = readNumbers(file_, accessorOf(from, "POSITION"), 3, 3, what + ", positions");
    if (!positions) { return positions.error(); }
    copyFinite(*positions, 3, &mesh->positions);
    if (!std::ranges::all_of(positions->values, [](float value) { return std::isfinite(value); })) {
        return file_.error(what + ": a position is not finite or above 1e18");
    }
    std::vector<uint32_t> corners;
    if (from.indices >= 0) {
        auto indices = readIndices(file_, from.indices, what + ", indices");
        if (!indices) { return indices.error(); }
        corners = std::move(*indices);
    } else {
        for (uint32_t i = 0; i < mesh->positions.size(); ++i) {
            corners.push_back(i);
        }
    }
    for (const uint32_t corner : corners) {
        if (corner >= mesh->positions.size()) {
            return file_.error(fmt::format("{}: an index is {}; there are {} vertices", what, corner,
                                           mesh->positions.size()));
        }
    }
    mesh->indices = asTriangles(corners, from.mode);
    return {};
}

Status GltfMeshes::readAttributes(const tinygltf::Primitive& from, const GltfMaterial& material,
                                  const std::string& what, MeshData* mesh) {
    const auto checkCount = [&](size_t count, const char* attribute) {
        return count == mesh->positions.size()
                   ? Status()
                   : Status(file_.error(fmt::format("{}: {} {} for {} positions", what, count, attribute,
                                                    mesh->positions.size())));
    };
    if (const int accessor = accessorOf(from, "NORMAL"); accessor >= 0) {
        const auto normals = readNumbers(file_, accessor, 3, 3, what + ", normals");
        if (!normals) { return normals.error(); }
        copyFinite(*normals, 3, &mesh->normals);
        if (Status count = checkCount(mesh->normals.size(), "normals"); !count) { return count; }
    }
    if (const int accessor = accessorOf(from, fmt::format("TEXCOORD_{}", material.uvSet)); accessor >= 0) {
        const auto uvs = readNumbers(file_, accessor, 2, 2, what + ", texture coordinates");
        if (!uvs) { return uvs.error(); }
        copyFinite(*uvs, 2, &mesh->uvs);
        if (Status count = checkCount(mesh->uvs.size(), "texture coordinates"); !count) { return count; }
    }
    if (const int accessor = accessorOf(from, "COLOR_0"); accessor >= 0) {
        const auto colors = readNumbers(file_, accessor, 3, 4, what + ", colours");
        if (!colors) { return colors.error(); }
        copyFinite(*colors, 3, &mesh->colors);
        if (hasAlpha(*colors)) { file_.remark("the alpha of vertices' colours is left out", what); }
        if (Status count = checkCount(mesh->colors.size(), "colours"); !count) { return count; }
    }
    if (material.vertexFactor != Vec3(1.0f)) {
        mesh->colors.resize(mesh->positions.size(), Vec3(1.0f));
        for (Vec3& color : mesh->colors) {
            color *= material.vertexFactor;
        }
    }
    for (Vec3& color : mesh->colors) {
        color = glm::clamp(color, Vec3(0.0f), Vec3(1.0f));
    }
    return {};
}

Result<std::shared_ptr<MeshData>> GltfMeshes::read(const tinygltf::Primitive& from,
                                                   const GltfMaterial& material, const GltfPose& pose,
                                                   const std::string& what) {
    auto mesh = std::make_shared<MeshData>();
    if (Status triangles = readTriangles(from, what, mesh.get()); !triangles) { return triangles.error(); }
    if (Status attributes = readAttributes(from, material, what, mesh.get()); !attributes) {
        return attributes.error();
    }
    if (material.usesTangents) { readTangents(from, what, mesh.get()); }
    // Each target is read anew for each mesh.
    const auto moves = std::ranges::count_if(pose.weights, [](double weight) { return weight != 0.0; });
    const auto targets = std::min(static_cast<size_t>(moves), from.targets.size());
    if (!pose.joints.empty() || targets > 0) { posedVertices_ += mesh->positions.size() * (1 + targets); }
    if (posedVertices_ > kMaxPosedVertices) {
        return file_.error(
            fmt::format("its skins and morph targets move more than {} vertices", kMaxPosedVertices));
    }
    if (Status morphed = morph(from, pose.weights, what, mesh.get()); !morphed) { return morphed.error(); }
    if (Status bent = bend(from, pose.joints, what, mesh.get()); !bent) { return bent.error(); }
    for (const Vec3& p : mesh->positions) {
        if (!(maxComponent(absVec(p)) <= kMaxCoordinate)) {
            return file_.error(what + ": a position is not finite or above 1e18");
        }
    }
    dropUnusedVertices(mesh.get());
    return mesh;
}

Result<int> GltfMeshes::meshOf(const tinygltf::Primitive& from, const GltfMaterial& material,
                               const GltfPose& pose, const std::string& what, const std::string& name) {
    const bool isPosed = !pose.joints.empty() || (!pose.weights.empty() && !from.targets.empty());
    const std::string recipe = isPosed ? "" : recipeOf(from, material, sameAccessors_);
    if (const auto known = known_.find(recipe); known != known_.end()) { return known->second; }
    auto mesh = read(from, material, pose, what);
    if (!mesh) { return mesh.error(); }
    int index = -1;
    if (!(*mesh)->indices.empty()) {
        index = static_cast<int>(scene_.meshes.size());
        scene_.meshes.push_back({name, {}, std::move(*mesh)});
    }
    if (!isPosed) { known_[recipe] = index; }
    return index;
}

Result<std::vector<GltfPart>> GltfMeshes::take(int index, const GltfPose& pose) {
    const auto& meshes = file_.model.meshes;
    if (index < 0 || static_cast<size_t>(index) >= meshes.size()) {
        return file_.error(fmt::format("there is no mesh {}; the file has {}", index, meshes.size()));
    }
    const std::vector<double>& weights = meshes[static_cast<size_t>(index)].weights;
    if (!pose.weights.empty()) { return readParts(index, pose); }
    const std::pair key(index, pose.skin);
    if (const auto known = taken_.find(key); known != taken_.end()) { return known->second; }
    auto parts = readParts(index, {pose.skin, pose.joints, weights});
    if (parts) { taken_[key] = *parts; }
    return parts;
}

Result<std::vector<GltfPart>> GltfMeshes::readParts(int index, const GltfPose& pose) {
    const tinygltf::Mesh& from = file_.model.meshes[static_cast<size_t>(index)];
    const std::string name = from.name.empty() ? fmt::format("mesh {}", index) : from.name;
    std::vector<GltfPart> parts;
    for (size_t i = 0; i < from.primitives.size(); ++i) {
        const tinygltf::Primitive& primitive = from.primitives[i];
        if (primitive.mode >= TINYGLTF_MODE_POINTS && primitive.mode <= TINYGLTF_MODE_LINE_STRIP) {
            file_.remark("points and lines are left out", name);
            continue;
        }
        if (accessorOf(primitive, "POSITION") < 0) {
            file_.remark("primitives without positions are left out", name);
            continue;
        }
        const auto material = materials_.take(primitive.material);
        if (!material) { return material.error(); }
        const std::string partName = from.primitives.size() > 1 ? fmt::format("{} {}", name, i) : name;
        const auto mesh =
            meshOf(primitive, *material, pose, fmt::format("mesh {}, primitive {}", index, i), partName);
        if (!mesh) { return mesh.error(); }
        if (*mesh >= 0) { parts.push_back({*mesh, material->index}); }
    }
    return parts;
}

}  // namespace glint
