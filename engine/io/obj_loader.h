// Wavefront OBJ with MTL materials.
//
// Geometry is read by our own tokenizer: tinyobjloader silently reads a malformed number as 0 and knows
// no columns. Materials come from tinyobjloader, with texture options, after a check of their numbers
// (mtl_loader.h, which also holds the mapping to Glint's materials); they are left alone where the
// scene brings its own. No image is opened here. Left out, with a warning: points, lines, free-form
// curves and surfaces.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/io/mesh_file.h"

namespace glint {

/// The OBJ file alone; its parts have no materials yet. A part's name is the group or object in force at its
/// first face, else its material's, else "part N". Polygons are triangulated (polygon.h); vertices with the
/// same position, uv and normal become one; normals and uvs are kept only where the file has them; a sixth
/// number after `v` makes vertex colours. `path` is used in messages. Error: it is malformed, with line and
/// column; no faces.
Result<MeshFile> parseObj(const std::string& text, const std::string& path);

/// Reads the MTL files of the OBJ file at `path` and gives parts their materials. Error: an existing MTL file
/// cannot be read or is malformed, with line and column.
Status readObjMaterials(const std::string& path, MeshFile* file);

/// Both, for a file on the disk.
Result<MeshFile> loadObj(const std::string& path);

}  // namespace glint
