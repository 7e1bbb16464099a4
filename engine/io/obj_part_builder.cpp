// Lists per position instead of a hash table: most positions have one vertex, and finding it is one look.
#include "engine/io/obj_part_builder.h"

#include "engine/io/polygon.h"

namespace glint {

bool ObjPartBuilder::addFace(const std::vector<ObjCorner>& corners) {
    if (corners.size() == 3) {
        addTriangle(corners.data());
        return true;
    }
    polygon_.clear();
    for (const ObjCorner& corner : corners) {
        polygon_.push_back(pools_.positions[static_cast<size_t>(corner.position)]);
    }
    triangles_.clear();
    if (!triangulatePolygon(polygon_, &triangles_)) { return false; }
    for (const uint32_t corner : triangles_) {
        mesh_.indices.push_back(vertexFor(corners[corner]));
    }
    return true;
}

void ObjPartBuilder::addTriangle(const ObjCorner* corners) {
    for (int corner = 0; corner < 3; ++corner) {
        mesh_.indices.push_back(vertexFor(corners[corner]));
    }
}

bool ObjPartBuilder::isSame(const Known& known, const ObjCorner& corner) const {
    if (known.normal != corner.normal) { return false; }
    return known.uv == corner.uv ||
           (known.uv >= 0 && corner.uv >= 0 &&
            pools_.uvs[static_cast<size_t>(known.uv)] == pools_.uvs[static_cast<size_t>(corner.uv)]);
}

uint32_t ObjPartBuilder::vertexFor(const ObjCorner& corner) {
    const size_t position = static_cast<size_t>(corner.position);
    if (position >= heads_.size()) { heads_.resize(pools_.positions.size()); }
    Head& head = heads_[position];
    if (head.part != part_) { head = {part_, kNone}; }
    int compared = 0;
    for (uint32_t i = head.first; i != kNone && compared < kMostCompared; i = known_[i].next, ++compared) {
        ++comparisons_;
        if (isSame(known_[i], corner)) { return i; }
    }
    known_.push_back({corner.uv, corner.normal, head.first});
    head.first = appendVertex(corner);
    return head.first;
}

uint32_t ObjPartBuilder::appendVertex(const ObjCorner& corner) {
    const size_t index = mesh_.positions.size();
    const size_t position = static_cast<size_t>(corner.position);
    mesh_.positions.push_back(pools_.positions[position]);
    if (!pools_.colors.empty()) {
        mesh_.colors.resize(index, Vec3(1.0f));
        mesh_.colors.push_back(pools_.colors[position]);
    }
    if (corner.uv >= 0) {
        mesh_.uvs.resize(index, Vec2(0.0f));
        mesh_.uvs.push_back(pools_.uvs[static_cast<size_t>(corner.uv)]);
    }
    if (corner.normal >= 0) {
        mesh_.normals.resize(index, Vec3(0.0f));
        mesh_.normals.push_back(pools_.normals[static_cast<size_t>(corner.normal)]);
    }
    return static_cast<uint32_t>(index);
}

std::shared_ptr<MeshData> ObjPartBuilder::finish() {
    const size_t count = mesh_.positions.size();
    const auto fill = [count](auto& values, auto missing) {
        if (!values.empty()) { values.resize(count, missing); }
    };
    fill(mesh_.colors, Vec3(1.0f));
    fill(mesh_.uvs, Vec2(0.0f));
    fill(mesh_.normals, Vec3(0.0f));
    auto out = std::make_shared<MeshData>(std::move(mesh_));
    mesh_ = {};
    known_.clear();
    ++part_;
    return out;
}

}  // namespace glint
