// The meshes of pbrt's shapes. Internal to the pbrt importer.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "engine/io/pbrt_params.h"

namespace glint {

/// Meshes are places in the scene's list; -1: there is none.
class PbrtMeshes {
  public:
    explicit PbrtMeshes(PbrtContext* context) : context_(*context) {}

    /// `needsUvs`: a texture lies on it, so that it gets pbrt's usual coordinates where it has none.
    int triangles(const PbrtParams& params, bool needsUvs, bool isReversed);
    int patches(const PbrtParams& params, bool isReversed);
    /// Where the unit rectangle is what a single patch of right or other parallel sides is, with its own u
    /// and v; nothing: it is none.
    static std::optional<Affine> rectangle(const PbrtParams& params);
    int subdivided(const PbrtParams& params, bool isReversed);
    /// A PLY file, packed or not, which stays empty until readFiles(). One that is missing is refused.
    int file(const PbrtParams& params, bool needsUvs, bool isReversed);
    /// Reads what waits, several at once; the first error is that of the first file.
    void readFiles();
    /// A mesh that was made here.
    int add(std::string name, std::shared_ptr<MeshData> data, bool isReversed);

  private:
    struct Arrays {
        std::vector<Vec3> positions, normals;
        std::vector<Vec2> uvs;
    };
    /// P, N and uv, the latter two as long as P or empty.
    Arrays arraysOf(const PbrtParams& params);
    /// The corners; fails where one is no vertex. `usual` is what stands for none, where there are as
    /// many vertices.
    std::vector<uint32_t> cornersOf(const PbrtParams& params, size_t group, size_t vertices, size_t usual);

    struct File {
        std::string path;
        bool needsUvs, isReversed;
        int mesh;
    };
    /// What a file holds.
    struct Content {
        std::shared_ptr<MeshData> mesh = {};
        std::vector<std::string> warnings = {};
        uint64_t bytes = 0;
        bool staysFile = false;  ///< Glint reads it as the same
        std::optional<Error> error = {};
    };
    static Content contentOf(const File& file);

    PbrtContext& context_;
    std::map<std::tuple<std::string, bool, bool>, int> files_;
    std::vector<File> waiting_;
};

}  // namespace glint
