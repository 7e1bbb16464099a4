// The files that a scene names and those that it holds in memory, each read once, with paths resolved from
// the scene's folder.
//
// Made by a scene reader for the time it reads one scene, and when an edit needs what was left out
// (used_assets.h, which decides what is read). Decides nothing about missing files: it reports them.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "engine/base/result.h"
#include "engine/io/file_path.h"
#include "engine/io/load_options.h"
#include "engine/io/mesh_file.h"
#include "engine/scene/scene.h"

namespace glint {

class AssetCache {
  public:
    /// `counts` (may be null) is added to.
    explicit AssetCache(std::string scenePath, LoadCounts* counts = nullptr)
        : scenePath_(std::move(scenePath)), counts_(counts != nullptr ? counts : &ownCounts_) {}
    AssetCache(const AssetCache&) = delete;
    AssetCache& operator=(const AssetCache&) = delete;

    const std::string& scenePath() const { return scenePath_; }

    /// The mesh of a file or a generator. Error: as the reader's; a part the file does not have; a source
    /// that is the scene itself.
    Result<std::shared_ptr<const MeshData>> mesh(const MeshSource& source);

    /// The parts of a mesh file, without or with its materials. Valid as long as the cache. Who asks last may
    /// take all but the meshes out of the latter.
    Result<const MeshFile*> meshFile(const FileSource& file);
    Result<MeshFile*> meshFileWithMaterials(const std::string& path);

    /// The image of `source`, as a texture or as an environment (environment_image.h), with its source; what
    /// was repaired is appended to `warnings`. Error: also a texture's value that is not finite.
    Result<SceneImage> texture(const ImageSource& source);
    Result<SceneImage> environment(const ImageSource& source, std::vector<std::string>* warnings);
    /// A texture that was read before, so that it is not read again.
    void remember(const SceneImage& texture);

    /// Appends to the scene what the mesh files read here needed to be repaired, and what was decided.
    void report(SceneDescription* scene);

    /// Frees the texture coordinates of meshes read here that no texture of `scene` needs. Nobody else may
    /// have the scene yet.
    void dropUnusedUvs(const SceneDescription& scene);

  private:
    using StoredFile = std::variant<FileSource, EmbeddedFile>;
    struct LoadedMesh {
        MeshFile file;
        std::shared_ptr<MeshData> whole = {};  ///< its parts joined, once asked for
        bool hasMaterials = false;
    };

    template <class... Generators>
    static std::optional<StoredFile> storedFile(const AssetSource<Generators...>& source);
    /// One file that is written in two ways is one file.
    StoredFile keyOf(StoredFile file) const;
    /// What messages call the file.
    std::string nameOf(const StoredFile& file) const;
    /// The file's bytes, by `read` from the disk.
    Result<std::shared_ptr<const std::string>> open(
        const StoredFile& file, Result<std::string> (*read)(const std::string& path)) const;
    Result<LoadedMesh*> loadMesh(const StoredFile& file);
    Result<SceneImage> loadImage(const StoredFile& file);
    void countPixels(const SceneImage& image);

    std::string scenePath_;
    LoadCounts ownCounts_;
    LoadCounts* counts_;
    std::map<StoredFile, LoadedMesh> meshes_;
    std::map<MeshGenerator, std::shared_ptr<MeshData>> generated_;
    std::map<StoredFile, SceneImage> textures_;
};

}  // namespace glint
