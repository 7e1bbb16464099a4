#include "engine/io/asset_cache.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/environment_image.h"
#include "engine/io/file_kind.h"
#include "engine/io/image_io.h"
#include "engine/io/importer.h"
#include "engine/scene/generated_mesh.h"
#include "engine/scene/scene_use.h"

namespace glint {

template <class... Generators>
std::optional<AssetCache::StoredFile> AssetCache::storedFile(const AssetSource<Generators...>& source) {
    if (const auto* file = std::get_if<FileSource>(&source)) { return *file; }
    if (const auto* file = std::get_if<EmbeddedFile>(&source)) { return *file; }
    return std::nullopt;
}

AssetCache::StoredFile AssetCache::keyOf(StoredFile file) const {
    if (auto* onDisk = std::get_if<FileSource>(&file)) {
        const std::filesystem::path path(resolvePath(onDisk->path, scenePath_));
        *onDisk = {.path = path.lexically_normal().string(), .isFaceted = onDisk->isFaceted};
    }
    return file;
}

std::string AssetCache::nameOf(const StoredFile& file) const {
    const auto* embedded = std::get_if<EmbeddedFile>(&file);
    return embedded != nullptr ? fmt::format("{} in {}", embedded->name, scenePath_)
                               : resolvePath(std::get<FileSource>(file).path, scenePath_);
}

Result<std::shared_ptr<const std::string>> AssetCache::open(
    const StoredFile& file, Result<std::string> (*read)(const std::string& path)) const {
    if (const auto* embedded = std::get_if<EmbeddedFile>(&file)) { return embedded->bytes; }
    Result<std::string> bytes = read(nameOf(file));
    if (!bytes) { return bytes.error(); }
    return std::make_shared<const std::string>(std::move(*bytes));
}

Result<AssetCache::LoadedMesh*> AssetCache::loadMesh(const StoredFile& file) {
    const StoredFile key = keyOf(file);
    if (const auto found = meshes_.find(key); found != meshes_.end()) { return &found->second; }
    const auto bytes = open(file, readMeshBytes);
    if (!bytes) { return bytes.error(); }
    const auto* onDisk = std::get_if<FileSource>(&file);
    const bool isFaceted = onDisk != nullptr && onDisk->isFaceted;
    Result<MeshFile> read = readMeshFile(**bytes, nameOf(file), isFaceted);
    if (!read) { return read.error(); }
    ++counts_->meshFiles;
    counts_->meshFileBytes += (*bytes)->size();
    return &meshes_.emplace(key, LoadedMesh{std::move(*read)}).first->second;
}

Result<const MeshFile*> AssetCache::meshFile(const FileSource& file) {
    const Result<LoadedMesh*> found = loadMesh(file);
    if (!found) { return found.error(); }
    return &(*found)->file;
}

Result<MeshFile*> AssetCache::meshFileWithMaterials(const std::string& path) {
    const Result<LoadedMesh*> found = loadMesh(FileSource{path});
    if (!found) { return found.error(); }
    LoadedMesh& mesh = **found;
    if (!mesh.hasMaterials) {
        const std::string resolved = resolvePath(path, scenePath_);
        const Importer* importer = importerOf(resolved, readHead(resolved));
        if (importer != nullptr && importer->readMaterials != nullptr) {
            if (Status read = importer->readMaterials(resolved, &mesh.file); !read) { return read.error(); }
        }
        mesh.hasMaterials = true;
    }
    return &mesh.file;
}

Result<std::shared_ptr<const MeshData>> AssetCache::mesh(const MeshSource& source) {
    using Found = std::shared_ptr<const MeshData>;
    if (const auto* generator = std::get_if<MeshGenerator>(&source)) {
        std::shared_ptr<MeshData>& cached = generated_[*generator];
        if (!cached) {
            auto generated = generateMesh(*generator);
            if (!generated) { return generated.error(); }
            ++counts_->generatedMeshes;
            cached = std::move(*generated);
        }
        return Found(cached);
    }
    const std::optional<StoredFile> file = storedFile(source);
    if (!file) { return Error{"the mesh is the scene's own and cannot be read again", {.file = scenePath_}}; }
    const Result<LoadedMesh*> loaded = loadMesh(*file);
    if (!loaded) { return loaded.error(); }
    LoadedMesh& mesh = **loaded;
    const std::vector<MeshPart>& parts = mesh.file.parts;
    const auto* onDisk = std::get_if<FileSource>(&*file);
    if (onDisk == nullptr || onDisk->part < 0) {
        if (!mesh.whole) { mesh.whole = joinParts(parts); }
        return Found(mesh.whole);
    }
    if (static_cast<size_t>(onDisk->part) < parts.size()) {
        return Found(parts[static_cast<size_t>(onDisk->part)].mesh);
    }
    return Error{
        fmt::format("has {} parts; there is no part {} (they count from 0)", parts.size(), onDisk->part),
        {.file = resolvePath(onDisk->path, scenePath_)}};
}

Result<SceneImage> AssetCache::loadImage(const StoredFile& file) {
    const auto bytes = open(file, readImageFile);
    if (!bytes) { return bytes.error(); }
    Result<SceneImage> image = decodeImage(**bytes, nameOf(file));
    if (image) {
        ++counts_->imageFiles;
        counts_->imageFileBytes += (*bytes)->size();
    }
    return image;
}

void AssetCache::countPixels(const SceneImage& image) {
    counts_->pixelBytes += image.bytes ? image.bytes->rgb.size() + image.bytes->alpha.size()
                                       : image.floats->rgb.size() * sizeof(float);
}

Result<SceneImage> AssetCache::texture(const ImageSource& source) {
    if (const auto* board = std::get_if<Checkerboard>(&source)) {
        return SceneImage{source, nullptr, generateCheckerboard(*board)};
    }
    const std::optional<StoredFile> file = storedFile(source);
    if (!file) {
        return Error{"the texture is the scene's own and cannot be read again", {.file = scenePath_}};
    }
    SceneImage& cached = textures_[keyOf(*file)];
    if (!cached.isRead()) {
        Result<SceneImage> image = loadImage(*file);
        if (!image) { return image.error(); }
        if (image->floats) {
            if (Status finite = checkFinite(*image->floats, nameOf(*file)); !finite) {
                return finite.error();
            }
        }
        countPixels(*image);
        cached = std::move(*image);
    }
    return SceneImage{source, cached.bytes, cached.floats};
}

void AssetCache::remember(const SceneImage& texture) {
    const std::optional<StoredFile> file = storedFile(texture.source);
    if (file && texture.isRead()) { textures_[keyOf(*file)] = texture; }
}

Result<SceneImage> AssetCache::environment(const ImageSource& source, std::vector<std::string>* warnings) {
    SceneImage out{source};
    if (const auto* sky = std::get_if<SkySource>(&source)) {
        out.floats = generateSky(*sky);
        ++counts_->generatedImages;
    } else {
        const std::optional<StoredFile> file = storedFile(source);
        if (!file) {
            return Error{"the environment's image is the scene's own and cannot be read again",
                         {.file = scenePath_}};
        }
        Result<SceneImage> image = loadImage(*file);
        if (!image) { return image.error(); }
        out = environmentImage(*image, nameOf(*file), warnings);
        out.source = source;
    }
    countPixels(out);
    return out;
}

void AssetCache::report(SceneDescription* scene) {
    const auto move = [](std::vector<std::string>& from, std::vector<std::string>* to) {
        to->insert(to->end(), from.begin(), from.end());
        from.clear();
    };
    for (auto& [key, mesh] : meshes_) {
        move(mesh.file.warnings, &scene->warnings);
        move(mesh.file.notes, &scene->notes);
    }
}

void AssetCache::dropUnusedUvs(const SceneDescription& scene) {
    std::set<const MeshData*> needed;
    const std::vector<bool> textured = texturedMeshes(scene);
    for (size_t i = 0; i < textured.size(); ++i) {
        if (textured[i]) { needed.insert(scene.meshes[i].data.get()); }
    }
    const auto drop = [&needed](const std::shared_ptr<MeshData>& mesh) {
        if (mesh && !mesh->uvs.empty() && needed.count(mesh.get()) == 0) {
            mesh->uvs = {};
            mesh->uvsLeftOut = true;
        }
    };
    for (auto& [generator, mesh] : generated_) {
        drop(mesh);
    }
    for (auto& [key, mesh] : meshes_) {
        drop(mesh.whole);
        std::ranges::for_each(mesh.file.parts, [&](const MeshPart& part) { drop(part.mesh); });
    }
}

}  // namespace glint
