#include "engine/io/importer.h"

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/io/file_kind.h"
#include "engine/io/foreign_kind.h"
#include "engine/io/mesh_normals.h"

namespace glint {

extern const Importer kImportJson, kImportText, kImportObj, kImportPly, kImportStl, kImportGltf,
    kImportMitsuba, kImportPbrt;

std::span<const Importer> importers() {
    static const Importer kAll[] = {kImportJson, kImportText, kImportObj,     kImportPly,
                                    kImportStl,  kImportGltf, kImportMitsuba, kImportPbrt};
    return kAll;
}

const Importer* importerOf(const std::string& path, std::string_view head) {
    return kindOf(importers(), path, head);
}

std::string listImporters(bool onlyMeshes) {
    std::vector<std::string> kinds;
    for (const Importer& importer : importers()) {
        if (!onlyMeshes || importer.readMesh != nullptr) {
            kinds.push_back(fmt::format("{} ({})", importer.name, importer.extensions));
        }
    }
    return joinNames(std::vector<std::string_view>(kinds.begin(), kinds.end()));
}

Result<MeshFile> readMeshFile(const std::string& bytes, const std::string& path, bool isFaceted) {
    const Importer* importer = importerOf(path, headOf(bytes));
    if (const auto foreign = foreignKindError(path, headOf(bytes), importer == nullptr)) { return *foreign; }
    if (importer != nullptr && importer->readMesh != nullptr) {
        Result<MeshFile> file = importer->readMesh(bytes, path);
        if (file) { completeNormals(path, &*file, isFaceted); }
        return file;
    }
    return Error{fmt::format("is not a mesh file Glint knows; expected {}", listImporters(true)),
                 {.file = path}};
}

Result<std::string> readMeshBytes(const std::string& path) {
    return readFileOfKind(path, [&](std::string_view head) {
        const Importer* importer = importerOf(path, head);
        return looksLikeText(head) ||
               (importer != nullptr &&
                (importer->looksLike(head) || (importer->canBe != nullptr && importer->canBe(head))));
    });
}

bool bringsMaterials(const std::string& path) {
    const Importer* importer = kindByName(importers(), path);
    return importer != nullptr && importer->readMaterials != nullptr;
}

}  // namespace glint
