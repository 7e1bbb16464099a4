// What a scene uses is read; what it only names is left on the disk until an edit uses it.
//
// Left out: meshes that no object places, texture coordinates that no texture needs, textures that no
// object's material has, and the image of an environment that does not shine. They keep their names, so that
// the scene can be saved and edited. Meshes that stand in the scene file itself are kept whole, since they
// could not be read again. Scene readers call the first functions, a session's controller the last ones.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/io/asset_cache.h"
#include "engine/io/remarks.h"
#include "engine/scene/scene.h"

namespace glint {

enum class AssetKind : uint8_t { Mesh, Texture, Environment };

/// meshes[index], textures[index] or environmentImages[index] of a scene.
struct Asset {
    AssetKind kind = AssetKind::Mesh;
    size_t index = 0;
};

/// What the scene uses and has not read, in the order of AssetKind.
std::vector<Asset> lackingAssets(const SceneDescription& scene);
/// What it names, has not read and does not use.
std::vector<Asset> idleAssets(const SceneDescription& scene);

/// The asset's file on the disk as written in the scene; empty where it has none.
std::string assetFile(const SceneDescription& scene, const Asset& asset);

/// A file that a scene is made of; `what` it is, in messages: "a mesh of the scene".
struct SceneFile {
    std::string what, path;
};

/// The files that it names, whether they are used or not, and all that its loader read beside them.
std::vector<SceneFile> sceneFiles(const SceneDescription& scene);

/// Error: the file cannot be read or is malformed; it holds other triangles than those it has given before.
Status readAsset(const Asset& asset, AssetCache* assets, SceneDescription* scene);

/// What used the assets goes without: materials take their colour, the environment too; objects of a mesh
/// are removed.
void goWithout(std::span<const Asset> assets, SceneDescription* scene);

/// Remarks on an image that a mesh file's materials name and that cannot be read: goWithout() shows their
/// colour, and this gives a black one a grey, so that what goes without is seen.
void remarkUnreadImage(const Asset& asset, const Error& error, SceneDescription* scene, Remarks* remarks);

/// Reads what the scene uses, warns of what its mesh files needed (AssetCache::report), and drops the texture
/// coordinates that it does not. `goesOn` is asked about each asset that cannot be read: whether to go
/// without it and on.
void readUsedAssets(AssetCache* assets, SceneDescription* scene,
                    const std::function<bool(const Asset&, const Error&)>& goesOn);
/// The same up to the first error.
Status readUsedAssets(AssetCache* assets, SceneDescription* scene);

/// A scene with what it uses, as far as that can be read, and the first error.
struct CompletedScene {
    SceneDescription scene;
    std::optional<Error> error;
};

/// For edits that use what was left out. May take long: runs on a thread of its own in the window. Thread
/// safe: what `scene` shares with others is not changed.
CompletedScene completeScene(const SceneDescription& scene);

/// Takes over what `from` has read and `to` has not; both are edits of one scene.
void takeAssets(const SceneDescription& from, SceneDescription* to);

/// Objects of meshes that were not read become hidden ones. `meshes` are the scene's, as far as they
/// are read.
void hideUnread(std::span<const Mesh> meshes, SceneDescription* scene);

/// `draft` but for those textures and that environment which it has not read: they stay as in `before`; and
/// objects of meshes that it has not read are hidden, as they were.
SceneDescription withoutLacking(const SceneDescription& draft, const SceneDescription& before);

}  // namespace glint
