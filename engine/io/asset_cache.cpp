// Reading a scene's files once each, and relative paths.
#include "engine/io/asset_cache.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "engine/io/image_io.h"
#include "engine/io/ply_loader.h"
#include "engine/scene/generated_mesh.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

fs::path folderOf(const std::string& file) {
    std::error_code code;
    const fs::path absolute = fs::absolute(file, code);
    return (code ? fs::path(file) : absolute).lexically_normal().parent_path();
}

bool hasExtension(const std::string& path, std::string_view extension) {
    std::string ending = fs::path(path).extension().string();
    for (char& c : ending) {
        c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    }
    return ending == extension;
}

uint64_t fileBytes(const std::string& path) {
    std::error_code code;
    const uintmax_t size = fs::file_size(path, code);
    return code ? 0 : static_cast<uint64_t>(size);
}

/// The path of an OBJ file's texture, which counts from the working folder as the OBJ's own does, as it has
/// to be written beside `written`, the OBJ's path in the scene.
std::string besideObj(const std::string& texture, const std::string& resolvedObj,
                      const std::string& written) {
    const fs::path relative = fs::path(texture).lexically_relative(fs::path(resolvedObj).parent_path());
    const bool sameFolder = fs::path(resolvedObj).parent_path().empty();
    return relative.empty() || sameFolder ? (fs::path(written).parent_path() / texture).string()
                                          : (fs::path(written).parent_path() / relative).string();
}

}  // namespace

std::string resolvePath(const std::string& path, const std::string& from) {
    const fs::path given(path);
    return given.is_absolute() ? path : (fs::path(from).parent_path() / given).string();
}

std::string rebasePath(const std::string& path, const std::string& from, const std::string& to) {
    const fs::path given(path);
    if (path.empty() || given.is_absolute()) { return path; }
    const fs::path absolute = (folderOf(from) / given).lexically_normal();
    const fs::path relative = absolute.lexically_relative(folderOf(to));
    return relative.empty() ? absolute.string() : relative.string();
}

bool fileExists(const std::string& resolvedPath) {
    std::error_code code;
    const auto status = fs::status(resolvedPath, code);
    return fs::exists(status) && !fs::is_directory(status);
}

void appendObj(const ObjScene& obj, const std::string& path, const Object& prototype,
               SceneDescription* scene) {
    const auto firstTexture = static_cast<int>(scene->textures.size());
    const auto firstMaterial = static_cast<int>(scene->materials.size());
    const std::string resolved = resolvePath(path, scene->path);
    for (Texture texture : obj.textures) {
        texture.image.path = besideObj(texture.image.path, resolved, path);
        scene->textures.push_back(std::move(texture));
    }
    for (Material material : obj.materials) {
        material.color.texture += material.color.texture >= 0 ? firstTexture : 0;
        scene->materials.push_back(std::move(material));
    }
    for (size_t i = 0; i < obj.parts.size(); ++i) {
        const ObjPart& part = obj.parts[i];
        Object object = prototype;
        object.name = part.name;
        object.shape = ShapeKind::Mesh;
        object.mesh = static_cast<int>(scene->meshes.size());
        object.material = firstMaterial + part.material;
        scene->meshes.push_back(
            {part.name, {.path = path, .part = static_cast<int>(i), .generator = {}}, part.mesh});
        scene->objects.push_back(std::move(object));
    }
    scene->warnings.insert(scene->warnings.end(), obj.warnings.begin(), obj.warnings.end());
}

/// One file that is written in two ways is one file.
std::string AssetCache::keyOf(const std::string& path) const {
    return fs::path(resolvePath(path, scenePath_)).lexically_normal().string();
}

Result<AssetCache::Obj*> AssetCache::obj(const std::string& path) {
    std::unique_ptr<Obj>& cached = objs_[keyOf(path)];
    if (!cached) {
        const std::string resolved = resolvePath(path, scenePath_);
        Result<ObjScene> loaded = loadObjGeometry(resolved);
        if (!loaded) { return loaded.error(); }
        cached = std::make_unique<Obj>(Obj{std::move(*loaded)});
        ++counts_->meshFiles;
        counts_->meshFileBytes += fileBytes(resolved);
    }
    return cached.get();
}

Result<const ObjScene*> AssetCache::objGeometry(const std::string& path) {
    const Result<Obj*> found = obj(path);
    if (!found) { return found.error(); }
    return &(*found)->scene;
}

Result<const ObjScene*> AssetCache::objWithMaterials(const std::string& path) {
    const Result<Obj*> found = obj(path);
    if (!found) { return found.error(); }
    Obj& whole = **found;
    if (!whole.hasMaterials) {
        if (Status read = readObjMaterials(resolvePath(path, scenePath_), &whole.scene); !read) {
            return read.error();
        }
        whole.hasMaterials = true;
    }
    return &whole.scene;
}

Result<std::shared_ptr<MeshData>> AssetCache::meshFile(const MeshSource& source) {
    const std::string resolved = resolvePath(source.path, scenePath_);
    const bool isObj = hasExtension(source.path, ".obj") || source.part >= 0;  // only OBJ files have parts
    if (!isObj) {
        auto mesh = loadPly(resolved);
        if (mesh) {
            ++counts_->meshFiles;
            counts_->meshFileBytes += fileBytes(resolved);
        }
        return mesh;
    }
    const auto scene = objGeometry(source.path);
    if (!scene) { return scene.error(); }
    const auto& parts = (*scene)->parts;
    if (source.part < 0) { return joinParts(parts); }
    if (static_cast<size_t>(source.part) >= parts.size()) {
        return Error{
            fmt::format("has {} parts; there is no part {} (they count from 0)", parts.size(), source.part),
            {resolved, 0, 0, ""}};
    }
    return parts[static_cast<size_t>(source.part)].mesh;
}

Result<std::shared_ptr<const MeshData>> AssetCache::mesh(const MeshSource& source) {
    const std::string file = source.path.empty() ? "" : keyOf(source.path);
    const std::string key =
        fmt::format("{}\n{}\n{}\n{}\n{}", file, source.part, source.generator, source.triangles, source.seed);
    auto& cached = meshes_[key];
    if (!cached) {
        auto loaded = source.generator.empty() ? meshFile(source) : generateMesh(source);
        if (!loaded) { return loaded.error(); }
        counts_->generatedMeshes += source.generator.empty() ? 0 : 1;
        cached = std::move(*loaded);
    }
    return std::shared_ptr<const MeshData>(cached);
}

void AssetCache::countImage(const ImageSource& image, const std::string& path) {
    ++counts_->imageFiles;
    counts_->imageFileBytes += fileBytes(path);
    counts_->pixelBytes += image.bytes ? image.bytes->rgb.size() : image.floats->rgb.size() * sizeof(float);
}

Result<ImageSource> AssetCache::texture(const ImageSource& wanted) {
    ImageSource& cached = textures_[keyOf(wanted.path)];
    if (!cached.isRead()) {
        const std::string resolved = resolvePath(wanted.path, scenePath_);
        Result<ImageSource> image = loadImage(resolved);
        if (!image) { return image.error(); }
        countImage(*image, resolved);
        cached = std::move(*image);
    }
    ImageSource named = cached;
    named.path = wanted.path;
    return named;
}

void AssetCache::remember(const ImageSource& texture) {
    if (texture.isRead() && !texture.path.empty()) { textures_[keyOf(texture.path)] = texture; }
}

Result<ImageSource> AssetCache::environment(const ImageSource& wanted) {
    ImageSource source = wanted;
    if (wanted.sky) {
        source.floats = generateSky(*wanted.sky);
        ++counts_->generatedImages;
        counts_->pixelBytes += source.floats->rgb.size() * sizeof(float);
        return source;
    }
    const std::string resolved = resolvePath(wanted.path, scenePath_);
    auto image = loadImageF(resolved);
    if (!image) { return image.error(); }
    source.floats = std::move(*image);
    countImage(source, resolved);
    return source;
}

void AssetCache::dropUnusedUvs(const SceneDescription& scene) {
    std::set<const MeshData*> needed;
    const std::vector<bool> textured = texturedMeshes(scene);
    for (size_t i = 0; i < textured.size(); ++i) {
        if (textured[i]) { needed.insert(scene.meshes[i].data.get()); }
    }
    const auto drop = [&needed](MeshData& mesh) {
        if (!mesh.uvs.empty() && needed.count(&mesh) == 0) {
            mesh.uvs = {};
            mesh.uvsLeftOut = true;
        }
    };
    for (auto& [key, mesh] : meshes_) {
        if (mesh) { drop(*mesh); }
    }
    for (auto& [key, obj] : objs_) {
        if (obj) {
            std::ranges::for_each(obj->scene.parts, [&](ObjPart& part) { drop(*part.mesh); });
        }
    }
}

}  // namespace glint
