// Collects the faces of one part of a mesh file into a mesh: vertices with equal numbers of position and
// normal, and equal texture coordinates, become one.
//
// The readers of OBJ and PLY check every number before it comes here.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/scene/mesh_data.h"

namespace glint {

/// What `v`, `vt` and `vn` lines have given so far, or vertices and faces of a PLY file.
struct ObjPools {
    std::vector<Vec3> positions;
    std::vector<Vec3> colors;  ///< empty, or one per position
    std::vector<Vec2> uvs;
    std::vector<Vec3> normals;
};

/// A face's corner: numbers from 0 into the pools, -1 where there is none.
struct ObjCorner {
    int32_t position = -1;
    int32_t uv = -1;
    int32_t normal = -1;
};

class ObjPartBuilder {
  public:
    explicit ObjPartBuilder(const ObjPools& pools) : pools_(pools) {}

    /// False, and nothing added, when the polygon has too many corners for ear clipping (polygon.h).
    bool addFace(const std::vector<ObjCorner>& corners);
    void addTriangle(const ObjCorner* corners);
    bool empty() const { return mesh_.indices.empty(); }
    uint32_t triangleCount() const { return mesh_.triangleCount(); }
    /// How many vertices were compared with corners: for tests of linear time.
    uint64_t comparisons() const { return comparisons_; }
    /// The mesh so far; begins a new, empty one.
    std::shared_ptr<MeshData> finish();

  private:
    static constexpr uint32_t kNone = UINT32_MAX;
    /// At a position with more vertices than this, the older ones are not looked at: time stays linear where
    /// a file gives one position thousands of texture coordinates, and costs it a few vertices twice.
    static constexpr int kMostCompared = 32;

    /// A vertex of the mesh, in a list of those that share a position.
    struct Known {
        int32_t uv;
        int32_t normal;
        uint32_t next;
    };
    /// The list's head; it counts only if it was made for the present part.
    struct Head {
        uint32_t part = kNone;
        uint32_t first = kNone;
    };

    bool isSame(const Known& known, const ObjCorner& corner) const;
    uint32_t vertexFor(const ObjCorner& corner);
    uint32_t appendVertex(const ObjCorner& corner);

    const ObjPools& pools_;
    MeshData mesh_;
    uint32_t part_ = 0;
    uint64_t comparisons_ = 0;
    std::vector<Head> heads_;
    std::vector<Known> known_;
    std::vector<Vec3> polygon_;        ///< scratch
    std::vector<uint32_t> triangles_;  ///< scratch
};

}  // namespace glint
