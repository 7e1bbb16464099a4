// Reading a scene's files once each, and relative paths.
#include "engine/io/asset_cache.h"

#include <filesystem>

#include <fmt/format.h>

#include "engine/io/image_io.h"
#include "engine/io/ply_loader.h"
#include "engine/scene/generated_mesh.h"

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

}  // namespace

std::string resolvePath(const std::string& path, const std::string& from) {
    const fs::path given(path);
    return given.is_absolute() ? path : (fs::path(from).parent_path() / given).string();
}

std::string rebasePath(const std::string& path, const std::string& from, const std::string& to) {
    const fs::path given(path);
    if (path.empty() || given.is_absolute()) {
        return path;
    }
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
    const fs::path folder = fs::path(path).parent_path();
    for (Texture texture : obj.textures) {
        if (!fs::path(texture.image.path).is_absolute()) {
            texture.image.path = (folder / texture.image.path).string();
        }
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

Result<std::shared_ptr<const ObjScene>> AssetCache::obj(const std::string& path) {
    auto& cached = objs_[path];
    if (!cached) {
        Result<ObjScene> loaded = loadObj(resolvePath(path, scenePath_));
        if (!loaded) {
            return loaded.error();
        }
        cached = std::make_shared<const ObjScene>(std::move(*loaded));
    }
    return cached;
}

Result<std::shared_ptr<const MeshData>> AssetCache::meshFile(const MeshSource& source) {
    if (!hasExtension(source.path, ".obj")) {
        return loadPly(resolvePath(source.path, scenePath_));
    }
    const auto scene = obj(source.path);
    if (!scene) {
        return scene.error();
    }
    const auto& parts = (*scene)->parts;
    if (source.part < 0) {
        return parts.size() == 1 ? parts.front().mesh : joinParts(parts);
    }
    if (static_cast<size_t>(source.part) >= parts.size()) {
        return Error{
            fmt::format("has {} parts; there is no part {} (they count from 0)", parts.size(), source.part),
            {resolvePath(source.path, scenePath_), 0, 0, ""}};
    }
    return parts[static_cast<size_t>(source.part)].mesh;
}

Result<std::shared_ptr<const MeshData>> AssetCache::mesh(const MeshSource& source) {
    const std::string key = fmt::format("{}\n{}\n{}\n{}\n{}", source.path, source.part, source.generator,
                                        source.triangles, source.seed);
    auto& cached = meshes_[key];
    if (!cached) {
        auto loaded = source.generator.empty() ? meshFile(source) : generateMesh(source);
        if (!loaded) {
            return loaded.error();
        }
        cached = std::move(*loaded);
    }
    return cached;
}

Result<ImageSource> AssetCache::texture(const std::string& path) {
    if (const auto found = textures_.find(path); found != textures_.end()) {
        return found->second;
    }
    Result<ImageSource> image = loadImage(resolvePath(path, scenePath_));
    if (image) {
        image->path = path;
        textures_[path] = *image;
    }
    return image;
}

Result<ImageSource> AssetCache::environment(const std::string& path) {
    auto image = loadImageF(resolvePath(path, scenePath_));
    if (!image) {
        return image.error();
    }
    ImageSource source;
    source.path = path;
    source.floats = std::move(*image);
    return source;
}

}  // namespace glint
