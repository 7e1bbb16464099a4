// Collects the vertices and faces of a PLY file into a mesh file: polygons become triangles, texture
// coordinates of corners part vertices, and each image that faces name becomes a part. For ply_body.h only,
// which checks every number.
#pragma once

#include <string>
#include <vector>

#include "engine/io/mesh_file.h"
#include "engine/io/obj_part_builder.h"

namespace glint {

class PlyMesh {
  public:
    ObjPools
        vertices;  ///< normals, uvs, colors: empty or one for each position; uvs grow with faces' own ones

    /// At least three corners. `uvs` are the corners' own texture coordinates, or empty; `texture` is the
    /// number of an image that the header names, or 0. False: too many corners for ear clipping (polygon.h).
    bool addFace(const std::vector<uint32_t>& corners, const std::vector<Vec2>& uvs, size_t texture);
    /// Two corners of each triangle are the last ones of that before it, and every other one is turned over.
    void addStrip(const std::vector<uint32_t>& corners);
    bool empty() const { return triangles_.empty() && byTexture_.empty(); }
    /// `textures` are what the header names. Not empty().
    MeshFile finish(const std::vector<std::string>& textures);

  private:
    MeshPart partOf(std::shared_ptr<MeshData> mesh, const std::vector<std::string>& textures,
                    size_t texture) const;

    std::vector<uint32_t> triangles_;                ///< while no face has needed more
    std::vector<std::vector<ObjCorner>> byTexture_;  ///< three for each triangle; empty until a face needs it
    size_t vertexUvs_ = 0;
    std::vector<Vec3> polygon_;  ///< scratch
    std::vector<uint32_t> fan_;  ///< scratch
};

}  // namespace glint
