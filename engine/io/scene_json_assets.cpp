// Glint JSON: meshes and images are read last, when it is known what uses them; the places of their names are
// kept for messages.
#include <fmt/format.h>

#include "engine/io/scene_json_reader.h"

namespace glint {

void SceneJsonReader::readAssets() {
    if (errors_.failed()) { return; }
    checkIdleAssets();
    readUsedAssets(&assets_, &scene_, [&](const Asset& asset, const Error& error) {
        const std::string file = assetFile(scene_, asset);
        if (asset.kind == AssetKind::Texture && broughtTextures_.contains(asset.index)) {
            remarkUnreadImage(asset, error, &scene_, &remarks_);
        } else if (file.empty()) {
            errors_.add(placeOf(asset), error.message);
        } else {
            reportFile(placeOf(asset), file, error);
        }
        return !errors_.failed();
    });
    const std::vector<std::string> lines = remarks_.lines();
    scene_.warnings.insert(scene_.warnings.end(), lines.begin(), lines.end());
}

void SceneJsonReader::checkIdleAssets() {
    for (const Asset& asset : idleAssets(scene_)) {
        const std::string file = assetFile(scene_, asset);
        if (!file.empty() && !fileExists(resolvePath(file, assets_.scenePath()))) {
            remark(placeOf(asset), "files are missing that nothing uses", file);
        }
    }
}

const JsonValue& SceneJsonReader::placeOf(const Asset& asset) const {
    switch (asset.kind) {
        case AssetKind::Mesh:
            return meshPlaces_[asset.index];
        case AssetKind::Texture:
            return texturePlaces_[asset.index];
        case AssetKind::Environment:
            break;
    }
    return environmentPlace_;
}

void SceneJsonReader::reportFile(const JsonValue& at, const std::string& path, const Error& error) {
    const std::string resolved = resolvePath(path, assets_.scenePath());
    if (fileExists(resolved)) {
        errors_.add(error);  // It is there but broken: its own place says more.
    } else if (options_.allowMissing) {
        remark(at, "files are missing and left out", path);
    } else {
        errors_.add(at,
                    fmt::format("the file \"{}\" cannot be read: {} (looked for {}); --allow-missing goes on "
                                "without it",
                                path, error.message, resolved));
    }
}

void SceneJsonReader::remark(const JsonValue& at, std::string_view kind, std::string_view detail) {
    const auto place = [&] {
        const SourcePlace found = at.error("").place;
        return fmt::format("{}:{}", found.file, found.line);
    };
    remarks_.add(kind, place, detail);
}

}  // namespace glint
