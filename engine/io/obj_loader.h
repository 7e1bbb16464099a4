// Wavefront OBJ with MTL materials.
//
// Geometry is read by our own tokenizer: tinyobjloader silently reads a malformed number as 0 and knows
// no columns. Materials come from tinyobjloader, with texture options, after a check of their numbers
// (mtl_loader.h, which also holds the mapping to Glint's materials); they are left alone where the
// scene brings its own. No image is opened here. Left out, with a warning: points, lines, free-form
// curves and surfaces.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene.h"

namespace glint {

/// Faces that follow each other and have one material.
struct ObjPart {
    /// group or object name in force at the first face, else its material's, else "part N"
    std::string name;
    std::string materialName;             ///< as usemtl says; empty: none in force
    std::string materialPlace;            ///< `file:line` of that usemtl
    int material = -1;                    ///< index into ObjScene::materials; -1: not resolved
    std::shared_ptr<MeshData> mesh = {};  ///< never null; the reader's own until the scene is handed out
};

struct ObjScene {
    std::vector<ObjPart> parts;          ///< in file order; never empty, each with at least one triangle
    std::vector<std::string> libraries;  ///< what mtllib lines name, whole lines
    std::vector<Material> materials;     ///< those that parts use, in order of first use
    std::vector<Texture> textures;  ///< what these materials use, not read; paths include the MTL's folder
    /// `file:line: …`: missing MTL files, materials and images, statements left out
    std::vector<std::string> warnings;
};

/// Reads the OBJ file alone; parts have no materials yet. Polygons are triangulated (polygon.h); vertices
/// with the same position, uv and normal become one; normals and uvs are kept only where the file has them; a
/// sixth number after `v` makes vertex colours. Error: it cannot be read or is malformed, with line and
/// column; no faces.
Result<ObjScene> loadObjGeometry(const std::string& path);

/// Reads its MTL files and gives parts their materials. Error: an existing MTL file cannot be read or is
/// malformed, with line and column.
Status readObjMaterials(const std::string& path, ObjScene* scene);

/// Both.
Result<ObjScene> loadObj(const std::string& path);

/// All parts as one mesh, in file order. Where only some parts have normals or uvs, the others get zeros.
std::shared_ptr<MeshData> joinParts(const std::vector<ObjPart>& parts);

}  // namespace glint
