#include "engine/io/file_kind.h"
#include "engine/io/importer.h"
#include "engine/io/mesh_scene.h"
#include "engine/io/ply_loader.h"

namespace glint {
namespace {

bool looksLike(std::string_view head) {
    const std::string_view text = firstText(head);
    return text.starts_with("ply\n") || text.starts_with("ply\r");
}

}  // namespace

extern const Importer kImportPly;
const Importer kImportPly{"PLY", ".ply", looksLike, loadMeshScene, parsePly, readPlyMaterials};

}  // namespace glint
