// Triangle meshes as loaded or generated. Immutable once shared; an edit replaces the whole mesh.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/math/vec.h"
#include "engine/scene/asset_source.h"

namespace glint {

/// The largest coordinate, so that squares of lengths are floats; and in double, as files are read.
constexpr float kMaxCoordinate = 1e18f;
constexpr double kMaxCoordinateD = 1e18;

/// Indexed triangles. Optional arrays are either empty or have one entry per vertex. Every index is below
/// positions.size(); every position is finite: loaders see to both.
struct MeshData {
    std::vector<Vec3> positions;
    /// shading normals, not necessarily of unit length; zero: use the face normal
    std::vector<Vec3> normals;
    std::vector<Vec2> uvs;     ///< v runs upwards: (0, 0) is the image's bottom left corner
    std::vector<Vec3> colors;  ///< linear vertex colours that multiply the material's colour
    /// x, y, z: where normal maps and anisotropy have u run, not necessarily of unit length; v runs along
    /// cross(normal, tangent) times the sign of w. Zero: as the uvs run. How a texture is placed turns
    /// them not
    std::vector<Vec4> tangents;
    std::vector<uint32_t> indices;  ///< three per triangle, counter-clockwise seen from the front
    /// The source has uvs, which are left out because no texture needs them (engine/io/used_assets.h).
    bool uvsLeftOut = false;

    uint32_t triangleCount() const { return static_cast<uint32_t>(indices.size() / 3); }
};

inline bool sameTriangles(const MeshData& a, const MeshData& b) {
    return a.positions == b.positions && a.indices == b.indices;
}

/// A procedural mesh (generated_mesh.h).
struct MeshGenerator {
    std::string name;
    uint32_t triangles = 0;  ///< about how many
    uint32_t seed = 0;

    auto operator<=>(const MeshGenerator&) const = default;
};

using MeshSource = AssetSource<MeshGenerator>;

struct Mesh {
    std::string name;
    MeshSource source;
    std::shared_ptr<const MeshData> data;  ///< null while it has not been read because no object places it
};

}  // namespace glint
