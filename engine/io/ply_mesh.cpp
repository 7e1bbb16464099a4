#include "engine/io/ply_mesh.h"

#include <utility>

#include "engine/io/polygon.h"

namespace glint {

bool PlyMesh::addFace(const std::vector<uint32_t>& corners, const std::vector<Vec2>& uvs, size_t texture) {
    fan_.assign({0, 1, 2});
    if (corners.size() > 3) {
        polygon_.clear();
        for (const uint32_t corner : corners) {
            polygon_.push_back(vertices.positions[corner]);
        }
        fan_.clear();
        if (!triangulatePolygon(polygon_, &fan_)) { return false; }
    }
    const bool isPlain = uvs.empty() && texture == 0 && byTexture_.empty();
    const auto cornerOf = [&](uint32_t vertex, int32_t uv) {
        const auto number = static_cast<int32_t>(vertex);
        return ObjCorner{number, uv, vertices.normals.empty() ? -1 : number};
    };
    if (!isPlain && byTexture_.empty()) {  // what came before
        vertexUvs_ = vertices.uvs.size();
        byTexture_.resize(1);
        for (const uint32_t vertex : std::exchange(triangles_, {})) {
            byTexture_[0].push_back(cornerOf(vertex, vertexUvs_ > 0 ? static_cast<int32_t>(vertex) : -1));
        }
    }
    if (texture >= byTexture_.size() && !isPlain) { byTexture_.resize(texture + 1); }
    const auto firstUv = static_cast<int32_t>(vertices.uvs.size());
    vertices.uvs.insert(vertices.uvs.end(), uvs.begin(), uvs.end());
    for (const uint32_t corner : fan_) {
        const uint32_t vertex = corners[corner];
        if (isPlain) {
            triangles_.push_back(vertex);
        } else {
            const int32_t own = vertexUvs_ > 0 ? static_cast<int32_t>(vertex) : -1;
            byTexture_[texture].push_back(
                cornerOf(vertex, uvs.empty() ? own : firstUv + static_cast<int32_t>(corner)));
        }
    }
    return true;
}

void PlyMesh::addStrip(const std::vector<uint32_t>& corners) {
    for (size_t i = 2; i < corners.size(); ++i) {
        const uint32_t a = corners[i - 2], b = corners[i - 1], c = corners[i];
        if (a == b || b == c || a == c) { continue; }  // joins two strips
        const bool isTurned = i % 2 == 1;
        triangles_.insert(triangles_.end(), {isTurned ? b : a, isTurned ? a : b, c});
    }
}

MeshPart PlyMesh::partOf(std::shared_ptr<MeshData> mesh, const std::vector<std::string>& textures,
                         size_t texture) const {
    MeshPart part{.name = {}, .materialName = {}, .mesh = std::move(mesh)};
    if (texture < textures.size() && !part.mesh->uvs.empty()) {
        part.materialName = textures[texture];
        part.mesh->colors.clear();  // a coarser copy of the image, in all programs that write both
    }
    return part;
}

MeshFile PlyMesh::finish(const std::vector<std::string>& textures) {
    MeshFile file;
    if (byTexture_.empty()) {
        auto mesh = std::make_shared<MeshData>();
        mesh->positions = std::move(vertices.positions);
        mesh->normals = std::move(vertices.normals);
        mesh->uvs = std::move(vertices.uvs);
        mesh->colors = std::move(vertices.colors);
        mesh->indices = std::move(triangles_);
        file.parts.push_back(partOf(std::move(mesh), textures, 0));
        return file;
    }
    ObjPartBuilder builder(vertices);
    for (size_t texture = 0; texture < byTexture_.size(); ++texture) {
        const std::vector<ObjCorner>& corners = byTexture_[texture];
        for (size_t i = 0; i < corners.size(); i += 3) {
            builder.addTriangle(&corners[i]);
        }
        if (!builder.empty()) { file.parts.push_back(partOf(builder.finish(), textures, texture)); }
    }
    return file;
}

}  // namespace glint
