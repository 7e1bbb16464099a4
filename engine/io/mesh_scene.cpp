#include "engine/io/mesh_scene.h"

#include <filesystem>

#include "engine/io/asset_cache.h"
#include "engine/io/default_view.h"
#include "engine/io/used_assets.h"

namespace glint {

Result<SceneDescription> loadMeshScene(const std::string& path, const LoadOptions& options) {
    AssetCache assets(path, options.counts);
    const std::string name = std::filesystem::path(path).filename().string();
    const auto file = assets.meshFileWithMaterials(name);
    if (!file) { return file.error(); }
    SceneDescription scene;
    scene.path = path;
    scene.title = name;
    appendMeshFile(**file, name, {}, &scene);
    Status failed;
    Remarks remarks;
    readUsedAssets(&assets, &scene, [&](const Asset& asset, const Error& error) {
        if (asset.kind == AssetKind::Texture) {
            remarkUnreadImage(asset, error, &scene, &remarks);
            return true;
        }
        failed = error;
        return false;
    });
    if (!failed) { return failed.error(); }
    const std::vector<std::string> lines = remarks.lines();
    scene.warnings.insert(scene.warnings.end(), lines.begin(), lines.end());
    applyDefaultView(&scene, options.noStudio);
    for (const Asset& asset : lackingAssets(scene)) {  // the studio's light
        if (Status read = readAsset(asset, &assets, &scene); !read) { return read.error(); }
    }
    return scene;
}

}  // namespace glint
