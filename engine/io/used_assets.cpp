#include "engine/io/used_assets.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "engine/scene/scene_use.h"

namespace glint {
namespace {

bool isLeftOut(const Mesh& mesh, bool textured) { return !mesh.data || (textured && mesh.data->uvsLeftOut); }

/// Whether the material is on a mesh that has to be read again for its texture coordinates.
std::vector<bool> materialsThatLackUvs(const SceneDescription& scene) {
    std::vector<bool> lacking(scene.materials.size(), false);
    for (const Object& object : scene.objects) {
        if (object.shape == ShapeKind::Mesh) {
            const Mesh& mesh = scene.meshes[static_cast<size_t>(object.mesh)];
            const auto material = static_cast<size_t>(object.material);
            lacking[material] =
                lacking[material] || isLeftOut(mesh, !usedTextures(scene.materials[material]).empty());
        }
    }
    return lacking;
}

Status readMesh(Mesh* mesh, AssetCache* assets) {
    auto data = assets->mesh(mesh->source);
    if (!data) { return data.error(); }
    if (mesh->data && !sameTriangles(*mesh->data, **data)) {
        return Error{"has changed since the scene was opened; open the scene again",
                     {resolvePath(pathOf(mesh->source), assets->scenePath()), 0, 0, ""}};
    }
    mesh->data = std::move(*data);
    return {};
}

Status readImage(Result<SceneImage> read, SceneImage* image) {
    if (!read) { return read.error(); }
    *image = std::move(*read);
    return {};
}

}  // namespace

std::vector<Asset> lackingAssets(const SceneDescription& scene) {
    std::vector<Asset> lacking;
    const std::vector<bool> placed = usedMeshes(scene);
    const std::vector<bool> textured = texturedMeshes(scene);
    for (size_t i = 0; i < placed.size(); ++i) {
        if (placed[i] && isLeftOut(scene.meshes[i], textured[i])) { lacking.push_back({AssetKind::Mesh, i}); }
    }
    const std::vector<bool> used = usedTextures(scene);
    for (size_t i = 0; i < used.size(); ++i) {
        if (used[i] && !scene.textures[i].image.isRead()) { lacking.push_back({AssetKind::Texture, i}); }
    }
    if (usesEnvironmentImage(scene)) {
        const auto image = static_cast<size_t>(scene.environment.image);
        if (!scene.environmentImages[image].isRead()) { lacking.push_back({AssetKind::Environment, image}); }
    }
    return lacking;
}

std::vector<Asset> idleAssets(const SceneDescription& scene) {
    std::vector<Asset> idle;
    const std::vector<bool> placed = usedMeshes(scene);
    for (size_t i = 0; i < placed.size(); ++i) {
        if (!placed[i] && !scene.meshes[i].data) { idle.push_back({AssetKind::Mesh, i}); }
    }
    const std::vector<bool> used = usedTextures(scene);
    for (size_t i = 0; i < used.size(); ++i) {
        if (!used[i] && !scene.textures[i].image.isRead()) { idle.push_back({AssetKind::Texture, i}); }
    }
    for (size_t i = 0; i < scene.environmentImages.size(); ++i) {
        const bool isUsed = usesEnvironmentImage(scene) && static_cast<size_t>(scene.environment.image) == i;
        if (!isUsed && !scene.environmentImages[i].isRead()) { idle.push_back({AssetKind::Environment, i}); }
    }
    return idle;
}

std::string assetFile(const SceneDescription& scene, const Asset& asset) {
    switch (asset.kind) {
        case AssetKind::Mesh:
            return pathOf(scene.meshes[asset.index].source);
        case AssetKind::Texture:
            return pathOf(scene.textures[asset.index].image.source);
        case AssetKind::Environment:
            break;
    }
    return pathOf(scene.environmentImages[asset.index].source);
}

std::vector<SceneFile> sceneFiles(const SceneDescription& scene) {
    std::vector<SceneFile> files{{"the scene", scene.path}};
    const auto add = [&](AssetKind kind, size_t count, const char* what) {
        for (size_t i = 0; i < count; ++i) {
            const std::string file = assetFile(scene, {kind, i});
            if (!file.empty()) { files.push_back({what, resolvePath(file, scene.path)}); }
        }
    };
    add(AssetKind::Mesh, scene.meshes.size(), "a mesh of the scene");
    add(AssetKind::Texture, scene.textures.size(), "a texture of the scene");
    add(AssetKind::Environment, scene.environmentImages.size(), "the scene's environment");
    for (const std::string& path : scene.filesRead) {
        files.push_back({"a part of the scene", path});
    }
    return files;
}

Status readAsset(const Asset& asset, AssetCache* assets, SceneDescription* scene) {
    switch (asset.kind) {
        case AssetKind::Mesh:
            return readMesh(&scene->meshes[asset.index], assets);
        case AssetKind::Texture: {
            SceneImage& image = scene->textures[asset.index].image;
            return readImage(assets->texture(image.source), &image);
        }
        case AssetKind::Environment:
            break;
    }
    SceneImage& image = scene->environmentImages[asset.index];
    return readImage(assets->environment(image.source, &scene->warnings), &image);
}

void goWithout(std::span<const Asset> assets, SceneDescription* scene) {
    std::vector<bool> meshes(scene->meshes.size(), false);
    std::vector<bool> textures(scene->textures.size(), false);
    for (const Asset& asset : assets) {
        switch (asset.kind) {
            case AssetKind::Mesh:
                meshes[asset.index] = true;
                break;
            case AssetKind::Texture:
                textures[asset.index] = true;
                break;
            case AssetKind::Environment:
                scene->environment.image = -1;
                break;
        }
    }
    const auto isMissing = [&meshes](const Object& object) {
        return object.shape == ShapeKind::Mesh && meshes[static_cast<size_t>(object.mesh)];
    };
    std::erase_if(scene->objects, isMissing);
    std::erase_if(scene->hiddenObjects, isMissing);
    for (Light& light : scene->lights) {
        int& texture = light.image.texture;
        if (texture >= 0 && textures[static_cast<size_t>(texture)]) { texture = -1; }
    }
    for (Material& material : scene->materials) {
        for (int* texture : inputTextures(&material)) {
            if (*texture >= 0 && textures[static_cast<size_t>(*texture)]) { *texture = -1; }
        }
    }
}

void readUsedAssets(AssetCache* assets, SceneDescription* scene,
                    const std::function<bool(const Asset&, const Error&)>& goesOn) {
    // Going without meshes may leave textures without use: one kind is settled before the next.
    for (std::vector<Asset> lacking = lackingAssets(*scene); !lacking.empty();
         lacking = lackingAssets(*scene)) {
        std::vector<Asset> missing;
        for (const Asset& asset : lacking) {
            if (asset.kind != lacking.front().kind) { break; }
            if (Status read = readAsset(asset, assets, scene); !read) {
                if (!goesOn(asset, read.error())) { return; }
                missing.push_back(asset);
            }
        }
        goWithout(missing, scene);
    }
    assets->dropUnusedUvs(*scene);
    assets->report(scene);
}

void remarkUnreadImage(const Asset& asset, const Error& error, SceneDescription* scene, Remarks* remarks) {
    for (Material& material : scene->materials) {
        const bool isUser = material.color.texture == static_cast<int>(asset.index);
        if (isUser && isZero(material.color.value)) { material.color.value = Vec3(0.5f); }
    }
    remarks->add(
        "images cannot be read; the material's own colour takes their place", [&] { return scene->path; },
        scene->textures[asset.index].name, [&] { return fmt::format(": {}", error.message); });
}

Status readUsedAssets(AssetCache* assets, SceneDescription* scene) {
    Status first;
    readUsedAssets(assets, scene, [&first](const Asset&, const Error& error) {
        first = error;
        return false;
    });
    return first;
}

CompletedScene completeScene(const SceneDescription& scene) {
    CompletedScene completed{scene, {}};
    AssetCache assets(scene.path);
    for (const Texture& texture : scene.textures) {
        assets.remember(texture.image);
    }
    for (const Asset& asset : lackingAssets(scene)) {
        Status read = readAsset(asset, &assets, &completed.scene);
        if (!read && !completed.error) { completed.error = read.error(); }
    }
    assets.dropUnusedUvs(completed.scene);
    return completed;
}

void takeAssets(const SceneDescription& from, SceneDescription* to) {
    const size_t meshes = std::min(from.meshes.size(), to->meshes.size());
    for (size_t i = 0; i < meshes; ++i) {
        const auto& read = from.meshes[i].data;
        if (read && isLeftOut(to->meshes[i], !read->uvsLeftOut)) { to->meshes[i].data = read; }
    }
    const size_t textures = std::min(from.textures.size(), to->textures.size());
    for (size_t i = 0; i < textures; ++i) {
        if (!to->textures[i].image.isRead()) { to->textures[i].image = from.textures[i].image; }
    }
    const size_t images = std::min(from.environmentImages.size(), to->environmentImages.size());
    for (size_t i = 0; i < images; ++i) {
        if (!to->environmentImages[i].isRead()) { to->environmentImages[i] = from.environmentImages[i]; }
    }
}

void hideUnread(std::span<const Mesh> meshes, SceneDescription* scene) {
    const auto isRead = [meshes](const Object& object) {
        return object.shape != ShapeKind::Mesh || meshes[static_cast<size_t>(object.mesh)].data;
    };
    auto& objects = scene->objects;
    const auto unread = std::stable_partition(objects.begin(), objects.end(), isRead);
    std::move(unread, objects.end(), std::back_inserter(scene->hiddenObjects));
    objects.erase(unread, objects.end());
}

SceneDescription withoutLacking(const SceneDescription& draft, const SceneDescription& before) {
    SceneDescription scene = draft;
    const std::vector<bool> lackUvs = materialsThatLackUvs(draft);
    const size_t materials = std::min(draft.materials.size(), before.materials.size());
    for (size_t i = 0; i < materials; ++i) {
        const std::vector<int> known = inputTextures(before.materials[i]);
        const std::vector<int*> textures = inputTextures(&scene.materials[i]);
        for (size_t input = 0; input < textures.size(); ++input) {
            const int texture = *textures[input];
            const bool unread = texture >= 0 && !draft.textures[static_cast<size_t>(texture)].image.isRead();
            if (unread || lackUvs[i]) { *textures[input] = known[input]; }
        }
    }
    for (const Asset& asset : lackingAssets(draft)) {
        if (asset.kind == AssetKind::Environment) { scene.environment = before.environment; }
    }
    hideUnread(scene.meshes, &scene);
    return scene;
}

}  // namespace glint
