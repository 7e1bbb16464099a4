// Tells kinds of scene files apart and hands them to their readers.
#include "engine/io/scene_loader.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/io/asset_cache.h"
#include "engine/io/atomic_file.h"
#include "engine/io/default_view.h"
#include "engine/io/scene_json.h"
#include "engine/io/scene_text.h"
#include "engine/io/text_source.h"
#include "engine/io/used_assets.h"
#include "engine/scene/stability_warnings.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxSceneBytes = size_t{256} << 20;

enum class SceneKind { Unknown, Json, Text, Obj, Ply };

SceneKind kindByExtension(const std::string& path) {
    std::string ending = fs::path(path).extension().string();
    for (char& c : ending) {
        c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    }
    return ending == ".json"  ? SceneKind::Json
           : ending == ".txt" ? SceneKind::Text
           : ending == ".obj" ? SceneKind::Obj
           : ending == ".ply" ? SceneKind::Ply
                              : SceneKind::Unknown;
}

/// By the first word of the file, for files whose name says nothing.
SceneKind kindByContent(const std::string& path) {
    char head[256] = {};
    std::ifstream file(path, std::ios::binary);
    file.read(head, sizeof head - 1);
    std::string_view text(head, static_cast<size_t>(file.gcount()));
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    const auto begins = [text](std::initializer_list<std::string_view> words) {
        for (const std::string_view word : words) {
            if (text.starts_with(word)) { return true; }
        }
        return false;
    };
    if (begins({"ply\n", "ply\r\n"})) { return SceneKind::Ply; }
    if (begins({"{", "//", "/*", "\xEF\xBB\xBF{"})) { return SceneKind::Json; }
    if (begins({"PerspectiveCamera", "Background", "Lights", "DiskLights", "Materials", "Group"})) {
        return SceneKind::Text;
    }
    return begins({"v ", "mtllib ", "o ", "g "}) ? SceneKind::Obj : SceneKind::Unknown;
}

Result<SceneDescription> loadObjScene(const std::string& path, const LoadOptions& options) {
    AssetCache assets(path, options.counts);
    const std::string name = fs::path(path).filename().string();
    const auto obj = assets.objWithMaterials(name);
    if (!obj) { return obj.error(); }
    SceneDescription scene;
    scene.path = path;
    scene.title = name;
    appendObj(**obj, name, {}, &scene);
    if (Status read = readUsedAssets(&assets, &scene); !read) { return read.error(); }
    applyDefaultView(&scene);
    return scene;
}

Result<SceneDescription> loadPlyScene(const std::string& path, const LoadOptions& options) {
    AssetCache assets(path, options.counts);
    SceneDescription scene;
    scene.path = path;
    scene.title = fs::path(path).filename().string();
    Object object;
    object.name = scene.title;
    object.shape = ShapeKind::Mesh;
    object.mesh = 0;
    scene.objects.push_back(std::move(object));
    Mesh& whole = scene.meshes.emplace_back();
    whole.name = scene.title;
    whole.source.path = scene.title;
    if (Status read = readUsedAssets(&assets, &scene); !read) { return read.error(); }
    applyDefaultView(&scene);
    return scene;
}

Result<SceneDescription> loadTextual(const std::string& path, SceneKind kind, const LoadOptions& options) {
    auto source = readTextFile(path, kMaxSceneBytes);
    if (!source) { return source.error(); }
    if (source->text.find_first_not_of(" \t\r\n") == std::string::npos) {
        return Error{"is empty; expected a scene", {path, 0, 0, ""}};
    }
    return kind == SceneKind::Json ? readSceneJson(std::move(*source), options)
                                   : readSceneText(std::move(*source), options);
}

Result<SceneDescription> loadByKind(const std::string& path, const LoadOptions& options) {
    if (Status regular = checkRegularFile(path, "a scene file"); !regular) { return regular.error(); }
    const SceneKind named = kindByExtension(path);
    const SceneKind kind = named != SceneKind::Unknown ? named : kindByContent(path);
    switch (kind) {
        case SceneKind::Json:
        case SceneKind::Text:
            return loadTextual(path, kind, options);
        case SceneKind::Obj:
            return loadObjScene(path, options);
        case SceneKind::Ply:
            return loadPlyScene(path, options);
        case SceneKind::Unknown:
            break;
    }
    return Error{
        "is not a scene Glint knows; expected Glint JSON (.json), a 6.837 text scene (.txt), OBJ (.obj) or "
        "PLY "
        "(.ply)",
        {path, 0, 0, ""}};
}

}  // namespace

Result<SceneDescription> loadScene(const std::string& path, const LoadOptions& options) {
    auto scene = loadByKind(path, options);
    if (scene) {
        std::vector<std::string> limits = stabilityWarnings(*scene);
        std::move(limits.begin(), limits.end(), std::back_inserter(scene->warnings));
    }
    return scene;
}

}  // namespace glint
