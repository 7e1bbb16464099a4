#include "engine/io/mesh_scene.h"

#include <filesystem>
#include <utility>

#include "engine/io/asset_cache.h"
#include "engine/io/default_view.h"
#include "engine/io/used_assets.h"

namespace glint {
namespace {

/// Vertex colours under an image that was read are dropped: where programs write both, the image is the finer
/// one, and what they show. Such meshes are the scene's own from here on.
void dropColorsUnderImages(SceneDescription* scene) {
    size_t dropped = 0;
    for (const Object& object : scene->objects) {
        const int texture = scene->materials[static_cast<size_t>(object.material)].color.texture;
        if (object.mesh < 0 || texture < 0) { continue; }
        Mesh& mesh = scene->meshes[static_cast<size_t>(object.mesh)];
        const bool isShown = scene->textures[static_cast<size_t>(texture)].image.isRead();
        if (!isShown || !mesh.data || mesh.data->colors.empty()) { continue; }
        auto plain = std::make_shared<MeshData>(*mesh.data);
        plain->colors.clear();
        mesh.data = std::move(plain);
        mesh.source = {};
        ++dropped;
    }
    if (dropped > 0) {
        scene->notes.push_back(scene->path + ": vertex colours are left out where an image stands");
    }
}

}  // namespace

Result<SceneDescription> loadMeshScene(const std::string& path, const LoadOptions& options) {
    AssetCache assets(path, options.counts);
    const std::string name = std::filesystem::path(path).filename().string();
    const auto file = assets.meshFileWithMaterials(name);
    if (!file) { return file.error(); }
    SceneDescription scene;
    scene.path = path;
    scene.title = name;
    appendMeshFile(std::move(**file), name, &scene);
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
    dropColorsUnderImages(&scene);
    applyDefaultView(&scene, options.noStudio);
    for (const Asset& asset : lackingAssets(scene)) {  // the studio's light
        if (Status read = readAsset(asset, &assets, &scene); !read) { return read.error(); }
    }
    return scene;
}

}  // namespace glint
