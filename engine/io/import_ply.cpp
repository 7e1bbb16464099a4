#include <filesystem>

#include "engine/io/asset_cache.h"
#include "engine/io/default_view.h"
#include "engine/io/file_kind.h"
#include "engine/io/importer.h"
#include "engine/io/ply_loader.h"
#include "engine/io/used_assets.h"

namespace glint {
namespace {

bool looksLike(std::string_view head) {
    const std::string_view text = firstText(head);
    return text.starts_with("ply\n") || text.starts_with("ply\r\n");
}

Result<SceneDescription> load(const std::string& path, const LoadOptions& options) {
    AssetCache assets(path, options.counts);
    SceneDescription scene;
    scene.path = path;
    scene.title = std::filesystem::path(path).filename().string();
    scene.meshes.push_back({scene.title, FileSource{scene.title}, nullptr});
    Object object;
    object.name = scene.title;
    object.shape = ShapeKind::Mesh;
    object.mesh = 0;
    scene.objects.push_back(std::move(object));
    if (Status read = readUsedAssets(&assets, &scene); !read) { return read.error(); }
    applyDefaultView(&scene);
    return scene;
}

Result<MeshFile> readMesh(const std::string& bytes, const std::string& path) {
    auto mesh = parsePly(bytes, path);
    if (!mesh) { return mesh.error(); }
    MeshFile file;
    file.parts.push_back({.name = {}, .materialName = {}, .materialPlace = {}, .mesh = std::move(*mesh)});
    return file;
}

}  // namespace

extern const Importer kImportPly;
const Importer kImportPly{"PLY", ".ply", looksLike, load, readMesh};

}  // namespace glint
