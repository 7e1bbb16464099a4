// Collects the vertices and faces of a PLY file into a mesh file: polygons become triangles, texture
// coordinates of corners part vertices, and each image that faces name becomes a part. For ply_body.h only,
// which checks every number.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/io/mesh_file.h"
#include "engine/io/obj_part_builder.h"

namespace glint {

/// A face as the file has it, with at least three corners.
struct PlyFace {
    const std::vector<uint32_t>& corners;
    const std::vector<float>& uvs;     ///< two for each corner, or none
    const std::vector<float>& colors;  ///< three or four for each corner or for the face, or none
    size_t texture = 0;                ///< the number of an image that the header names, or 0
};

class PlyMesh {
  public:
    /// normals, uvs, colors: empty or one for each position; uvs grow with faces' own ones. Positions that
    /// are no number are such as no face has.
    ObjPools vertices;

    bool isPlaced(size_t vertex) const { return !isNan(vertices.positions[vertex]); }
    /// The sentence of a remark on what of it is left out, or nothing: all of it where it has too many
    /// corners for ear clipping (polygon.h).
    std::string_view addFace(const PlyFace& face);
    /// Two corners of each triangle are the last ones of that before it, and every other one is turned over.
    void addStrip(const std::vector<uint32_t>& corners);
    bool empty() const { return triangles_.empty() && byTexture_.empty(); }
    /// `textures` are what the header names. Not empty().
    MeshFile finish(const std::vector<std::string>& textures);

  private:
    /// The triangles of one image.
    struct Part {
        std::vector<ObjCorner> corners;  ///< three for each
        std::vector<Vec3> colors;        ///< empty, or one for each corner
    };

    static bool isNan(const Vec3& p) { return !(p.x == p.x && p.y == p.y && p.z == p.z); }
    bool triangulate(const std::vector<uint32_t>& corners);
    ObjCorner cornerOf(uint32_t vertex, int32_t uv) const;
    void addToPart(const PlyFace& face, bool hasUvs, size_t colorStep);
    std::shared_ptr<MeshData> withCornerColors(const Part& part) const;

    std::vector<uint32_t> triangles_;  ///< while no face has needed more
    std::vector<Part> byTexture_;      ///< empty until a face needs it
    size_t vertexUvs_ = 0;
    std::vector<Vec3> polygon_;  ///< scratch
    std::vector<uint32_t> fan_;  ///< scratch
};

}  // namespace glint
