#include <algorithm>
#include <filesystem>

#include "engine/io/asset_cache.h"
#include "engine/io/default_view.h"
#include "engine/io/file_kind.h"
#include "engine/io/importer.h"
#include "engine/io/obj_loader.h"
#include "engine/io/used_assets.h"

namespace glint {
namespace {

/// By the first line that is no comment.
bool looksLike(std::string_view head) {
    std::string_view text = firstText(head);
    while (text.starts_with('#')) {
        text.remove_prefix(std::min(text.find('\n'), text.size()));
        text = firstText(text);
    }
    const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n"));
    for (const std::string_view statement : {"v", "vn", "vt", "o", "g", "s", "mtllib", "usemtl"}) {
        if (word == statement && word.size() < text.size()) { return true; }
    }
    return false;
}

Result<SceneDescription> load(const std::string& path, const LoadOptions& options) {
    AssetCache assets(path, options.counts);
    const std::string name = std::filesystem::path(path).filename().string();
    const auto file = assets.meshFileWithMaterials(name);
    if (!file) { return file.error(); }
    SceneDescription scene;
    scene.path = path;
    scene.title = name;
    appendMeshFile(**file, name, {}, &scene);
    if (Status read = readUsedAssets(&assets, &scene); !read) { return read.error(); }
    applyDefaultView(&scene);
    return scene;
}

}  // namespace

extern const Importer kImportObj;
const Importer kImportObj{"OBJ", ".obj", looksLike, load, parseObj, readObjMaterials};

}  // namespace glint
