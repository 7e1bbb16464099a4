#include "engine/io/file_kind.h"
#include "engine/io/importer.h"
#include "engine/io/mesh_scene.h"
#include "engine/io/ply_loader.h"

namespace glint {
namespace {

bool looksLike(std::string_view head) {
    const std::string_view text = firstText(head);
    const size_t end = text.find_first_not_of(" \t", 3);
    return (text.starts_with("ply") || text.starts_with("PLY")) && end != std::string_view::npos &&
           (text[end] == '\n' || text[end] == '\r');
}

}  // namespace

extern const Importer kImportPly;
const Importer kImportPly{"PLY", ".ply", looksLike, loadMeshScene, parsePly, readPlyMaterials};

}  // namespace glint
