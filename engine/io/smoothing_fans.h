// Which corners of triangles share a normal: sets of corners around one position, joined across smooth edges.
// For mesh_normals.cpp only.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/io/mesh_file.h"

namespace glint {

/// A triangle that has an area and no normals.
struct SmoothFace {
    uint32_t part;
    uint32_t triangle;
    uint32_t positions[3];
    Vec3 normal;  ///< unit
    Smoothing group;
};

/// Corners are numbered 3 * face + 0 to 2. Fans are sets of corners at one position.
class SmoothingFans {
  public:
    /// Positions of faces are below `positionCount`. `faces` must outlive the fans.
    SmoothingFans(const std::vector<SmoothFace>& faces, uint32_t positionCount);

    /// The corner that stands for a corner's fan.
    uint32_t rootOf(uint32_t corner);

  private:
    /// From the position with the smaller number, in whose list it stands, to `other`.
    struct Edge {
        uint32_t other;
        uint32_t corner;  ///< where its face's edge begins
    };

    uint32_t positionOf(uint32_t corner) const { return faces_[corner / 3].positions[corner % 3]; }
    void joinAcrossEdges(uint32_t positionCount);
    void joinAcross(uint32_t a, uint32_t b);

    const std::vector<SmoothFace>& faces_;
    std::vector<uint32_t> parent_;
};

}  // namespace glint
