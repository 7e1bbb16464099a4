#include "engine/io/embedded_files.h"

#include <filesystem>
#include <map>
#include <set>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/file_path.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMostNameBytes = 100;

/// A name from a foreign file as one that stays in the scene's folder.
std::string harmlessName(const std::string& name) {
    std::string out;
    for (const char c : fs::path(name).filename().string().substr(0, kMostNameBytes)) {
        out += static_cast<unsigned char>(c) < ' ' || c == '\\' || c == ':' ? '_' : c;
    }
    return out.find_first_not_of('.') == std::string::npos ? "embedded" : out;
}

class EmbeddedWriter {
  public:
    EmbeddedWriter(std::string scenePath, std::string pathsCountFrom)
        : scenePath_(std::move(scenePath)), pathsCountFrom_(std::move(pathsCountFrom)) {}

    template <class... Generators>
    void write(AssetSource<Generators...>* source) {
        const auto* embedded = std::get_if<EmbeddedFile>(source);
        if (embedded == nullptr || !status) { return; }
        std::string& path = written_[embedded->bytes.get()];
        if (path.empty()) {
            const Result<std::string> name = writeBeside(*embedded, scenePath_);
            if (!name) {
                status = name.error();
                return;
            }
            path = *name;
        }
        *source = FileSource{rebasePath(path, scenePath_, pathsCountFrom_)};
    }

    Status status;

  private:
    std::string scenePath_;
    std::string pathsCountFrom_;
    std::map<const std::string*, std::string> written_;
};

class Embedder {
  public:
    Embedder(fs::path folder, std::string scenePath)
        : folder_(std::move(folder)), scenePath_(std::move(scenePath)) {}

    template <class... Generators>
    void embed(AssetSource<Generators...>* source) {
        const auto* file = std::get_if<FileSource>(source);
        if (file == nullptr) { return; }
        const fs::path path = resolvePath(file->path, scenePath_);
        std::error_code problem;
        if (!fs::equivalent(path.parent_path(), folder_, problem) || problem) { return; }
        std::shared_ptr<const std::string>& bytes = read_[path.string()];
        if (!bytes) {
            Result<std::string> read = readFile(path.string());
            if (!read) { return; }
            bytes = std::make_shared<const std::string>(std::move(*read));
        }
        *source = EmbeddedFile{path.filename().string(), bytes};
    }

  private:
    fs::path folder_;
    std::string scenePath_;
    std::map<std::string, std::shared_ptr<const std::string>> read_;
};

/// Of every image and mesh.
template <class Visit>
void forEachSource(SceneDescription* scene, const Visit& visit) {
    for (Texture& texture : scene->textures) {
        visit(&texture.image.source);
    }
    for (SceneImage& image : scene->environmentImages) {
        visit(&image.source);
    }
    for (Mesh& mesh : scene->meshes) {
        visit(&mesh.source);
    }
}

}  // namespace

Result<std::string> writeBeside(const EmbeddedFile& file, const std::string& scenePath) {
    const fs::path wanted(harmlessName(file.name));
    for (int number = 1;; ++number) {
        const std::string name =
            number == 1 ? wanted.string()
                        : fmt::format("{}-{}{}", wanted.stem().string(), number, wanted.extension().string());
        const std::string path = resolvePath(name, scenePath);
        if (!fileExists(path)) {
            if (Status written = writeFileAtomically(path, *file.bytes); !written) { return written.error(); }
            return name;
        }
        const Result<std::string> there = readFile(path);
        if (there && *there == *file.bytes) { return name; }
    }
}

Status writeEmbeddedFiles(SceneDescription* scene, const std::string& scenePath) {
    EmbeddedWriter writer(scenePath, scene->path);
    forEachSource(scene, [&writer](auto* source) { writer.write(source); });
    return writer.status;
}

EmbeddedByPath nameEmbeddedFiles(SceneDescription* scene) {
    std::set<std::string> taken;
    forEachSource(scene, [&taken](auto* source) { taken.insert(pathOf(*source)); });
    EmbeddedByPath files;
    std::map<EmbeddedFile, std::string> paths;
    forEachSource(scene, [&](auto* source) {
        const auto* embedded = std::get_if<EmbeddedFile>(source);
        if (embedded == nullptr) { return; }
        std::string& path = paths[*embedded];
        for (size_t number = files.size(); path.empty() || taken.contains(path); ++number) {
            path = fmt::format("embedded/{}-{}", number, harmlessName(embedded->name));
        }
        files.emplace(path, *embedded);
        *source = FileSource{path};
    });
    return files;
}

void restoreEmbeddedFiles(const EmbeddedByPath& files, SceneDescription* scene) {
    forEachSource(scene, [&files](auto* source) {
        const auto found = files.find(pathOf(*source));
        if (found != files.end()) { *source = found->second; }
    });
}

void embedFilesOf(const std::string& folder, SceneDescription* scene) {
    Embedder embedder(folder, scene->path);
    forEachSource(scene, [&embedder](auto* source) { embedder.embed(source); });
}

}  // namespace glint
