// Wavefront OBJ with MTL materials.
//
// Geometry is read by our own tokenizer: tinyobjloader silently reads a malformed number as 0 and knows no
// columns. Materials come from tinyobjloader, with texture options, after a check of their numbers
// (mtl_loader.h, which also holds the mapping to Glint's materials). Left out, with a warning: points, lines,
// free-form curves and surfaces.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene.h"

namespace glint {

/// Faces that follow each other and have one material.
struct ObjPart {
    std::string
        name;  ///< group or object name in force at the first face, else the material's, else "part N"
    int material = 0;  ///< index into ObjScene::materials
    std::shared_ptr<const MeshData> mesh;
};

struct ObjScene {
    std::vector<ObjPart> parts;       ///< in file order; never empty, each with at least one triangle
    std::vector<Material> materials;  ///< those that parts use, in order of first use; never empty
    std::vector<Texture> textures;    ///< what these materials use; paths include the MTL file's folder
    std::vector<std::string>
        warnings;  ///< `file:line: …`: missing MTL files, materials and images, statements left out
};

/// Reads all of the file. Polygons are triangulated (polygon.h); vertices with the same position, uv and
/// normal become one; normals and uvs are kept only where the file has them; a sixth number after `v` makes
/// vertex colours. Error: the file or an existing MTL file cannot be read or is malformed, with its line and
/// column; no faces.
Result<ObjScene> loadObj(const std::string& path);

/// All parts as one mesh, in file order. Where only some parts have normals or uvs, the others get zeros.
std::shared_ptr<const MeshData> joinParts(const std::vector<ObjPart>& parts);

}  // namespace glint
