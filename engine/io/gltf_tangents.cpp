// The tangents of a glTF file's meshes (section 3.7.2.1).
#include <algorithm>
#include <cmath>

#include "engine/io/gltf_meshes.h"

namespace glint {

void GltfMeshes::readTangents(const tinygltf::Primitive& from, const std::string& what, MeshData* mesh) {
    const int accessor = accessorOf(from, "TANGENT");
    if (accessor < 0) { return; }
    if (mesh->normals.empty()) {
        file_.remark("tangents without normals are left out", what);
        return;
    }
    const auto tangents = readNumbers(file_, accessor, 4, 4, what + ", tangents");
    if (!tangents || tangents->count() != mesh->positions.size()) {
        file_.remark("tangents that cannot be read, or are not as many as positions, are left out", what);
        return;
    }
    bool isDamaged = false;
    for (size_t i = 0; i < tangents->count(); ++i) {
        const float* t = tangents->at(i);
        const Vec3 along(t[0], t[1], t[2]);
        if (!isFinite(along) || isZero(along) || !(std::fabs(t[3]) > 0.0f) || std::isinf(t[3])) {
            isDamaged = true;
            mesh->tangents.emplace_back(0.0f);
            continue;
        }
        // Texture coordinates count v downwards here, and the bitangent points upwards.
        mesh->tangents.emplace_back(along, t[3] < 0.0f ? 1.0f : -1.0f);
    }
    if (isDamaged) {
        file_.remark("tangents without a direction or a side run as the texture coordinates do", what);
    }
    if (std::ranges::all_of(mesh->tangents, [](const Vec4& t) { return t.w == 0.0f; })) {
        mesh->tangents.clear();
    }
}

}  // namespace glint
