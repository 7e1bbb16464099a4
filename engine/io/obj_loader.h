// Wavefront OBJ with MTL materials.
//
// Geometry is read by our own tokenizer: tinyobjloader silently reads a malformed number as 0 and knows
// no columns. Materials come from tinyobjloader, after their lines were made regular (mtl_reader.h);
// mtl_loader.h holds the mapping to Glint's materials. They are left alone where the scene brings its own. No
// image is opened here. Left out, with a warning: points, lines, free-form curves and surfaces. What is
// repaired and what is refused stands in engine/io/README.md.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/io/mesh_file.h"

namespace glint {

/// The OBJ file alone; its parts have no materials yet. A part's name is the group or object in force at its
/// first face, else its material's, else "part N". More than kMostSeparateParts are joined, with a note.
/// Polygons are triangulated (polygon.h); vertices with the same position, uv and normal become one; normals
/// and uvs are kept only where the file has them; numbers behind x y z make vertex colours (vertex_colors.h).
/// `path` is used in messages. Error: the geometry is malformed, with line and column; no faces.
Result<MeshFile> parseObj(const std::string& text, const std::string& path);

/// Reads the MTL files of the OBJ file at `path` and gives parts their materials; lamps get their
/// sides (emitter_sides.h).
Status readObjMaterials(const std::string& path, MeshFile* file);

/// Both, for a file on the disk.
Result<MeshFile> loadObj(const std::string& path);

}  // namespace glint
