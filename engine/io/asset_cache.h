// The files a scene names, each read once: meshes and images by their path, with paths resolved from the
// scene's folder.
//
// Made by a scene reader for the time it reads one scene, and when an edit needs what was left out
// (used_assets.h, which decides what is read). Decides nothing about missing files: it reports them.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "engine/base/result.h"
#include "engine/io/load_options.h"
#include "engine/io/obj_loader.h"
#include "engine/scene/scene.h"

namespace glint {

/// `path` as seen from the folder of the file `from`; absolute paths stay.
std::string resolvePath(const std::string& path, const std::string& from);

/// `path`, which is relative to the folder of `from`, made relative to the folder of `to`. Absolute paths
/// stay, and so does a path that has no relative form.
std::string rebasePath(const std::string& path, const std::string& from, const std::string& to);

/// True when the resolved path names an existing file that is not a folder.
bool fileExists(const std::string& resolvedPath);

/// Appends all parts of an OBJ file as objects like `prototype`, with the file's own materials and
/// textures, which are not read. `path` is as written in the scene; the textures' paths become relative to
/// the scene's folder.
void appendObj(const ObjScene& obj, const std::string& path, const Object& prototype,
               SceneDescription* scene);

class AssetCache {
  public:
    /// `counts` (may be null) is added to.
    explicit AssetCache(std::string scenePath, LoadCounts* counts = nullptr)
        : scenePath_(std::move(scenePath)), counts_(counts != nullptr ? counts : &ownCounts_) {}
    AssetCache(const AssetCache&) = delete;
    AssetCache& operator=(const AssetCache&) = delete;

    const std::string& scenePath() const { return scenePath_; }

    /// The mesh that `source` names by file or generator. Error: as the loader's; a part the file does
    /// not have.
    Result<std::shared_ptr<const MeshData>> mesh(const MeshSource& source);

    /// The parts of an OBJ file, without or with its materials. Valid as long as the cache.
    Result<const ObjScene*> objGeometry(const std::string& path);
    Result<const ObjScene*> objWithMaterials(const std::string& path);

    /// The image that `wanted` names, as a texture or an environment, with its name.
    Result<ImageSource> texture(const ImageSource& wanted);
    Result<ImageSource> environment(const ImageSource& wanted);
    /// A texture that was read before, so that it is not read again.
    void remember(const ImageSource& texture);

    /// Frees the texture coordinates of meshes read here that no texture of `scene` needs. Nobody else may
    /// have the scene yet.
    void dropUnusedUvs(const SceneDescription& scene);

  private:
    struct Obj {
        ObjScene scene;
        bool hasMaterials = false;
    };
    std::string keyOf(const std::string& path) const;
    Result<Obj*> obj(const std::string& path);
    Result<std::shared_ptr<MeshData>> meshFile(const MeshSource& source);
    void countImage(const ImageSource& image, const std::string& path);

    std::string scenePath_;
    LoadCounts ownCounts_;
    LoadCounts* counts_;
    std::map<std::string, std::unique_ptr<Obj>> objs_;
    std::map<std::string, std::shared_ptr<MeshData>> meshes_;
    std::map<std::string, ImageSource> textures_;
};

}  // namespace glint
