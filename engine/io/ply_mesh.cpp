#include "engine/io/ply_mesh.h"

#include <utility>

#include "engine/io/polygon.h"

namespace glint {

bool PlyMesh::triangulate(const std::vector<uint32_t>& corners) {
    fan_.assign({0, 1, 2});
    if (corners.size() == 3) { return true; }
    polygon_.clear();
    for (const uint32_t corner : corners) {
        polygon_.push_back(vertices.positions[corner]);
    }
    fan_.clear();
    return triangulatePolygon(polygon_, &fan_);
}

std::string_view PlyMesh::addFace(const PlyFace& face) {
    constexpr size_t kBad = SIZE_MAX;
    const size_t count = face.corners.size();
    if (!triangulate(face.corners)) {
        return "faces of thousands of corners that are not convex are left out";
    }
    const bool hasUvs = face.uvs.size() == 2 * count;
    const size_t given = face.colors.size();
    const size_t step = given == 3 * count || given == 4 * count ? given / count
                        : given == 3 || given == 4               ? 0  // one for the face
                                                                 : kBad;
    if (!hasUvs && step == kBad && face.texture == 0 && byTexture_.empty()) {
        for (const uint32_t corner : fan_) {
            triangles_.push_back(face.corners[corner]);
        }
    } else {
        addToPart(face, hasUvs, step);
    }
    if (!hasUvs && !face.uvs.empty()) {
        return "a face has other texture coordinates than corners; they are left out";
    }
    return step == kBad && given > 0 ? "a face has other colours than corners; they are left out" : "";
}

ObjCorner PlyMesh::cornerOf(uint32_t vertex, int32_t uv) const {
    const auto number = static_cast<int32_t>(vertex);
    return {number, uv >= 0 || vertexUvs_ == 0 ? uv : number, vertices.normals.empty() ? -1 : number};
}

void PlyMesh::addToPart(const PlyFace& face, bool hasUvs, size_t colorStep) {
    if (byTexture_.empty()) {  // what came before
        vertexUvs_ = vertices.uvs.size();
        byTexture_.resize(1);
        for (const uint32_t vertex : std::exchange(triangles_, {})) {
            byTexture_[0].corners.push_back(cornerOf(vertex, -1));
        }
    }
    if (face.texture >= byTexture_.size()) { byTexture_.resize(face.texture + 1); }
    Part& part = byTexture_[face.texture];
    const auto firstUv = static_cast<int32_t>(vertices.uvs.size());
    for (size_t i = 0; i < (hasUvs ? face.corners.size() : 0); ++i) {
        vertices.uvs.emplace_back(face.uvs[2 * i], face.uvs[2 * i + 1]);
    }
    for (const uint32_t corner : fan_) {
        if (colorStep <= 4) {
            const float* rgb = &face.colors[colorStep * corner];
            part.colors.resize(part.corners.size(), Vec3(1.0f));
            part.colors.emplace_back(rgb[0], rgb[1], rgb[2]);
        }
        part.corners.push_back(
            cornerOf(face.corners[corner], hasUvs ? firstUv + static_cast<int32_t>(corner) : -1));
    }
}

void PlyMesh::addStrip(const std::vector<uint32_t>& corners) {
    for (size_t i = 2; i < corners.size(); ++i) {
        const uint32_t a = corners[i - 2], b = corners[i - 1], c = corners[i];
        if (a == b || b == c || a == c) { continue; }  // joins two strips
        const bool isTurned = i % 2 == 1;
        triangles_.insert(triangles_.end(), {isTurned ? b : a, isTurned ? a : b, c});
    }
}

/// No vertex is shared: faces beside each other have other colours as a rule.
std::shared_ptr<MeshData> PlyMesh::withCornerColors(const Part& part) const {
    auto mesh = std::make_shared<MeshData>();
    mesh->colors = part.colors;
    mesh->colors.resize(part.corners.size(), Vec3(1.0f));
    for (const ObjCorner& corner : part.corners) {
        mesh->indices.push_back(static_cast<uint32_t>(mesh->positions.size()));
        mesh->positions.push_back(vertices.positions[static_cast<size_t>(corner.position)]);
        if (corner.normal >= 0) {
            mesh->normals.push_back(vertices.normals[static_cast<size_t>(corner.normal)]);
        }
        if (corner.uv >= 0 || !mesh->uvs.empty()) {
            mesh->uvs.resize(mesh->indices.size(), Vec2(0.0f));
            mesh->uvs.back() = corner.uv >= 0 ? vertices.uvs[static_cast<size_t>(corner.uv)] : Vec2(0.0f);
        }
    }
    return mesh;
}

MeshFile PlyMesh::finish(const std::vector<std::string>& textures) {
    MeshFile file;
    const auto addPart = [&](std::shared_ptr<MeshData> mesh, size_t texture) {
        MeshPart& part = file.parts.emplace_back();
        part.mesh = std::move(mesh);
        if (texture < textures.size() && !part.mesh->uvs.empty()) { part.materialName = textures[texture]; }
    };
    if (byTexture_.empty()) {
        auto mesh = std::make_shared<MeshData>();
        for (Vec3& position : vertices.positions) {
            if (isNan(position)) { position = vertices.positions[triangles_[0]]; }
        }
        mesh->positions = std::move(vertices.positions);
        mesh->normals = std::move(vertices.normals);
        mesh->uvs = std::move(vertices.uvs);
        mesh->colors = std::move(vertices.colors);
        mesh->indices = std::move(triangles_);
        addPart(std::move(mesh), 0);
        return file;
    }
    ObjPartBuilder builder(vertices);
    for (size_t texture = 0; texture < byTexture_.size(); ++texture) {
        const Part& part = byTexture_[texture];
        if (part.corners.empty()) { continue; }
        if (!part.colors.empty()) {
            addPart(withCornerColors(part), texture);
            continue;
        }
        for (size_t i = 0; i < part.corners.size(); i += 3) {
            builder.addTriangle(&part.corners[i]);
        }
        addPart(builder.finish(), texture);
    }
    return file;
}

}  // namespace glint
