// The files a scene names, each read once: meshes and images by their path, with paths resolved from the
// scene's folder.
//
// Made by a scene reader for the time it reads one scene. Decides nothing about missing files: it reports
// them.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "engine/base/result.h"
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

/// Appends all parts of an OBJ file as objects like `prototype`, with the file's own materials and textures.
/// `path` is as written in the scene; the textures' paths become relative to the scene's folder.
void appendObj(const ObjScene& obj, const std::string& path, const Object& prototype,
               SceneDescription* scene);

class AssetCache {
  public:
    explicit AssetCache(std::string scenePath) : scenePath_(std::move(scenePath)) {}

    const std::string& scenePath() const { return scenePath_; }

    /// The mesh that `source` names by file or generator. Error: as the loader's; a part the file does not
    /// have.
    Result<std::shared_ptr<const MeshData>> mesh(const MeshSource& source);

    /// The whole OBJ file; shared, so that objects of one file share meshes.
    Result<std::shared_ptr<const ObjScene>> obj(const std::string& path);

    /// An image as a texture or environment; `path` is as written in the scene and is kept for saving.
    Result<ImageSource> texture(const std::string& path);
    Result<ImageSource> environment(const std::string& path);

  private:
    Result<std::shared_ptr<const MeshData>> meshFile(const MeshSource& source);

    std::string scenePath_;
    std::map<std::string, std::shared_ptr<const ObjScene>> objs_;
    std::map<std::string, std::shared_ptr<const MeshData>> meshes_;
    std::map<std::string, ImageSource> textures_;
};

}  // namespace glint
