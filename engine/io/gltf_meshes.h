// The triangles of a glTF file's meshes.
#pragma once

#include <map>
#include <vector>

#include "engine/io/gltf_materials.h"

namespace glint {

/// A primitive that has triangles.
struct GltfPart {
    int mesh = 0;  ///< in the scene
    int material = 0;
};

class GltfMeshes {
  public:
    /// All must outlive it.
    GltfMeshes(GltfFile* file, GltfMaterials* materials, SceneDescription* scene)
        : file_(*file), materials_(*materials), scene_(*scene) {}

    /// A mesh's parts, read when they are asked for the first time. Error: as the accessors'; an index beyond
    /// the vertices, a position that is not finite or above 1e18.
    Result<std::vector<GltfPart>> take(int mesh);

  private:
    Result<std::shared_ptr<MeshData>> read(const tinygltf::Primitive& from, const GltfMaterial& material,
                                           const std::string& what);
    Status readTriangles(const tinygltf::Primitive& from, const std::string& what, MeshData* mesh);
    Status readAttributes(const tinygltf::Primitive& from, const GltfMaterial& material,
                          const std::string& what, MeshData* mesh);
    void remarkLeftOut(const tinygltf::Mesh& mesh, const tinygltf::Primitive& primitive);

    GltfFile& file_;
    GltfMaterials& materials_;
    SceneDescription& scene_;
    std::map<int, std::vector<GltfPart>> taken_;
};

}  // namespace glint
