// The triangles of a glTF file's meshes.
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "engine/io/gltf_accessor.h"
#include "engine/io/gltf_materials.h"

namespace glint {

/// A primitive that has triangles.
struct GltfPart {
    int mesh = 0;  ///< in the scene
    int material = 0;
};

/// How a node bends the mesh that it places.
struct GltfPose {
    int skin = -1;                        ///< -1: it has none
    std::span<const Affine> joints = {};  ///< of its skin, from the mesh's space to the world
    std::vector<double> weights = {};     ///< of morph targets; empty: the mesh's own
};

class GltfMeshes {
  public:
    /// All must outlive it.
    GltfMeshes(GltfFile* file, GltfMaterials* materials, SceneDescription* scene)
        : file_(*file), materials_(*materials), scene_(*scene), sameAccessors_(firstsOfTheSame(*file)) {}

    /// A mesh's parts, which nodes of the same skin share, but where they have weights of their own. Error:
    /// as the accessors'; an index beyond the vertices or the joints, a position that is not finite or above
    /// 1e18.
    Result<std::vector<GltfPart>> take(int mesh, const GltfPose& pose = {});

  private:
    Result<std::vector<GltfPart>> readParts(int mesh, const GltfPose& pose);
    Result<std::shared_ptr<MeshData>> read(const tinygltf::Primitive& from, const GltfMaterial& material,
                                           const GltfPose& pose, const std::string& what);
    Status morph(const tinygltf::Primitive& from, const std::vector<double>& weights, const std::string& what,
                 MeshData* mesh);
    Status bend(const tinygltf::Primitive& from, std::span<const Affine> joints, const std::string& what,
                MeshData* mesh);
    Status readTriangles(const tinygltf::Primitive& from, const std::string& what, MeshData* mesh);
    Status readAttributes(const tinygltf::Primitive& from, const GltfMaterial& material,
                          const std::string& what, MeshData* mesh);
    /// What cannot be read is left out with a remark: those that the texture coordinates have take its place.
    void readTangents(const tinygltf::Primitive& from, const std::string& what, MeshData* mesh);
    /// The scene's mesh of a primitive: the same one for primitives of the same numbers. Empty ones: -1.
    Result<int> meshOf(const tinygltf::Primitive& from, const GltfMaterial& material, const GltfPose& pose,
                       const std::string& what, const std::string& name);

    GltfFile& file_;
    GltfMaterials& materials_;
    SceneDescription& scene_;
    std::vector<int> sameAccessors_;
    std::map<std::pair<int, int>, std::vector<GltfPart>> taken_;  ///< by mesh and skin
    std::map<std::string, int> known_;                            ///< meshes by what they are read from
    uint64_t posedVertices_ = 0;                                  ///< of meshes that a node has for itself
};

}  // namespace glint
