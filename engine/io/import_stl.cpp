#include "engine/io/file_kind.h"
#include "engine/io/importer.h"
#include "engine/io/mesh_scene.h"
#include "engine/io/stl_loader.h"

namespace glint {
namespace {

/// The text form, or the binary one, which has no mark, by its numbers.
bool looksLike(std::string_view head) {
    return (firstText(head).starts_with("solid") && head.find("facet") != std::string_view::npos) ||
           looksLikeBinaryStl(head);
}

}  // namespace

extern const Importer kImportStl;
const Importer kImportStl{.name = "STL",
                          .extensions = ".stl",
                          .looksLike = looksLike,
                          .load = loadMeshScene,
                          .readMesh = parseStl,
                          .readMaterials = readStlMaterials,
                          .canBe = canBeBinaryStl};

}  // namespace glint
