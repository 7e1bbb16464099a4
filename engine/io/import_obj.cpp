#include <algorithm>

#include "engine/io/file_kind.h"
#include "engine/io/importer.h"
#include "engine/io/mesh_scene.h"
#include "engine/io/obj_loader.h"

namespace glint {
namespace {

/// By the first line that is no comment.
bool looksLike(std::string_view head) {
    std::string_view text = firstText(head);
    while (text.starts_with('#')) {
        text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
        text = firstText(text);
    }
    const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n"));
    for (const std::string_view statement : {"v", "vn", "vt", "o", "g", "s", "mtllib", "usemtl"}) {
        if (word == statement && word.size() < text.size()) { return true; }
    }
    return false;
}

}  // namespace

extern const Importer kImportObj;
const Importer kImportObj{"OBJ", ".obj", looksLike, loadMeshScene, parseObj, readObjMaterials};

}  // namespace glint
