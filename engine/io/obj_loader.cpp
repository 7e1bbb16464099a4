#include "engine/io/obj_loader.h"

#include <memory>
#include <optional>

#include <fmt/format.h>

#include "engine/io/emitter_sides.h"
#include "engine/io/file_kind.h"
#include "engine/io/obj_materials.h"
#include "engine/io/obj_parser.h"
#include "engine/io/plain_text.h"
#include "engine/io/vertex_colors.h"

namespace glint {
namespace {

/// The parts are the same whether a file's materials are read or not: it looks into the libraries by itself.
void joinManyParts(const std::string& path, MeshFile* file) {
    const size_t parts = file->parts.size();
    if (parts <= kMostSeparateParts) { return; }
    std::optional<MaterialResolver> libraries;
    const auto isDefined = [&](const std::string& material) {
        if (!libraries) { libraries.emplace(path, file).readLibraries(file->libraries); }
        return libraries->defines(material);
    };
    if (!joinByMaterial(&file->parts, isDefined)) { return; }
    file->notes.push_back(fmt::format("{}: {} runs of faces are joined to {} objects, by their materials",
                                      path, parts, file->parts.size()));
}

}  // namespace

Result<MeshFile> parseObj(const std::string& bytes, const std::string& path) {
    const std::optional<PlainText> plain = asPlainText(bytes);
    const std::string& text = plain ? plain->text : bytes;
    auto parser = std::make_unique<ObjParser>(text, path, false);
    Status parsed = parser->run();
    if (parser->needsVerticesFirst()) {
        parser = std::make_unique<ObjParser>(text, path, true);
        parsed = parser->run();
    }
    if (!parsed) { return parsed.error(); }
    MeshFile file = std::move(parser->file);
    file.warnings = parser->cursor().remarks().lines();
    if (plain) { file.warnings.push_back(fmt::format("{}: {}", path, plain->repaired)); }
    decodeVertexColors(path, &file);
    joinManyParts(path, &file);
    return file;
}

Status readObjMaterials(const std::string& path, MeshFile* file) {
    MaterialResolver resolver(path, file);
    resolver.readLibraries(file->libraries);
    resolver.makeRoom();
    for (MeshPart& part : file->parts) {
        part.material = resolver.indexOf(part);
    }
    resolver.scaleBumps();
    resolver.finish();
    chooseEmitterSides(path, file);
    return {};
}

Result<MeshFile> loadObj(const std::string& path) {
    const Result<std::string> text = readFileOfKind(path, looksLikeText);
    if (!text) { return text.error(); }
    Result<MeshFile> file = parseObj(*text, path);
    if (file) {
        if (Status read = readObjMaterials(path, &*file); !read) { return read.error(); }
    }
    return file;
}

}  // namespace glint
