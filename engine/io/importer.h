// The kinds of scene files that Glint opens. Whatever asks what a file is, or lists what can be opened, asks
// this table.
//
// A further kind is a file import_<name>.cpp that defines its Importer, and a line in importer.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/io/load_options.h"
#include "engine/io/mesh_file.h"
#include "engine/scene/scene.h"

namespace glint {

struct Importer {
    std::string_view name;                     ///< in messages
    std::string_view extensions;               ///< in lower case, with their dots, a blank apart
    bool (*looksLike)(std::string_view head);  ///< whether the file's first bytes are of this kind
    /// The file as a scene, without stabilityWarnings(). Error: with its place.
    Result<SceneDescription> (*load)(const std::string& path, const LoadOptions& options);
    /// The triangles alone, for scenes that name such a file as a mesh; `path` is used in messages. Null:
    /// these files are no meshes.
    Result<MeshFile> (*readMesh)(const std::string& bytes, const std::string& path) = nullptr;
    /// Gives a mesh file read from `path` its own materials; null: it has none.
    Status (*readMaterials)(const std::string& path, MeshFile* file) = nullptr;
    /// Whether a file of such a name, if it is no text, can begin with these bytes; null: as looksLike says.
    bool (*canBe)(std::string_view head) = nullptr;
    /// Whether it looks at LoadOptions::parameters.
    bool hasParameters = false;
    /// What brings light in such a file, for the message where nothing does.
    std::string_view lights = "a material that shines";
};

/// In the order in which they are listed and asked.
std::span<const Importer> importers();

/// Whether a file's first bytes are JSON of glTF, or of its binary form.
bool looksLikeGltf(std::string_view head);

/// Which one opens the file, as kindOf() tells; null: none.
const Importer* importerOf(const std::string& path, std::string_view head);

/// "Glint JSON (.json), … or PLY (.ply)": all of them, or those that read meshes.
std::string listImporters(bool onlyMeshes = false);

/// Reads a mesh file from memory and completes its normals (mesh_normals.h), but for smooth ones where it is
/// to be faceted. Error: as its importer; no importer reads meshes from such a file.
Result<MeshFile> readMeshFile(const std::string& bytes, const std::string& path, bool isFaceted = false);

/// The bytes of a file for readMeshFile(), as readFileOfKind() (file_kind.h) tells.
Result<std::string> readMeshBytes(const std::string& path);

/// Whether mesh files of that name bring materials of their own.
bool bringsMaterials(const std::string& path);

}  // namespace glint
