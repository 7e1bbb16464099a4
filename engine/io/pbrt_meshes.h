// The meshes of pbrt's shapes. Internal to the pbrt importer.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "engine/io/pbrt_params.h"

namespace glint {

/// A mesh of the scene; index -1: there is none.
struct PbrtMesh {
    int index = -1;
    std::shared_ptr<const MeshData> data = {};
};

class PbrtMeshes {
  public:
    explicit PbrtMeshes(PbrtContext* context) : context_(*context) {}

    /// `needsUvs`: a texture lies on it, so that it gets pbrt's usual coordinates where it has none.
    PbrtMesh triangles(const PbrtParams& params, bool needsUvs, bool isReversed);
    PbrtMesh patches(const PbrtParams& params, bool isReversed);
    /// Where the unit rectangle is what a single patch of right or other parallel sides is, with its own u
    /// and v; nothing: it is none.
    static std::optional<Affine> rectangle(const PbrtParams& params);
    PbrtMesh subdivided(const PbrtParams& params, bool isReversed);
    /// A PLY file, packed or not. One that is missing is refused.
    PbrtMesh file(const PbrtParams& params, bool needsUvs, bool isReversed);
    /// A mesh that was made here.
    PbrtMesh add(std::string name, std::shared_ptr<MeshData> data, bool isReversed);

  private:
    struct Arrays {
        std::vector<Vec3> positions, normals;
        std::vector<Vec2> uvs;
    };
    /// P, N and uv, the latter two as long as P or empty.
    Arrays arraysOf(const PbrtParams& params);
    /// The corners; fails where one is no vertex. `usual` is what stands for none, where there are as many
    /// vertices.
    std::vector<uint32_t> cornersOf(const PbrtParams& params, size_t group, size_t vertices, size_t usual);

    using Key = std::tuple<std::string, bool, bool>;
    PbrtContext& context_;
    std::map<Key, PbrtMesh> files_;
};

}  // namespace glint
